#include "device/bridge/bridge_codec.h"

#include <algorithm>
#include <cassert>

namespace driftbench {

namespace {

using Bytes = std::span<const std::uint8_t>;

std::string hex(std::uint8_t value)
{
    constexpr char kDigits[] = "0123456789abcdef";
    return {'0', 'x', kDigits[value >> 4], kDigits[value & 0xF]};
}

Error damaged(std::string_view report, std::size_t byte, const std::string &value, const std::string &allowed)
{
    return {Errc::DamagedReport, "The " + std::string(report) + " report of the bridge is damaged: byte " +
                                     std::to_string(byte) + " holds " + value + ", which must be " + allowed +
                                     "."};
}

Status checkReport(Bytes report, std::uint8_t id, std::string_view name)
{
    if (report.size() < BRIDGE_REPORT_SIZE)
        return Error{Errc::DamagedReport, "The " + std::string(name) + " report of the bridge is damaged: " +
                                              std::to_string(report.size()) + " bytes came instead of " +
                                              std::to_string(BRIDGE_REPORT_SIZE) + "."};
    if (report[0] != id)
        return damaged(name, 0, hex(report[0]), hex(id));
    return {};
}

// Letters without spaces up to the first 0 or the end of the field, as an image names its sensor.
Result<std::string> text(Bytes report, std::size_t at, std::size_t size)
{
    std::string letters;
    for (std::size_t byte = at; byte < at + size && report[byte] != 0; ++byte) {
        if (report[byte] <= 0x20 || report[byte] >= 0x7F)
            return damaged("info", byte, hex(report[byte]), "a printable ASCII letter");
        letters += static_cast<char>(report[byte]);
    }
    return letters;
}

Result<bool> flagAt(Bytes report, std::size_t byte)
{
    if (report[byte] > 1)
        return damaged("configuration", byte, hex(report[byte]), "0 or 1");
    return report[byte] == 1;
}

Status decodeRanges(Bytes report, BridgeInfo &info)
{
    const std::size_t count = report[BRIDGE_INFO_RANGES];
    if (count < 1 || count > BRIDGE_RANGES)
        return damaged("info", BRIDGE_INFO_RANGES, std::to_string(count),
                       "1 to " + std::to_string(BRIDGE_RANGES));
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = BRIDGE_INFO_RANGE_TABLE + i * BRIDGE_RANGE_SIZE;
        const BridgeRange range{bridge_get_u16(&report[at]), bridge_get_u16(&report[at + 2])};
        if (range.sensitivity == 0)
            return damaged("info", at + 2, "0", "a sensitivity");
        info.ranges.push_back(range);
    }
    return {};
}

BridgeReport reportOf(std::uint8_t id)
{
    BridgeReport report{};
    report[0] = id;
    return report;
}

BridgeReport transactionReport(std::uint8_t id, std::size_t at, std::uint16_t transaction)
{
    BridgeReport report = reportOf(id);
    bridge_put_u16(&report[at], transaction);
    return report;
}

BridgeReport generationReport(std::uint8_t id, std::size_t at, std::uint32_t generation)
{
    BridgeReport report = reportOf(id);
    bridge_put_u32(&report[at], generation);
    return report;
}

} // namespace

std::string BridgeInfo::firmwareText() const
{
    return std::to_string(firmware[0]) + '.' + std::to_string(firmware[1]) + '.' +
           std::to_string(firmware[2]);
}

Result<BridgeInfo> decodeBridgeInfo(Bytes report)
{
    if (const Status ok = checkReport(report, BRIDGE_REPORT_INFO, "info"); !ok)
        return ok.error();
    BridgeInfo info;
    info.major = report[BRIDGE_INFO_MAJOR];
    info.minor = report[BRIDGE_INFO_MINOR];
    // All other bytes have a meaning only in a version that is known here.
    if (info.major != BRIDGE_PROTOCOL_MAJOR)
        return Error{Errc::ProtocolVersion,
                     "The bridge speaks version " + std::to_string(info.major) + '.' +
                         std::to_string(info.minor) + " of the protocol and this program version " +
                         std::to_string(BRIDGE_PROTOCOL_MAJOR) + "; update the older of the two."};
    info.capabilities = report[BRIDGE_INFO_CAPABILITIES];
    std::copy_n(&report[BRIDGE_INFO_FIRMWARE], info.firmware.size(), info.firmware.begin());
    auto model = text(report, BRIDGE_INFO_MODEL, BRIDGE_MODEL_SIZE);
    if (!model)
        return model.error();
    auto serial = text(report, BRIDGE_INFO_SERIAL, BRIDGE_SERIAL_SIZE);
    if (!serial)
        return serial.error();
    info.sensor = {*std::move(model), *std::move(serial)};
    info.lowestRateMilliHz = bridge_get_u32(&report[BRIDGE_INFO_MIN_RATE]);
    info.highestRateMilliHz = bridge_get_u32(&report[BRIDGE_INFO_MAX_RATE]);
    info.bankBytes = bridge_get_u32(&report[BRIDGE_INFO_BANK_BYTES]);
    if (info.lowestRateMilliHz == 0)
        return damaged("info", BRIDGE_INFO_MIN_RATE, "0", "a sampling rate");
    if (info.highestRateMilliHz < info.lowestRateMilliHz)
        return damaged("info", BRIDGE_INFO_MAX_RATE, std::to_string(info.highestRateMilliHz),
                       std::to_string(info.lowestRateMilliHz) + " or more");
    if (const Status ok = decodeRanges(report, info); !ok)
        return ok.error();
    return info;
}

