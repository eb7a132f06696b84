// An FT260 as its USB side shows it, from AN_394: conditions given by the host, status as a feature report,
// data that comes by itself, and sleep after 5 s in which transfers get lost.
#pragma once

#include "support/hid_model.h"
#include "support/i2c_bus_model.h"

namespace driftbench::test {

class Ft260Model final : public HidModel
{
public:
    Ft260Model(SimulatedClock &clock, I2cBusModel &bus, int interfaceNumber = 0);

    int lostInSleep() const { return m_lostInSleep; }

private:
    Status take(const Report &report) override;
    Result<Report> feature(std::uint8_t id) override;
    Status takeFeature(const Report &report) override;

    void startWrite(const Report &report);
    void startRead(const Report &report);
    bool begin(std::uint8_t conditions, std::uint8_t address);
    void note(Outcome outcome, std::size_t bytes);
    bool asleep() const;

    I2cBusModel &m_bus;
    bool m_enabled = false;
    bool m_open = false; // between start and stop
    std::uint8_t m_error = 0;
    double m_doneS = 0.0;
    double m_activeS;
    int m_lostInSleep = 0;
};

} // namespace driftbench::test
