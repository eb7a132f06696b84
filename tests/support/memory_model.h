// 256 bytes on an I2C bus that remember what was written: the simplest register device.
#pragma once

#include "support/i2c_bus_model.h"

#include <array>

namespace driftbench::test {

class MemoryModel final : public RegisterDeviceModel
{
public:
    std::array<std::uint8_t, 256> bytes{};

private:
    void point(std::uint8_t reg) override { m_at = reg; }
    bool writeNext(std::uint8_t byte) override
    {
        bytes[m_at++] = byte;
        return true;
    }
    std::uint8_t readNext() override { return bytes[m_at++]; }

    std::uint8_t m_at = 0; // wraps
};

} // namespace driftbench::test
