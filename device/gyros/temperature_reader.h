// The temperature that goes with a gyro's samples: of an external thermometer where there is one, else of the
// gyro's die, each read at its own pace and stamped with the host time of the reading.
//
//   T_die = dieOffsetC + dieCPerCount * count
//
// No document states the die's offset, so its temperatures are relative until the offset is set.
//
// Errors: those of the bus, after kMostFailures in a row; DeviceSilent where the external thermometer has no
// first reading in time.
#pragma once

#include "device/gyros/die_sign_check.h"
#include "device/gyros/st_gyro.h"
#include "device/gyros/thermometers.h"
#include "device/host_clock.h"

#include <optional>

namespace driftbench {

struct TemperatureOptions
{
    double intervalS = 0.5;
    double dieCPerCount = -1.0;
    double dieOffsetC = 0.0;
    bool useExternal = true; // if one answers
    // One that must answer: BusNoAcknowledge or WrongSensor if it does not.
    bool requireExternal = false;
    std::optional<ThermometerModel> externalModel{}; // nothing: any
    std::uint8_t externalAddress = 0;                // of that model; 0: those that it can have
};

class TemperatureReader
{
public:
    static constexpr int kMostFailures = 3;

    // gyro and clock must outlive the reader.
    TemperatureReader(StGyro &gyro, std::optional<I2cThermometer> external, HostClock &clock,
                      const TemperatureOptions &options);

    Status first();     // waits for a first reading
    Status readIfDue(); // both thermometers
    double temperatureC() const { return m_temperatureC; }
    double readAtS() const { return m_readAtS; } // host time
    std::optional<std::string> takeEvent();

private:
    Result<bool> read(); // false: no conversion is done yet
    Result<bool> readBoth();

    StGyro &m_gyro;
    std::optional<I2cThermometer> m_external;
    HostClock &m_clock;
    TemperatureOptions m_options;
    DieSignCheck m_signCheck;
    double m_temperatureC = 0.0;
    double m_readAtS = 0.0;
    double m_dueS = 0.0;
    int m_failures = 0; // in a row
    std::optional<std::string> m_event;
};

} // namespace driftbench
