// An MCP2221A as its USB side shows it, from DS20005565: 64-byte reports without ids, one answer a request,
// an I2C engine that works on its own time, keeps its state until it is asked or cancelled, and refuses what
// does not fit that state.
#pragma once

#include "support/hid_model.h"
#include "support/i2c_bus_model.h"

namespace driftbench::test {

class Mcp2221aModel final : public HidModel
{
public:
    Mcp2221aModel(SimulatedClock &clock, I2cBusModel &bus);

private:
    enum class Doing
    {
        Nothing,
        Writing,
        HoldingBus, // written without a stop
        Reading,
        NotAcknowledged,
        Starting, // on a bus that is held low
    };

    Status take(const Report &report) override;
    Result<Report> feature(std::uint8_t id) override;
    Status takeFeature(const Report &report) override;

    Report status(const Report &request);
    Report transfer(const Report &request);
    Report data();
    void startWrite(const Report &request);
    void startRead(const Report &request);
    void settle(); // what has ended by now
    std::uint8_t engine() const;

    I2cBusModel &m_bus;
    Doing m_doing = Doing::Nothing;
    bool m_stop = true;
    bool m_failed = false; // the transfer under way will end without an acknowledge
    double m_doneS = 0.0;
    Report m_read;
    std::size_t m_given = 0;
};

} // namespace driftbench::test
