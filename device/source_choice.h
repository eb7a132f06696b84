// Which source of samples a user means, as a plain value and as one line of text:
//
//   simulated[:SENSOR[:SERIAL]]     the bridge inside this program; SENSOR: I3G4250D or L3GD20H
//   hid[:SERIAL]                    a native gyro bridge
//   i2c:CHIP[:SERIAL]/GYRO[@ADDRESS][+THERMOMETER[@ADDRESS]]
//                                   a gyro behind an off-the-shelf bridge: i2c:mcp2221a/l3gd20h+tmp117
//                                   CHIP: mcp2221a, cp2112 or ft260; GYRO: l3gd20h, i3g4250d, or auto for
//                                   whichever answers; THERMOMETER: tmp117, mcp9808, any, or die for that of
//                                   the gyro (left out: an external one if one answers, else the die's);
//                                   ADDRESS: of 7 bits in hex, 6b or 0x6b (left out: those that it can have)
//   file:PATH[*SPEED]               a log that is played back, SPEED times as fast; 0: as fast as it goes
//
// SERIAL is the serial number that USB gives, or the path of the device (/dev/hidraw3) where it has none; it
// may be left out where only one is plugged in. Capitals matter in serial numbers and paths alone.
//
// What the text can't say (rates, the simulation, the log's columns) stands beside it in the value.
#pragma once

#include "device/gyros/thermometers.h"
#include "device/i2c/i2c_chips.h"
#include "engine/base/result.h"
#include "engine/formats/read_options.h"
#include "engine/physics/temperature_profile.h"

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace driftbench {

// What is not given is the preset's (sensor_presets.h).
struct SimulatedChoice
{
    std::string sensor = "I3G4250D";
    std::string serial;                        // empty: the preset's
    std::optional<TemperatureProfile> profile; // nothing: the paper's
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    std::uint64_t seed = 1;
    int run = 0;        // of the campaign: each has its own noise and its own deviation from the curve
    double speed = 1.0; // times real time; 0: as fast as it is read
    std::optional<double> noiseDps{};
    std::optional<double> spread{};
    double clockErrorPpm = 0.0;
    bool externalThermometer = true;
    std::filesystem::path flashFile{}; // keeps the tables; empty: they go with the program
    std::string drift{};               // one of kDriftCurveNames; empty: that of the preset's combs
};

struct UsbId
{
    std::uint16_t vendorId = 0;
    std::uint16_t productId = 0;
    bool operator==(const UsbId &) const = default;
};

// "1209:0001", hex.
Result<UsbId> parseUsbId(std::string_view text);
std::string usbIdText(UsbId id);

struct NativeChoice
{
    std::string serial;       // or path; empty: the only one
    std::vector<UsbId> ids{}; // that count as native bridges; none: the protocol's own
};

struct I2cChoice
{
    I2cChip chip = I2cChip::Mcp2221a;
    std::string serial;                            // of the bridge, or its path; empty: the only one
    std::string gyro{};                            // "L3GD20H"; empty: whichever answers
    std::uint8_t gyroAddress = 0;                  // 0: those that it can have
    std::optional<ThermometerModel> thermometer{}; // nothing: any
    std::uint8_t thermometerAddress = 0;           // 0: those that it can have
    std::string gyroSerial{};                      // which gyro it is, as the gyro itself can't say
    int busKHz = 400;
    double dieOffsetC = 0.0; // see temperature_reader.h
    double dieCPerCount = -1.0;
};

struct FileChoice
{
    std::filesystem::path path;
    double speed = 1.0; // times real time; 0: as fast as it goes
    ReadOptions read{};
};

enum class ThermometerChoice
{
    Automatic, // the external one if there is one
    External,
    Die,
};

struct SourceChoice
{
    std::variant<SimulatedChoice, NativeChoice, I2cChoice, FileChoice> from;
    // Of all but files.
    double rateHz = 0.0;   // 0: the one that the device has now, or usually
    double rangeDps = 0.0; // full scale; 0: the same
    ThermometerChoice thermometer = ThermometerChoice::Automatic;
    bool compensate = false; // by the table in the device; bridges with tables only

    template <class Kind>
    Kind *as()
    {
        return std::get_if<Kind>(&from);
    }
    template <class Kind>
    const Kind *as() const
    {
        return std::get_if<Kind>(&from);
    }
};

// InvalidOption, with what was read and what may be said instead.
Result<SourceChoice> parseSourceChoice(std::string_view text);
// The line that gives the choice back, but for what stands beside it.
std::string sourceChoiceText(const SourceChoice &choice);

} // namespace driftbench
