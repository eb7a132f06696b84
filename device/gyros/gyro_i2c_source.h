// Samples of a gyro behind an off-the-shelf USB bridge: its FIFO read in bursts as fast as the bridge allows,
// the temperature read beside it.
//
// Times come from the gyro's own data rate, which is followed by the host times of the looks at the FIFO
// (fifo_clock.h). Every sample carries the last temperature that was read before it. Samples that the FIFO
// dropped are a gap of cause DeviceOverrun, those in a failed transfer one of cause ReportsLost.
//
// Errors: those of the bus once it keeps failing, of StGyro and I2cThermometer in open().
#pragma once

#include "device/gyros/fifo_reader.h"
#include "device/gyros/temperature_reader.h"
#include "device/sample_source.h"

#include <array>
#include <deque>
#include <memory>

namespace driftbench {

struct GyroI2cOptions
{
    std::string model;        // "L3GD20H"; empty: whichever answers
    std::uint8_t address = 0; // 0: the addresses of that model
    std::string serial;       // which gyro it is, as the gyro itself can't say
    StGyroOptions gyro;
    TemperatureOptions temperature;
};

class GyroI2cSource final : public SampleSource
{
public:
    // Finds the gyro and the thermometer and sets them up. clock must outlive the source.
    static Result<std::unique_ptr<GyroI2cSource>> open(std::unique_ptr<I2cBus> bus,
                                                       const GyroI2cOptions &options, HostClock &clock);

    const SourceInfo &info() const override { return m_info; }
    Result<SourceStats> run(SampleSink &sink, std::stop_token stop) override;

private:
    GyroI2cSource(std::unique_ptr<I2cBus> bus, StGyro gyro, std::optional<I2cThermometer> external,
                  const GyroI2cOptions &options, HostClock &clock);

    struct TemperatureReading
    {
        double atS;
        double temperatureC;
    };

    Status measure(SampleSink &sink, const std::stop_token &stop);
    void noteTemperature(SampleSink &sink);
    Flow deliver(const FifoBurst &burst, SampleSink &sink);
    double temperatureAt(double timeS);
    void noteSaturation(const st_gyro::Counts &counts, SampleSink &sink);

    std::unique_ptr<I2cBus> m_bus;
    StGyro m_gyro;
    std::string m_thermometerName; // empty: the die's
    GyroI2cOptions m_options;
    SourceInfo m_info;
    FifoReader m_fifo;
    TemperatureReader m_temperature;
    std::deque<TemperatureReading> m_readings; // ascending in time, the first one before the next sample
    SampleBlock m_block;
    SourceStats m_stats;
    double m_firstS = 0.0; // host time of the first sample
    double m_lastS = 0.0;  // since then
    std::array<bool, 3> m_saturationTold{};
};

} // namespace driftbench
