// Reports of the CP2112, USB to SMBus: bytes out of requests, answers out of bytes, and nothing else.
//
// Reports are numbered, numbers big-endian. A transfer is started by one report, asked for by another until
// it is done, and what was read is fetched in pieces. Decoders take any bytes: what is too short or not the
// answer meant gives nothing.
//
// Source: Silicon Labs AN495 "CP2112 interface specification".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace driftbench::cp2112 {

inline constexpr std::uint16_t kVendorId = 0x10C4;
inline constexpr std::uint16_t kProductId = 0xEA90;
inline constexpr std::size_t kReportSize = 64;
inline constexpr std::size_t kDataPerReport = 61;
inline constexpr std::size_t kLongestRead = 512;
inline constexpr std::size_t kLongestTarget = 16; // bytes written before a read
inline constexpr int kSlowestKHz = 10;
inline constexpr int kFastestKHz = 400;

inline constexpr std::uint8_t kReadResponse = 0x13;
inline constexpr std::uint8_t kStatusResponse = 0x16;

using Request = std::vector<std::uint8_t>; // the id included

// Feature report: speed, no data without being asked for, timeouts and retries that end.
Request configRequest(int kHz);
Request readRequest(std::uint8_t address, std::uint16_t length);
Request writeReadRequest(std::uint8_t address, std::span<const std::uint8_t> written, std::uint16_t length);
Request writeRequest(std::uint8_t address, std::span<const std::uint8_t> bytes);
Request fetchRequest(std::uint16_t length);
Request statusRequest();
Request cancelRequest();

enum class Progress
{
    Idle,
    Busy,
    Complete,
    NoAcknowledge,
    BusNotFree, // held low, or arbitration lost
    Failed,
};

struct StatusReply
{
    Progress progress = Progress::Idle;
    std::uint16_t bytes = 0; // read so far
};

std::optional<StatusReply> decodeStatus(std::span<const std::uint8_t> report);
std::optional<std::span<const std::uint8_t>> decodeData(std::span<const std::uint8_t> report);

} // namespace driftbench::cp2112