Result<BridgeConfig> decodeBridgeConfig(Bytes report)
{
    if (const Status ok = checkReport(report, BRIDGE_REPORT_CONFIG, "configuration"); !ok)
        return ok.error();
    if (report[BRIDGE_CONFIG_RANGE] >= BRIDGE_RANGES)
        return damaged("configuration", BRIDGE_CONFIG_RANGE, std::to_string(report[BRIDGE_CONFIG_RANGE]),
                       "below " + std::to_string(BRIDGE_RANGES));
    const auto stream = flagAt(report, BRIDGE_CONFIG_STREAM);
    if (!stream)
        return stream.error();
    const auto compensate = flagAt(report, BRIDGE_CONFIG_COMPENSATE);
    if (!compensate)
        return compensate.error();
    const auto pair = flagAt(report, BRIDGE_CONFIG_PAIR);
    if (!pair)
        return pair.error();
    return BridgeConfig{bridge_get_u32(&report[BRIDGE_CONFIG_RATE]), report[BRIDGE_CONFIG_RANGE], *stream,
                        *compensate, *pair};
}

Result<BridgeStatus> decodeBridgeStatus(Bytes report)
{
    if (const Status ok = checkReport(report, BRIDGE_REPORT_STATUS, "status"); !ok)
        return ok.error();
    BridgeStatus status;
    status.command = report[BRIDGE_STATUS_COMMAND];
    status.result = report[BRIDGE_STATUS_RESULT];
    const std::uint8_t active = report[BRIDGE_STATUS_ACTIVE];
    if (active != BRIDGE_NO_BANK && active >= BRIDGE_BANKS)
        return damaged("status", BRIDGE_STATUS_ACTIVE, std::to_string(active), "0, 1 or 255");
    if (active != BRIDGE_NO_BANK)
        status.activeBank = active;
    status.producedSamples = bridge_get_u32(&report[BRIDGE_STATUS_PRODUCED]);
    status.droppedSamples = bridge_get_u32(&report[BRIDGE_STATUS_DROPPED]);
    status.receivedBytes = bridge_get_u32(&report[BRIDGE_STATUS_RECEIVED]);
    for (std::size_t i = 0; i < BRIDGE_BANKS; ++i) {
        const std::size_t at = BRIDGE_STATUS_BANKS + i * BRIDGE_STATUS_BANK_SIZE;
        status.banks[i] = {report[BRIDGE_STATUS_BANK_STATES + i], bridge_get_u32(&report[at]),
                           bridge_get_u32(&report[at + 4]), bridge_get_u32(&report[at + 8])};
    }
    return status;
}

Result<BridgeSamples> decodeBridgeSamples(Bytes report)
{
    if (const Status ok = checkReport(report, BRIDGE_REPORT_SAMPLES, "sample"); !ok)
        return ok.error();
    BridgeSamples samples;
    samples.count = report[BRIDGE_SAMPLES_COUNT];
    if (samples.count < 1 || samples.count > static_cast<int>(BRIDGE_SAMPLES_PER_REPORT))
        return damaged("sample", BRIDGE_SAMPLES_COUNT, std::to_string(samples.count),
                       "1 to " + std::to_string(BRIDGE_SAMPLES_PER_REPORT));
    samples.flags = report[BRIDGE_SAMPLES_FLAGS];
    samples.saturated = report[BRIDGE_SAMPLES_SATURATED];
    if ((samples.saturated >> samples.count) != 0)
        return damaged("sample", BRIDGE_SAMPLES_SATURATED, hex(samples.saturated),
                       "about the " + std::to_string(samples.count) + " samples of the report");
    samples.sequence = bridge_get_u16(&report[BRIDGE_SAMPLES_SEQUENCE]);
    samples.timeUs = bridge_get_u32(&report[BRIDGE_SAMPLES_TIME]);
    samples.intervalNs = bridge_get_u32(&report[BRIDGE_SAMPLES_INTERVAL]);
    if ((samples.intervalNs == 0) != (samples.count == 1))
        return damaged("sample", BRIDGE_SAMPLES_INTERVAL, std::to_string(samples.intervalNs),
                       samples.count == 1 ? "0 with one sample" : "more than 0 with several samples");
    if (samples.has(BRIDGE_FLAG_DIE_VALID))
        samples.dieMilliC = bridge_get_i32(&report[BRIDGE_SAMPLES_DIE_MILLIC]);
    if (samples.has(BRIDGE_FLAG_EXTERNAL_VALID))
        samples.externalMilliC = bridge_get_i32(&report[BRIDGE_SAMPLES_EXTERNAL_MILLIC]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            samples.counts[i][axis] =
                bridge_get_i16(&report[BRIDGE_SAMPLES_RATES + i * BRIDGE_SAMPLE_SIZE + 2 * axis]);
    }
    return samples;
}

