// Reports of the MCP2221A, USB to I2C: bytes out of requests, requests out of bytes, and nothing else.
//
// Reports have 64 bytes and no ids, so a request is written with a 0 before it. The chip answers every
// request with one report that begins with the request's own code and carries no other tag: one request at a
// time. Decoders take any bytes: what is too short or not the answer meant gives nothing.
//
// Source: Microchip DS20005565, section 3.1 "HID commands". Codes of the I2C engine's state beyond those of
// the data sheet are the ones that Linux's hid-mcp2221 acts on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace driftbench::mcp2221a {

inline constexpr std::uint16_t kVendorId = 0x04D8;
inline constexpr std::uint16_t kProductId = 0x00DD;
inline constexpr std::size_t kReportSize = 64;
inline constexpr std::size_t kDataPerReport = 60;
inline constexpr int kSlowestKHz = 47; // the divider is a byte
inline constexpr int kFastestKHz = 400;

enum class Command : std::uint8_t
{
    Status = 0x10,
    GetData = 0x40,
    Write = 0x90,
    Read = 0x91,
    ReadAfterRepeatedStart = 0x93,
    WriteWithoutStop = 0x94,
};

using Request = std::array<std::uint8_t, kReportSize + 1>; // the id 0 before it

Request statusRequest();
Request cancelRequest();
Request speedRequest(int kHz); // kSlowestKHz .. kFastestKHz
Request getDataRequest();
// At most kDataPerReport bytes; command is Write or WriteWithoutStop.
Request writeRequest(Command command, std::uint8_t address, std::span<const std::uint8_t> bytes);
// command is Read or ReadAfterRepeatedStart.
Request readRequest(Command command, std::uint8_t address, std::uint16_t length);

enum class Engine
{
    Idle,
    Working,       // a transfer is under way
    Waiting,       // written without stop, or read: it waits for the next request
    NoAcknowledge, // of the address
    TimedOut,
};

struct StatusReply
{
    Engine engine = Engine::Idle;
    bool speedSet = false; // the request set the speed, and it is taken
    bool sclHigh = false;
    bool sdaHigh = false;
};

struct DataReply
{
    enum class State
    {
        NotReady,
        Partial,
        Complete,
        Failed
    };
    State state = State::Failed;
    Engine engine = Engine::Idle;
    std::span<const std::uint8_t> bytes; // of the report
};

std::optional<StatusReply> decodeStatus(std::span<const std::uint8_t> report);
// Whether a write or read request was taken; it is refused while the engine works or waits.
std::optional<bool> decodeAccepted(std::span<const std::uint8_t> report, Command command);
std::optional<DataReply> decodeData(std::span<const std::uint8_t> report);

} // namespace driftbench::mcp2221a
