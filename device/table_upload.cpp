#include "device/table_upload.h"

#include "engine/exports/device_image.h"

#include <algorithm>

namespace driftbench {

namespace {

// Shares of the way, by how long each takes: a chunk out, a chunk back.
constexpr double kActivated = 0.92;

Error cancelled()
{
    return {Errc::Cancelled, "The upload was cancelled; the device goes on with the table that it had."};
}

// Refused here already, where the sentence can say more than a result code.
Status checkFits(const BridgeInfo &info, std::span<const std::uint8_t> bytes)
{
    const auto image = decodeDeviceImage(bytes, "the table");
    if (!image)
        return image.error();
    const SensorIdentity &sensor = image->table.provenance.sensor;
    if (sensor.model != info.sensor.model || sensor.serial != info.sensor.serial)
        return Error{Errc::WrongSensor, "The table is for " + sensor.text() + ", the device has " +
                                            info.sensor.text() + "; upload a table of this sensor."};
    const bool fixed = image->kind() == DeviceTableKind::FixedPoint;
    if (!info.can(fixed ? BRIDGE_CAN_FIXED : BRIDGE_CAN_FLOAT))
        return Error{Errc::DeviceRefused, std::string("The device takes no tables in ") +
                                              (fixed ? "fixed point" : "floating point") +
                                              "; export the table in the other kind."};
    if (image->thermometer == DeviceThermometer::External && !info.can(BRIDGE_CAN_EXTERNAL))
        return Error{Errc::DeviceRefused,
                     "The table is for an external thermometer, which the device does not "
                     "have; record and train with the one on the die."};
    if (bytes.size() > info.bankBytes)
        return Error{Errc::DeviceRefused, "The table has " + std::to_string(bytes.size()) +
                                              " bytes, a bank of the device " +
                                              std::to_string(info.bankBytes) +
                                              "; allow a larger interpolation error to have fewer knots."};
    return {};
}

// Differs from one upload of a program to the next, and from one table to another.
std::uint16_t transactionOf(std::uint32_t crc, const BridgeStatus &before)
{
    const std::uint32_t generations = before.banks[0].generation + 31U * before.banks[1].generation;
    const auto mixed = static_cast<std::uint16_t>((crc ^ (crc >> 16U)) + generations);
    return mixed == 0 ? std::uint16_t{1} : mixed;
}

Status write(BridgeClient &client, std::span<const std::uint8_t> image, std::uint16_t transaction,
             const ProgressHook &hook)
{
    for (std::size_t offset = 0; offset < image.size(); offset += BRIDGE_CHUNK_BYTES) {
        const double part = static_cast<double>(offset) / static_cast<double>(image.size());
        if (report(hook, "writing the table", kUploadWritten * part) == Flow::Stop)
            return cancelled();
        const auto chunk =
            image.subspan(offset, std::min<std::size_t>(BRIDGE_CHUNK_BYTES, image.size() - offset));
        if (const Status sent = client.sendChunk(transaction, static_cast<std::uint32_t>(offset), chunk);
            !sent)
            return sent;
    }
    return {};
}

// The bank that is being written: empty for the status, and yet it gives bytes.
Result<std::uint8_t> bankBeingWritten(BridgeClient &client)
{
    const auto status = client.status();
    if (!status)
        return status.error();
    for (std::uint8_t bank = 0; bank < BRIDGE_BANKS; ++bank) {
        if (status->activeBank == bank || status->banks[bank].state != BRIDGE_BANK_EMPTY)
            continue;
        const auto bytes = client.readBank(bank, 0, BRIDGE_READ_BYTES);
        if (!bytes)
            return bytes.error();
        if (!bytes->empty())
            return bank;
    }
    return Error{Errc::TableMismatch,
                 "The device took the table, but no bank gives it back; the table in use "
                 "has not changed, try again."};
}

// The bank that a commit has just made of this image: the youngest with its length and CRC.
std::optional<std::uint8_t> committedBank(const BridgeStatus &status, std::uint32_t bytes, std::uint32_t crc)
{
    std::optional<std::uint8_t> found;
    for (std::uint8_t bank = 0; bank < BRIDGE_BANKS; ++bank) {
        const BridgeBank &each = status.banks[bank];
        if (each.state == BRIDGE_BANK_COMMITTED && each.bytes == bytes && each.crc == crc &&
            (!found || each.generation > status.banks[*found].generation))
            found = bank;
    }
    return found;
}

Status compare(BridgeClient &client, std::span<const std::uint8_t> image, std::uint8_t bank,
               const ProgressHook &hook)
{
    bool stopped = false;
    const ProgressHook part = [&](const Progress &progress) {
        const Flow flow = report(hook, "reading the table back",
                                 kUploadWritten + (kUploadReadBack - kUploadWritten) * progress.fraction);
        stopped = flow == Flow::Stop;
        return flow;
    };
    const auto back = client.readImage(bank, static_cast<std::uint32_t>(image.size()), part);
    if (stopped)
        return cancelled();
    if (!back)
        return back.error();
    const auto differs = std::mismatch(image.begin(), image.end(), back->begin(), back->end());
    if (differs.first == image.end())
        return {};
    return Error{Errc::TableMismatch,
                 "Byte " + std::to_string(differs.first - image.begin()) +
                     " of the table reads back differently from what was written; the device "
                     "goes on with the table that it had, try again."};
}

Result<TableUploadReport> finish(BridgeClient &client, TableUploadReport upload)
{
    const auto after = client.status();
    if (!after && upload.rolledBack)
        return Error{after.error().code, after.error().message +
                                             " The new table had not passed the comparison and was rolled "
                                             "back before."};
    if (!after)
        return after.error();
    upload.after = *after;
    return upload;
}

// What counts in the end is what the device says that it uses.
Status activate(BridgeClient &client, const TableUploadReport &upload, const ProgressHook &hook)
{
    if (report(hook, "activating the table", kUploadCommitted) == Flow::Stop)
        return cancelled();
    if (const Status done = client.activateTable(upload.generation); !done)
        return done;
    const auto status = client.status();
    if (!status)
        return status.error();
    if (status->activeBank != upload.bank)
        return Error{Errc::TableMismatch,
                     "The device was told to use the new table and uses another; read its "
                     "status with driftbench-cli device info."};
    return {};
}

Error notCompared(const Error &why)
{
    return {why.code, why.message +
                          " The new table is in use, but its compensation was not compared: read the "
                          "device's status, and roll the table back if in doubt."};
}

// The comparison did not pass, and whether the device has gone back is not known.
Error rollbackCut(const Error &why)
{
    return {why.code, why.message +
                          " The new table did not pass the comparison, and the link broke while it was being "
                          "rolled back: it may still be in use; read the device's status, and roll it back "
                          "if it is."};
}

// The table is in use by now: it stays only if it does what the host would do.
Result<TableUploadReport> proveAtWork(BridgeClient &client, std::span<const std::uint8_t> image,
                                      TableUploadReport upload, const CompensationCheckOptions &options,
                                      const ProgressHook &hook)
{
    const auto decoded = decodeDeviceImage(image, "the table");
    if (!decoded)
        return decoded.error();
    const auto check = checkCompensation(client, *decoded, options, [&](const Progress &progress) {
        return report(hook, progress.stage, kActivated + (1.0 - kActivated) * progress.fraction);
    });
    if (check && check->passed()) {
        upload.check = *check;
        return upload;
    }
    if (!check && check.error().code == Errc::DeviceUnplugged)
        return notCompared(check.error());
    if (const Status undone = client.rollBackTable(upload.generation); !undone)
        return rollbackCut(undone.error());
    if (!check)
        return check.error().code == Errc::Cancelled
                   ? cancelled()
                   : Error{check.error().code, check.error().message + " The new table was rolled back."};
    upload.check = *check;
    upload.activated = false;
    upload.rolledBack = true;
    return upload;
}

Result<std::uint8_t> writeAndReadBack(BridgeClient &client, std::span<const std::uint8_t> image,
                                      std::uint16_t transaction, const ProgressHook &hook)
{
    if (const Status done = write(client, image, transaction, hook); !done)
        return done.error();
    const auto bank = bankBeingWritten(client);
    if (!bank)
        return bank.error();
    if (const Status same = compare(client, image, *bank, hook); !same)
        return same.error();
    return bank;
}

// The generation that the bank has now.
Result<std::uint32_t> verifyAndCommit(BridgeClient &client, std::uint16_t transaction,
                                      const TableUploadReport &upload, const ProgressHook &hook)
{
    if (report(hook, "verifying the table", kUploadReadBack) == Flow::Stop)
        return cancelled();
    if (const Status done = client.verifyTable(transaction); !done)
        return done.error();
    if (report(hook, "committing the table", kUploadVerified) == Flow::Stop)
        return cancelled();
    if (const Status done = client.commitTable(transaction); !done)
        return done.error();
    const auto status = client.status();
    if (!status)
        return status.error();
    if (committedBank(*status, upload.bytes, upload.crc) != upload.bank)
        return Error{Errc::TableMismatch,
                     "The device says that it committed the table, but the bank does not hold it; the "
                     "table in use has not changed, try again."};
    return status->banks[upload.bank].generation;
}

} // namespace

Result<TableUploadReport> uploadTable(BridgeClient &client, std::span<const std::uint8_t> image,
                                      const TableUploadOptions &options, const ProgressHook &hook)
{
    if (const Status fits = checkFits(client.info(), image); !fits)
        return fits.error();
    const auto before = client.status();
    if (!before)
        return before.error();
    TableUploadReport upload{*before, *before};
    upload.bytes = static_cast<std::uint32_t>(image.size());
    upload.crc = deviceImageCrc(image);
    const std::uint16_t transaction = transactionOf(upload.crc, *before);
    if (const Status done = client.beginTable(transaction, upload.bytes, upload.crc); !done)
        return done.error();
    const auto bank = writeAndReadBack(client, image, transaction, hook);
    if (!bank)
        return bank.error();
    upload.bank = *bank;
    const auto generation = verifyAndCommit(client, transaction, upload, hook);
    if (!generation)
        return generation.error();
    upload.generation = *generation;
    if (options.activate) {
        if (const Status done = activate(client, upload, hook); !done)
            return done.error();
        upload.activated = true;
        if (options.check && client.info().can(BRIDGE_CAN_PAIR)) {
            auto proven = proveAtWork(client, image, std::move(upload), options.checkOptions, hook);
            if (!proven)
                return proven.error();
            upload = *std::move(proven);
        }
    }
    auto finished = finish(client, std::move(upload));
    report(hook, "uploading the table", 1.0);
    return finished;
}

Result<TableRollbackReport> rollBackTable(BridgeClient &client)
{
    const auto before = client.status();
    if (!before)
        return before.error();
    if (!before->activeBank)
        return Error{Errc::DeviceRefused, "No table is in use on the device; there is nothing to roll back."};
    if (const Status done = client.rollBackTable(before->banks[*before->activeBank].generation); !done)
        return done.error();
    const auto after = client.status();
    if (!after)
        return after.error();
    return TableRollbackReport{*before, *after};
}

Result<std::optional<std::vector<std::uint8_t>>>
readTable(BridgeClient &client, std::optional<std::uint8_t> bank, const ProgressHook &hook)
{
    using Image = std::optional<std::vector<std::uint8_t>>;
    if (bank && *bank >= BRIDGE_BANKS)
        return Error{Errc::InvalidOption, "There is no bank " + std::to_string(*bank) + "; choose 0 or 1."};
    const auto status = client.status();
    if (!status)
        return status.error();
    if (!bank)
        bank = status->activeBank;
    if (!bank || status->banks[*bank].state == BRIDGE_BANK_EMPTY)
        return Image();
    auto image = client.readImage(*bank, status->banks[*bank].bytes, hook);
    if (!image)
        return image.error();
    if (deviceImageCrc(*image) != status->banks[*bank].crc)
        return Error{Errc::TableMismatch,
                     "Bank " + std::to_string(*bank) +
                         " does not read back with the CRC that the device states; try again."};
    return Image(*std::move(image));
}

} // namespace driftbench
