// The CP2112 as an I2C bus: life cycle of its transfers over a HidTransport.
//
// Errors: as I2cBus.
#pragma once

#include "device/hid_transport.h"
#include "device/i2c/cp2112_codec.h"
#include "device/i2c/i2c_bus.h"

#include <memory>

namespace driftbench {

class Cp2112 final : public I2cBus
{
public:
    // Cancels what a former user left, sets the speed. Errc::InvalidOption for a speed outside the limits.
    static Result<std::unique_ptr<Cp2112>> open(std::unique_ptr<HidTransport> transport, int kHz);

    const std::string &name() const override { return m_name; }
    I2cLimits limits() const override;

private:
    explicit Cp2112(std::unique_ptr<HidTransport> transport);

    Status transferWrite(std::uint8_t address, std::span<const std::uint8_t> bytes) override;
    Status transferRead(std::uint8_t address, std::span<std::uint8_t> bytes) override;
    Status transferWriteThenRead(std::uint8_t address, std::span<const std::uint8_t> written,
                                 std::span<std::uint8_t> bytes) override;

    Status prepare(int kHz);
    Status run(const cp2112::Request &request, std::uint8_t address);
    Status fetch(std::uint8_t address, std::span<std::uint8_t> bytes);
    Result<std::span<const std::uint8_t>> exchange(const cp2112::Request &request, std::uint8_t answer);
    Status cancel();

    std::unique_ptr<HidTransport> m_transport;
    std::string m_name;
    std::array<std::uint8_t, cp2112::kReportSize> m_reply{};
};

} // namespace driftbench
