// The MCP2221A of the tests with an L3GD20H on its bus, as a device that lives in real time: its simulated
// clock follows the steady one. Thread-safe.
#pragma once

#include "support/gyro_model.h"
#include "support/mcp2221a_model.h"

#include <mutex>

namespace driftbench::test {

class RealTimeMcp2221a final : public HidTransport
{
public:
    RealTimeMcp2221a();

    const HidIdentity &identity() const override { return m_chip.identity(); }
    Result<std::size_t> read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout) override;
    Status write(std::span<const std::uint8_t> report) override;
    Result<std::size_t> getFeature(std::span<std::uint8_t> report) override;
    Status sendFeature(std::span<const std::uint8_t> report) override;

    static std::span<const std::uint8_t> descriptor();

private:
    void catchUp();

    std::mutex m_mutex;
    SimulatedClock m_clock{0.0}; // stands still but for catchUp and the models
    I2cBusModel m_bus;
    GyroModel m_gyro;
    Mcp2221aModel m_chip;
    double m_aheadS; // of the simulated clock before the steady one
};

} // namespace driftbench::test
