#include "device/i2c/cp2112_codec.h"

#include "device/i2c/report_bytes.h"

#include <cassert>

namespace driftbench::cp2112 {

namespace {

enum ReportId : std::uint8_t
{
    Config = 0x06,
    Read = 0x10,
    WriteRead = 0x11,
    Fetch = 0x12,
    Write = 0x14,
    StatusQuery = 0x15,
    Cancel = 0x17,
};

constexpr std::uint8_t kOwnAddress = 0x02; // the chip's default; nobody else is a master on this bus
constexpr std::uint16_t kTimeoutMs = 100;
// 0 would be "for ever": the chip would repeat an address that nobody answers until it is cancelled.
constexpr std::uint16_t kRetries = 1;

std::uint8_t high(std::size_t value)
{
    return static_cast<std::uint8_t>(value >> 8);
}

std::uint8_t low(std::size_t value)
{
    return static_cast<std::uint8_t>(value & 0xFF);
}

std::uint8_t onTheWire(std::uint8_t address)
{
    return static_cast<std::uint8_t>(address << 1);
}

Progress failureOf(std::uint8_t cause)
{
    switch (cause) {
    case 0: // address
    case 3: // read incomplete
    case 4: // write incomplete
        return Progress::NoAcknowledge;
    case 1: // bus not free
    case 2: // arbitration lost
        return Progress::BusNotFree;
    default:
        return Progress::Failed;
    }
}

} // namespace

Request configRequest(int kHz)
{
    assert(kHz >= kSlowestKHz && kHz <= kFastestKHz);
    const auto hz = static_cast<std::uint32_t>(kHz) * 1000;
    return {Config,
            static_cast<std::uint8_t>(hz >> 24),
            static_cast<std::uint8_t>(hz >> 16 & 0xFF),
            high(hz & 0xFFFF),
            low(hz),
            kOwnAddress,
            0, // send what was read only when asked
            high(kTimeoutMs),
            low(kTimeoutMs),
            high(kTimeoutMs),
            low(kTimeoutMs),
            1, // reset the bus when SCL is held low for 25 ms
            high(kRetries),
            low(kRetries)};
}

Request readRequest(std::uint8_t address, std::uint16_t length)
{
    return {Read, onTheWire(address), high(length), low(length)};
}

Request writeReadRequest(std::uint8_t address, std::span<const std::uint8_t> written, std::uint16_t length)
{
    assert(written.size() <= kLongestTarget);
    return reportOf({WriteRead, onTheWire(address), high(length), low(length), low(written.size())}, written);
}

Request writeRequest(std::uint8_t address, std::span<const std::uint8_t> bytes)
{
    assert(bytes.size() <= kDataPerReport);
    return reportOf({Write, onTheWire(address), low(bytes.size())}, bytes);
}

Request fetchRequest(std::uint16_t length)
{
    return {Fetch, high(length), low(length)};
}

Request statusRequest()
{
    return {StatusQuery, 1};
}

Request cancelRequest()
{
    return {Cancel, 1};
}

std::optional<StatusReply> decodeStatus(std::span<const std::uint8_t> report)
{
    if (report.size() < 7 || report[0] != kStatusResponse)
        return {};
    StatusReply reply;
    reply.bytes = static_cast<std::uint16_t>(report[5] << 8 | report[6]);
    switch (report[1]) {
    case 0:
        reply.progress = Progress::Idle;
        return reply;
    case 1:
        reply.progress = Progress::Busy;
        return reply;
    case 2:
        reply.progress = Progress::Complete;
        return reply;
    case 3:
        reply.progress = failureOf(report[2]);
        return reply;
    default:
        return {};
    }
}

std::optional<std::span<const std::uint8_t>> decodeData(std::span<const std::uint8_t> report)
{
    if (report.size() < 3 || report[0] != kReadResponse)
        return {};
    const std::size_t count = report[2];
    if (count > kDataPerReport || 3 + count > report.size())
        return {};
    return report.subspan(3, count);
}

} // namespace driftbench::cp2112
