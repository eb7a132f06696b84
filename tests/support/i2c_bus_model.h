// An I2C bus as its master sees it, with register devices on it and faults.
//
// A transfer happens at once, at the simulated time at which it begins; how long it would take is for the
// bridge model, which answers "busy" for that time.
#pragma once

#include "device/simulated_clock.h"

#include <cstdint>
#include <map>
#include <vector>

namespace driftbench::test {

class I2cDeviceModel
{
public:
    virtual ~I2cDeviceModel() = default;

    virtual void start(bool reading) = 0;      // also a repeated start
    virtual bool write(std::uint8_t byte) = 0; // false: not acknowledged
    virtual std::uint8_t read() = 0;
};

// A device whose first byte written chooses the register that the following ones go to or come from.
class RegisterDeviceModel : public I2cDeviceModel
{
public:
    void start(bool reading) override;
    bool write(std::uint8_t byte) override;
    std::uint8_t read() override;

protected:
    virtual void point(std::uint8_t reg) = 0;
    virtual bool writeNext(std::uint8_t byte) = 0;
    virtual std::uint8_t readNext() = 0;

private:
    bool m_pointed = false;
};

enum class Outcome
{
    Done,
    NoAcknowledge,
    HeldLow,
};

class I2cBusModel
{
public:
    void attach(std::uint8_t address, I2cDeviceModel &device) { m_devices[address] = &device; }
    void detach(std::uint8_t address) { m_devices.erase(address); }

    Outcome write(std::uint8_t address, const std::vector<std::uint8_t> &bytes);
    Outcome read(std::uint8_t address, std::size_t length, std::vector<std::uint8_t> &bytes);

    void setKHz(double kHz) { m_kHz = kHz; }
    double kHz() const { return m_kHz; }
    double durationS(std::size_t bytes) const { return static_cast<double>(bytes + 1) * 9.0 / (m_kHz * 1e3); }

    // Faults.
    void refuseNext(int starts) { m_refusals = starts; } // addresses that nobody acknowledges
    void refuseData(bool refuse) { m_refuseData = refuse; }
    // SDA stays low until the master has tried to free the bus so many times.
    void holdLow(int recoveries) { m_recoveriesNeeded = recoveries; }
    bool heldLow() const { return m_recoveriesNeeded > 0; }
    void recover(); // clock pulses and a stop

    int transfers() const { return m_transfers; }

private:
    I2cDeviceModel *begin(std::uint8_t address, bool reading);

    std::map<std::uint8_t, I2cDeviceModel *> m_devices;
    double m_kHz = 100.0;
    int m_refusals = 0;
    bool m_refuseData = false;
    int m_recoveriesNeeded = 0;
    int m_transfers = 0;
};

} // namespace driftbench::test
