// The MCP2221A as an I2C bus: life cycle of its transfers over a HidTransport.
//
// A register read takes five requests at least (write without stop, read, get data, each answered in its own
// USB frame), about 84 a second as measured with real ones: use long reads.
//
// Errors: as I2cBus; open also gives BusStuck where a line of the bus is low before anything was sent.
#pragma once

#include "device/hid_transport.h"
#include "device/i2c/i2c_bus.h"
#include "device/i2c/mcp2221a_codec.h"

#include <memory>

namespace driftbench {

class Mcp2221a final : public I2cBus
{
public:
    // Cancels what a former user left, sets the speed. Errc::InvalidOption for a speed outside the limits.
    static Result<std::unique_ptr<Mcp2221a>> open(std::unique_ptr<HidTransport> transport, int kHz);

    const std::string &name() const override { return m_name; }
    I2cLimits limits() const override;

private:
    explicit Mcp2221a(std::unique_ptr<HidTransport> transport);

    Status transferWrite(std::uint8_t address, std::span<const std::uint8_t> bytes) override;
    Status transferRead(std::uint8_t address, std::span<std::uint8_t> bytes) override;
    Status transferWriteThenRead(std::uint8_t address, std::span<const std::uint8_t> written,
                                 std::span<std::uint8_t> bytes) override;

    Status prepare(int kHz);
    Result<std::span<const std::uint8_t>> exchange(const mcp2221a::Request &request);
    Result<mcp2221a::StatusReply> status(const mcp2221a::Request &request);
    Status tidy();
    Status begin(const mcp2221a::Request &request, std::uint8_t address);
    Status finishWrite(std::uint8_t address);
    Status collect(std::uint8_t address, std::span<std::uint8_t> bytes);
    Status giveUp(std::uint8_t address);
    Status cancel();

    std::unique_ptr<HidTransport> m_transport;
    std::string m_name;
    std::array<std::uint8_t, mcp2221a::kReportSize> m_reply{};
    bool m_untidy = false; // an answer is missing: who knows what the engine is doing
};

} // namespace driftbench
