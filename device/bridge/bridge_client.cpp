#include "device/bridge/bridge_client.h"

#include <algorithm>

namespace driftbench {

namespace {

constexpr double kPatienceS = 0.5;
constexpr double kLongPatienceS = 2.0; // erasing a bank and reading it back take time
constexpr double kPollS = 0.002;
constexpr int kTries = 3;

Result<BridgeReport> getReport(HidTransport &transport, std::uint8_t id)
{
    // A byte more than a report has: longer ones must not look like whole ones that were cut.
    std::array<std::uint8_t, BRIDGE_REPORT_SIZE + 1> bytes{};
    bytes[0] = id;
    const auto length = transport.getFeature(bytes);
    if (!length)
        return length.error();
    if (*length < BRIDGE_REPORT_SIZE)
        return Error{Errc::DamagedReport, "The bridge answered report " + std::to_string(id) + " with " +
                                              std::to_string(*length) + " bytes instead of " +
                                              std::to_string(BRIDGE_REPORT_SIZE) +
                                              "; it may not be a native gyro bridge."};
    BridgeReport report;
    std::copy_n(bytes.begin(), report.size(), report.begin());
    return report;
}

Result<bool> always(const BridgeStatus &)
{
    return true;
}

} // namespace

Result<BridgeClient> BridgeClient::open(std::unique_ptr<HidTransport> transport, HostClock &clock)
{
    const auto report = getReport(*transport, BRIDGE_REPORT_INFO);
    if (!report)
        return report.error();
    auto info = decodeBridgeInfo(*report);
    if (!info)
        return info.error();
    return BridgeClient(std::move(transport), clock, *std::move(info));
}

std::string BridgeClient::name() const
{
    const std::string &serial = m_info.sensor.serial.empty() ? identity().serial : m_info.sensor.serial;
    return serial.empty() ? "native bridge at " + identity().path : "native bridge " + serial;
}

Result<BridgeStatus> BridgeClient::status()
{
    const auto report = getReport(*m_transport, BRIDGE_REPORT_STATUS);
    if (!report)
        return report.error();
    return decodeBridgeStatus(*report);
}

Result<BridgeConfig> BridgeClient::config()
{
    const auto report = getReport(*m_transport, BRIDGE_REPORT_CONFIG);
    if (!report)
        return report.error();
    return decodeBridgeConfig(*report);
}

Error BridgeClient::refusal(std::uint8_t command)
{
    const Errc code = m_lastResult == BRIDGE_RESULT_OTHER_SENSOR ? Errc::WrongSensor
                      : m_lastResult == BRIDGE_RESULT_BAD_CRC    ? Errc::TableMismatch
                                                                 : Errc::DeviceRefused;
    return {code, "The bridge refused to " + bridgeCommandText(command) + ": " +
                      bridgeResultText(m_lastResult) + "."};
}

// What became of the command; nothing as long as the status is not about it.
Result<std::optional<Status>> BridgeClient::answer(std::uint8_t command, const Done &done)
{
    const auto now = status();
    if (!now)
        return now.error();
    if (now->command != command)
        return std::optional<Status>();
    if (now->result != BRIDGE_RESULT_OK) {
        m_lastResult = now->result;
        return std::optional<Status>(refusal(command));
    }
    const auto isDone = done(*now);
    if (!isDone)
        return isDone.error();
    if (!*isDone)
        return std::optional<Status>();
    m_lastResult = BRIDGE_RESULT_OK;
    return std::optional<Status>(Status());
}

Status BridgeClient::command(const BridgeReport &report, double patienceS, const Done &done)
{
    for (int attempt = 0; attempt < kTries; ++attempt) {
        const Status sent = m_transport->sendFeature(report);
        if (!sent && sent.error().code != Errc::DeviceRefused && sent.error().code != Errc::DeviceSilent)
            return sent;
        const double endS = m_clock->nowS() + patienceS;
        for (;;) {
            const auto outcome = answer(report[0], done);
            if (!outcome)
                return outcome.error();
            if (*outcome)
                return **outcome;
            if (!sent && sent.error().code == Errc::DeviceRefused)
                return sent;
            if (m_clock->nowS() >= endS)
                break;
            m_clock->waitS(kPollS);
        }
    }
    return Error{Errc::DeviceSilent, "The bridge was asked " + std::to_string(kTries) + " times to " +
                                         bridgeCommandText(report[0]) +
                                         " and did nothing; unplug it and plug it in again."};
}

Status BridgeClient::configure(const BridgeConfig &asked)
{
    // Two configurations in a row look alike in the status; only reading it back tells them apart.
    return command(encodeBridgeConfig(asked), kPatienceS, [&](const BridgeStatus &) -> Result<bool> {
        const auto now = config();
        if (!now)
            return now.error();
        return *now == asked;
    });
}

Status BridgeClient::beginTable(std::uint16_t transaction, std::uint32_t bytes, std::uint32_t crc)
{
    return command(encodeBridgeBegin(transaction, bytes, crc), kPatienceS, always);
}

Status BridgeClient::sendChunk(std::uint16_t transaction, std::uint32_t offset,
                               std::span<const std::uint8_t> bytes)
{
    return command(
        encodeBridgeChunk(transaction, offset, bytes), offset == 0 ? kLongPatienceS : kPatienceS,
        [&](const BridgeStatus &now) -> Result<bool> { return now.receivedBytes >= offset + bytes.size(); });
}

Status BridgeClient::verifyTable(std::uint16_t transaction)
{
    return command(encodeBridgeVerify(transaction), kLongPatienceS, always);
}

Status BridgeClient::commitTable(std::uint16_t transaction)
{
    return command(encodeBridgeCommit(transaction), kPatienceS, always);
}

Status BridgeClient::activateTable(std::uint32_t generation)
{
    return command(encodeBridgeActivate(generation), kPatienceS,
                   [generation](const BridgeStatus &now) -> Result<bool> {
                       return now.activeBank && now.banks[*now.activeBank].generation == generation;
                   });
}

Status BridgeClient::rollBackTable(std::uint32_t generation)
{
    return command(encodeBridgeRollback(generation), kPatienceS,
                   [generation](const BridgeStatus &now) -> Result<bool> {
                       return !now.activeBank || now.banks[*now.activeBank].generation != generation;
                   });
}

Result<std::vector<std::uint8_t>> BridgeClient::readBank(std::uint8_t bank, std::uint32_t offset,
                                                         std::uint8_t length)
{
    std::vector<std::uint8_t> bytes;
    const auto fetch = [&](const BridgeStatus &) -> Result<bool> {
        const auto report = getReport(*m_transport, BRIDGE_REPORT_READ);
        if (!report)
            return report.error();
        auto part = decodeBridgeTablePart(*report);
        if (!part)
            return part.error();
        bytes = std::move(part->bytes);
        return part->bank == bank && part->offset == offset;
    };
    if (const Status ok = command(encodeBridgeRead(bank, offset, length), kPatienceS, fetch); !ok)
        return ok.error();
    if (!bytes.empty())
        return bytes;
    // Nothing came: past the end, or the flash refused to give, which the status says only now.
    const auto outcome = answer(BRIDGE_REPORT_READ, always);
    if (!outcome)
        return outcome.error();
    if (*outcome && !**outcome)
        return (*outcome)->error();
    return bytes;
}

Result<std::vector<std::uint8_t>> BridgeClient::readImage(std::uint8_t bank, std::uint32_t bytes,
                                                          const ProgressHook &hook)
{
    std::vector<std::uint8_t> image;
    while (image.size() < bytes) {
        if (report(hook, "reading the table", static_cast<double>(image.size()) / bytes) == Flow::Stop)
            return Error{Errc::Cancelled, "Reading the table was cancelled."};
        const std::size_t left = bytes - image.size();
        const auto part = readBank(bank, static_cast<std::uint32_t>(image.size()),
                                   static_cast<std::uint8_t>(std::min<std::size_t>(left, BRIDGE_READ_BYTES)));
        if (!part)
            return part.error();
        if (part->empty())
            return Error{Errc::TableMismatch, "Bank " + std::to_string(bank) + " of the bridge holds " +
                                                  std::to_string(image.size()) +
                                                  " bytes of a table and not " + std::to_string(bytes) +
                                                  "; upload the table again."};
        image.insert(image.end(), part->begin(), part->end());
    }
    return image;
}

} // namespace driftbench
