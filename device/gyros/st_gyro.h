// One of ST's gyros on an I2C bus: found by its WHO_AM_I, set up, read.
//
// The set-up keeps the high-pass filter off: it would take away the very drift that is to be measured.
//
// Errors: those of the bus; WrongSensor where something else answers; InvalidOption for a range or data rate
// beyond what the gyro has; DeviceRefused where a register does not keep what was written.
#pragma once

#include "device/gyros/st_gyro_registers.h"
#include "device/i2c/i2c_bus.h"

namespace driftbench {

struct StGyroOptions
{
    double rangeDps = 245.0; // at least
    double rateHz = 100.0;   // at least; nominal
};

class StGyro
{
public:
    // At that address. The bus must outlive the gyro.
    static Result<StGyro> open(I2cBus &bus, const st_gyro::Description &description, std::uint8_t address);
    // The first that answers at one of the addresses of the known gyros.
    static Result<StGyro> find(I2cBus &bus);

    const st_gyro::Description &description() const { return *m_description; }
    std::uint8_t address() const { return m_address; }
    double rangeDps() const { return m_range.rangeDps; }
    double sensitivityDps() const { return m_range.sensitivityDps; }
    double nominalRateHz() const { return m_rate.rateHz; }

    // Starts measuring, with an empty FIFO that keeps the newest samples.
    Status setUp(const StGyroOptions &options);
    Status restartFifo(); // empties it

    Result<st_gyro::FifoState> fifoState();
    // Reads bytes.size() / 6 samples from the FIFO.
    Status readFifo(std::span<std::uint8_t> bytes);
    Result<int> dieCount();

private:
    StGyro(I2cBus &bus, const st_gyro::Description &description, std::uint8_t address)
        : m_bus(&bus), m_description(&description), m_address(address)
    {
    }

    Status writeAndCheck(std::uint8_t reg, std::uint8_t value);

    I2cBus *m_bus;
    const st_gyro::Description *m_description;
    std::uint8_t m_address;
    st_gyro::RangeSetting m_range{};
    st_gyro::RateSetting m_rate{};
};

} // namespace driftbench
