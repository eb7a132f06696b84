#include "device/i2c/ft260_codec.h"

#include "device/i2c/report_bytes.h"

#include <cassert>

namespace driftbench::ft260 {

namespace {

enum ReportId : std::uint8_t
{
    Version = 0xA0,
    System = 0xA1,
    StatusReport = 0xC0,
    Read = 0xC2,
};

enum Setting : std::uint8_t
{
    EnableI2c = 0x02,
    ResetI2c = 0x20,
    SpeedI2c = 0x22,
};

constexpr std::uint8_t kModeBoth = 0; // of the mode pins: I2C and UART, as with 3
constexpr std::uint8_t kModeI2c = 1;

Feature featureOf(std::uint8_t id)
{
    Feature feature{};
    feature[0] = id;
    return feature;
}

} // namespace

Request enableRequest()
{
    return {System, EnableI2c, 1};
}

Request resetRequest()
{
    return {System, ResetI2c};
}

Request speedRequest(int kHz)
{
    assert(kHz >= kSlowestKHz && kHz <= kFastestKHz);
    return {System, SpeedI2c, static_cast<std::uint8_t>(kHz & 0xFF), static_cast<std::uint8_t>(kHz >> 8)};
}

Request writeRequest(std::uint8_t address, std::uint8_t conditions, std::span<const std::uint8_t> bytes)
{
    assert(!bytes.empty() && bytes.size() <= kDataPerReport);
    const auto length = static_cast<std::uint8_t>(bytes.size());
    const auto id = static_cast<std::uint8_t>(kFirstDataReport + (length - 1) / 4);
    return reportOf({id, address, conditions, length}, bytes);
}

Request readRequest(std::uint8_t address, std::uint8_t conditions, std::uint16_t length)
{
    return {Read, address, conditions, static_cast<std::uint8_t>(length & 0xFF),
            static_cast<std::uint8_t>(length >> 8)};
}

Feature versionQuery()
{
    return featureOf(Version);
}

Feature settingsQuery()
{
    return featureOf(System);
}

Feature statusQuery()
{
    return featureOf(StatusReport);
}

bool isFt260(std::span<const std::uint8_t> version)
{
    return version.size() >= 3 && version[0] == Version && version[1] == 0x02 && version[2] == 0x60;
}

std::optional<Settings> decodeSettings(std::span<const std::uint8_t> report)
{
    if (report.size() < 6 || report[0] != System)
        return {};
    const std::uint8_t mode = report[1] & 3;
    Settings settings;
    settings.i2cWired = mode == kModeBoth || (mode & kModeI2c) != 0;
    settings.ready = report[4] != 0;
    return settings;
}

std::optional<BusStatus> decodeStatus(std::span<const std::uint8_t> report)
{
    if (report.size() < 4 || report[0] != StatusReport)
        return {};
    const std::uint8_t bits = report[1];
    BusStatus status;
    status.controllerBusy = (bits & 0x01) != 0;
    status.failed = (bits & 0x02) != 0;
    status.noAcknowledge = (bits & 0x0C) != 0;
    status.arbitrationLost = (bits & 0x10) != 0;
    status.busBusy = (bits & 0x40) != 0;
    status.kHz = report[2] | report[3] << 8;
    return status;
}

std::optional<std::span<const std::uint8_t>> decodeData(std::span<const std::uint8_t> report)
{
    if (report.size() < 2 || report[0] < kFirstDataReport || report[0] > kLastDataReport)
        return {};
    const std::size_t count = report[1];
    if (count > kDataPerReport || 2 + count > report.size())
        return {};
    return report.subspan(2, count);
}

} // namespace driftbench::ft260