Result<BridgeTablePart> decodeBridgeTablePart(Bytes report)
{
    if (const Status ok = checkReport(report, BRIDGE_REPORT_READ, "table"); !ok)
        return ok.error();
    const std::uint8_t length = report[BRIDGE_READ_LENGTH];
    if (report[BRIDGE_READ_BANK] >= BRIDGE_BANKS)
        return damaged("table", BRIDGE_READ_BANK, std::to_string(report[BRIDGE_READ_BANK]), "0 or 1");
    if (length > BRIDGE_READ_BYTES)
        return damaged("table", BRIDGE_READ_LENGTH, std::to_string(length),
                       std::to_string(BRIDGE_READ_BYTES) + " or less");
    const Bytes data = report.subspan(BRIDGE_READ_DATA, length);
    return BridgeTablePart{
        report[BRIDGE_READ_BANK], bridge_get_u32(&report[BRIDGE_READ_OFFSET]), {data.begin(), data.end()}};
}

BridgeReport encodeBridgeConfig(const BridgeConfig &config)
{
    BridgeReport report = reportOf(BRIDGE_REPORT_CONFIG);
    bridge_put_u32(&report[BRIDGE_CONFIG_RATE], config.rateMilliHz);
    report[BRIDGE_CONFIG_RANGE] = config.range;
    report[BRIDGE_CONFIG_STREAM] = config.stream ? 1 : 0;
    report[BRIDGE_CONFIG_COMPENSATE] = config.compensate ? 1 : 0;
    report[BRIDGE_CONFIG_PAIR] = config.pair ? 1 : 0;
    return report;
}

BridgeReport encodeBridgeBegin(std::uint16_t transaction, std::uint32_t bytes, std::uint32_t crc)
{
    BridgeReport report = transactionReport(BRIDGE_REPORT_BEGIN, BRIDGE_BEGIN_TRANSACTION, transaction);
    bridge_put_u32(&report[BRIDGE_BEGIN_BYTES], bytes);
    bridge_put_u32(&report[BRIDGE_BEGIN_CRC], crc);
    return report;
}

BridgeReport encodeBridgeChunk(std::uint16_t transaction, std::uint32_t offset, Bytes bytes)
{
    assert(!bytes.empty() && bytes.size() <= BRIDGE_CHUNK_BYTES);
    BridgeReport report = transactionReport(BRIDGE_REPORT_CHUNK, BRIDGE_CHUNK_TRANSACTION, transaction);
    bridge_put_u32(&report[BRIDGE_CHUNK_OFFSET], offset);
    report[BRIDGE_CHUNK_LENGTH] = static_cast<std::uint8_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), report.begin() + BRIDGE_CHUNK_DATA);
    return report;
}

BridgeReport encodeBridgeRead(std::uint8_t bank, std::uint32_t offset, std::uint8_t length)
{
    assert(length >= 1 && length <= BRIDGE_READ_BYTES);
    BridgeReport report = reportOf(BRIDGE_REPORT_READ);
    report[BRIDGE_READ_BANK] = bank;
    bridge_put_u32(&report[BRIDGE_READ_OFFSET], offset);
    report[BRIDGE_READ_LENGTH] = length;
    return report;
}

BridgeReport encodeBridgeVerify(std::uint16_t transaction)
{
    return transactionReport(BRIDGE_REPORT_VERIFY, BRIDGE_VERIFY_TRANSACTION, transaction);
}

BridgeReport encodeBridgeCommit(std::uint16_t transaction)
{
    return transactionReport(BRIDGE_REPORT_COMMIT, BRIDGE_COMMIT_TRANSACTION, transaction);
}

BridgeReport encodeBridgeActivate(std::uint32_t generation)
{
    return generationReport(BRIDGE_REPORT_ACTIVATE, BRIDGE_ACTIVATE_GENERATION, generation);
}

BridgeReport encodeBridgeRollback(std::uint32_t generation)
{
    return generationReport(BRIDGE_REPORT_ROLLBACK, BRIDGE_ROLLBACK_GENERATION, generation);
}

} // namespace driftbench
