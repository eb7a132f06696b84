// A CP2112 as its USB side shows it, from AN495: numbered reports, one transfer at a time that is asked
// about, data that is handed over on demand, its own timeouts and retries.
#pragma once

#include "support/hid_model.h"
#include "support/i2c_bus_model.h"

namespace driftbench::test {

class Cp2112Model final : public HidModel
{
public:
    Cp2112Model(SimulatedClock &clock, I2cBusModel &bus);

private:
    Status take(const Report &report) override;
    Result<Report> feature(std::uint8_t id) override;
    Status takeFeature(const Report &report) override;

    void begin(const Report &report);
    void finish(Outcome outcome, std::size_t bytes);
    void fetch(std::size_t wanted);
    Report status() const;
    bool busy() const { return m_state != 0 && nowS() < m_doneS; }

    I2cBusModel &m_bus;
    std::uint8_t m_state = 0;     // status 0 once the transfer has ended
    std::uint8_t m_condition = 0; // status 1
    double m_doneS = 0.0;
    Report m_read;
    std::size_t m_given = 0;
    double m_timeoutS = 0.0; // 0: none
    int m_retries = 0;       // 0: without end
};

} // namespace driftbench::test
