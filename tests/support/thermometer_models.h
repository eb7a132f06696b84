// TMP117 and MCP9808 at register level, from their data sheets: identity and a temperature of simulated time,
// with the resolution and the conversion time of the real ones.
#pragma once

#include "support/i2c_bus_model.h"

#include <functional>

namespace driftbench::test {

// Registers of 16 bits, high byte first.
class WordRegisterModel : public RegisterDeviceModel
{
public:
    explicit WordRegisterModel(SimulatedClock &clock) : m_clock(clock), m_poweredS(clock.nowS()) {}

    std::function<double(double)> temperatureC = [](double) { return 25.0; }; // of the simulated time

protected:
    virtual std::uint16_t word(std::uint8_t reg) const = 0;
    // When the last conversion ended; before the first one: before power-up.
    double convertedS(double conversionS) const;
    bool converted(double conversionS) const { return m_clock.nowS() >= m_poweredS + conversionS; }

private:
    void point(std::uint8_t reg) override;
    bool writeNext(std::uint8_t byte) override;
    std::uint8_t readNext() override;

    SimulatedClock &m_clock;
    double m_poweredS;
    std::uint8_t m_register = 0;
    std::uint16_t m_word = 0;
    bool m_low = false;
};

class Tmp117Model final : public WordRegisterModel
{
public:
    using WordRegisterModel::WordRegisterModel;

private:
    std::uint16_t word(std::uint8_t reg) const override;
};

class Mcp9808Model final : public WordRegisterModel
{
public:
    using WordRegisterModel::WordRegisterModel;

private:
    std::uint16_t word(std::uint8_t reg) const override;
};

} // namespace driftbench::test
