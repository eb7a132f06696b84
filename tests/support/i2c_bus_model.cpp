#include "support/i2c_bus_model.h"

namespace driftbench::test {

void RegisterDeviceModel::start(bool reading)
{
    if (!reading)
        m_pointed = false;
}

bool RegisterDeviceModel::write(std::uint8_t byte)
{
    if (m_pointed)
        return writeNext(byte);
    m_pointed = true;
    point(byte);
    return true;
}

std::uint8_t RegisterDeviceModel::read()
{
    return readNext();
}

I2cDeviceModel *I2cBusModel::begin(std::uint8_t address, bool reading)
{
    ++m_transfers;
    if (m_refusals > 0) {
        --m_refusals;
        return nullptr;
    }
    const auto found = m_devices.find(address);
    if (found == m_devices.end())
        return nullptr;
    found->second->start(reading);
    return found->second;
}

Outcome I2cBusModel::write(std::uint8_t address, const std::vector<std::uint8_t> &bytes)
{
    if (heldLow())
        return Outcome::HeldLow;
    I2cDeviceModel *device = begin(address, false);
    if (device == nullptr)
        return Outcome::NoAcknowledge;
    for (const std::uint8_t byte : bytes) {
        if (m_refuseData || !device->write(byte))
            return Outcome::NoAcknowledge;
    }
    return Outcome::Done;
}

Outcome I2cBusModel::read(std::uint8_t address, std::size_t length, std::vector<std::uint8_t> &bytes)
{
    if (heldLow())
        return Outcome::HeldLow;
    I2cDeviceModel *device = begin(address, true);
    if (device == nullptr)
        return Outcome::NoAcknowledge;
    bytes.resize(length);
    for (std::uint8_t &byte : bytes)
        byte = device->read();
    return Outcome::Done;
}

void I2cBusModel::recover()
{
    if (m_recoveriesNeeded > 0)
        --m_recoveriesNeeded;
}

} // namespace driftbench::test
