// Reports of the FT260, USB to I2C: bytes out of requests, answers out of bytes, and nothing else.
//
// Reports are numbered, numbers little-endian; the id of a data report says how long it is. Data that was
// read comes by itself in as many reports as the chip likes. Decoders take any bytes: what is too short or
// not the answer meant gives nothing.
//
// Source: FTDI AN_394 "User guide for FT260".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace driftbench::ft260 {

inline constexpr std::uint16_t kVendorId = 0x0403;
inline constexpr std::uint16_t kProductId = 0x6030;
inline constexpr std::size_t kReportSize = 64;
inline constexpr std::size_t kDataPerReport = 60;
inline constexpr std::size_t kLongestRead = 180; // three whole reports, as Linux asks for at once
inline constexpr int kSlowestKHz = 60;
inline constexpr int kFastestKHz = 3400;

inline constexpr std::uint8_t kFirstDataReport = 0xD0;
inline constexpr std::uint8_t kLastDataReport = 0xDE;

enum Condition : std::uint8_t
{
    Start = 2,
    RepeatedStart = 3,
    Stop = 4,
};

using Request = std::vector<std::uint8_t>; // the id included

Request enableRequest();       // feature: I2C on
Request resetRequest();        // feature: the I2C controller to rest
Request speedRequest(int kHz); // feature
Request writeRequest(std::uint8_t address, std::uint8_t conditions, std::span<const std::uint8_t> bytes);
Request readRequest(std::uint8_t address, std::uint8_t conditions, std::uint16_t length);

// Feature reports that are asked for: the buffer with its id, and what came.
using Feature = std::array<std::uint8_t, kReportSize>;
Feature versionQuery();
Feature settingsQuery();
Feature statusQuery();

struct Settings
{
    bool i2cWired = false; // by the chip's mode pins
    bool ready = false;
};

struct BusStatus
{
    bool controllerBusy = false;
    bool failed = false;
    bool noAcknowledge = false; // of address or data
    bool arbitrationLost = false;
    bool busBusy = false;
    int kHz = 0;
};

bool isFt260(std::span<const std::uint8_t> version);
std::optional<Settings> decodeSettings(std::span<const std::uint8_t> report);
std::optional<BusStatus> decodeStatus(std::span<const std::uint8_t> report);
std::optional<std::span<const std::uint8_t>> decodeData(std::span<const std::uint8_t> report);

} // namespace driftbench::ft260
