// The FT260 as an I2C bus: life cycle of its transfers over a HidTransport.
//
// The chip has two HID interfaces where its pins enable the UART: the transport must be that of interface 0.
// It sleeps after 5 s without a transfer; the status that is read before each transfer wakes it.
//
// Errors: as I2cBus; open also gives DeviceRefused where the interface is not the I2C one.
#pragma once

#include "device/hid_transport.h"
#include "device/i2c/ft260_codec.h"
#include "device/i2c/i2c_bus.h"

#include <memory>

namespace driftbench {

class Ft260 final : public I2cBus
{
public:
    // Resets the I2C controller, sets the speed. Errc::InvalidOption for a speed outside the limits.
    static Result<std::unique_ptr<Ft260>> open(std::unique_ptr<HidTransport> transport, int kHz);

    const std::string &name() const override { return m_name; }
    I2cLimits limits() const override;

private:
    explicit Ft260(std::unique_ptr<HidTransport> transport);

    Status transferWrite(std::uint8_t address, std::span<const std::uint8_t> bytes) override;
    Status transferRead(std::uint8_t address, std::span<std::uint8_t> bytes) override;
    Status transferWriteThenRead(std::uint8_t address, std::span<const std::uint8_t> written,
                                 std::span<std::uint8_t> bytes) override;

    Status prepare(int kHz);
    Status checkChip();
    Status wake(std::uint8_t address);
    Status send(std::uint8_t address, std::uint8_t conditions, std::span<const std::uint8_t> bytes);
    Status receive(std::uint8_t address, std::uint8_t conditions, std::span<std::uint8_t> bytes);
    Result<ft260::BusStatus> status();
    Status fail(std::uint8_t address, const ft260::BusStatus &status);
    Status reset();

    std::unique_ptr<HidTransport> m_transport;
    std::string m_name;
    std::array<std::uint8_t, ft260::kReportSize> m_reply{};
};

} // namespace driftbench
