#include "device/i2c/mcp2221a_codec.h"

#include <algorithm>
#include <cassert>

namespace driftbench::mcp2221a {

namespace {

// In a request the report begins after the id.
constexpr std::size_t kBody = 1;
constexpr std::size_t kDataAt = 4;

constexpr std::uint8_t kCancel = 0x10;
constexpr std::uint8_t kSetSpeed = 0x20;
constexpr std::uint8_t kSucceeded = 0x00;
constexpr std::uint8_t kNotReady = 0x41;
constexpr std::uint8_t kReadPartial = 0x54;
constexpr std::uint8_t kReadComplete = 0x55;
constexpr std::uint8_t kReadFailed = 127; // in the place of the number of bytes

constexpr std::size_t kSpeedAt = 3;
constexpr std::size_t kEngineAt = 8;
constexpr std::size_t kAcknowledgeAt = 20;
constexpr std::uint8_t kNotAcknowledged = 0x40;
constexpr std::size_t kSclAt = 22;
constexpr std::size_t kSdaAt = 23;

Request requestOf(Command command)
{
    Request request{};
    request[kBody] = static_cast<std::uint8_t>(command);
    return request;
}

Engine engineOf(std::uint8_t state)
{
    switch (state) {
    case 0x00:
        return Engine::Idle;
    case 0x12: // start
    case 0x17: // repeated start
    case 0x23: // address
    case 0x44: // data written
    case 0x52: // data read
    case 0x62: // stop
        return Engine::TimedOut;
    case 0x25:
        return Engine::NoAcknowledge;
    case 0x45: // written, no stop
    case kReadPartial:
    case kReadComplete:
        return Engine::Waiting;
    default:
        return Engine::Working;
    }
}

bool answers(std::span<const std::uint8_t> report, Command command, std::size_t size)
{
    return report.size() >= size && report[0] == static_cast<std::uint8_t>(command);
}

} // namespace

Request statusRequest()
{
    return requestOf(Command::Status);
}

Request cancelRequest()
{
    Request request = requestOf(Command::Status);
    request[kBody + 2] = kCancel;
    return request;
}

Request speedRequest(int kHz)
{
    assert(kHz >= kSlowestKHz && kHz <= kFastestKHz);
    Request request = requestOf(Command::Status);
    request[kBody + 3] = kSetSpeed;
    request[kBody + 4] = static_cast<std::uint8_t>(12000 / kHz - 3);
    return request;
}

Request getDataRequest()
{
    return requestOf(Command::GetData);
}

Request writeRequest(Command command, std::uint8_t address, std::span<const std::uint8_t> bytes)
{
    assert(bytes.size() <= kDataPerReport);
    Request request = readRequest(command, address, static_cast<std::uint16_t>(bytes.size()));
    std::copy(bytes.begin(), bytes.end(), request.begin() + kBody + kDataAt);
    return request;
}

Request readRequest(Command command, std::uint8_t address, std::uint16_t length)
{
    Request request = requestOf(command);
    request[kBody + 1] = static_cast<std::uint8_t>(length & 0xFF);
    request[kBody + 2] = static_cast<std::uint8_t>(length >> 8);
    request[kBody + 3] = static_cast<std::uint8_t>(address << 1);
    return request;
}

std::optional<StatusReply> decodeStatus(std::span<const std::uint8_t> report)
{
    if (!answers(report, Command::Status, kSdaAt + 1) || report[1] != kSucceeded)
        return {};
    StatusReply reply;
    reply.engine = (report[kAcknowledgeAt] & kNotAcknowledged) != 0 ? Engine::NoAcknowledge
                                                                    : engineOf(report[kEngineAt]);
    reply.speedSet = report[kSpeedAt] == kSetSpeed;
    reply.sclHigh = report[kSclAt] != 0;
    reply.sdaHigh = report[kSdaAt] != 0;
    return reply;
}

std::optional<bool> decodeAccepted(std::span<const std::uint8_t> report, Command command)
{
    if (!answers(report, command, 2))
        return {};
    return report[1] == kSucceeded;
}

std::optional<DataReply> decodeData(std::span<const std::uint8_t> report)
{
    if (!answers(report, Command::GetData, kDataAt))
        return {};
    DataReply reply;
    reply.engine = engineOf(report[2]);
    if (report[1] == kNotReady) {
        reply.state = DataReply::State::NotReady;
        return reply;
    }
    const std::size_t count = report[3];
    if (report[1] != kSucceeded || count == kReadFailed || reply.engine == Engine::NoAcknowledge)
        return reply;
    if (count > kDataPerReport || kDataAt + count > report.size())
        return {};
    reply.bytes = report.subspan(kDataAt, count);
    reply.state = report[2] == kReadComplete ? DataReply::State::Complete : DataReply::State::Partial;
    return reply;
}

} // namespace driftbench::mcp2221a
