// An L3GD20H or I3G4250D at register level, from their data sheets: identity, data rate, power, range,
// high-pass filter, block data update, FIFO in bypass and stream mode with overrun, die temperature. It
// measures along the simulated clock and keeps a record of what it measured and what became of it.
#pragma once

#include "support/i2c_bus_model.h"

#include <array>
#include <deque>
#include <functional>
#include <string>

namespace driftbench::test {

using Counts = std::array<std::int16_t, 3>;

class GyroModel final : public RegisterDeviceModel
{
public:
    // rateFactor: by how much the part's data rate differs from the nominal one.
    GyroModel(const std::string &model, SimulatedClock &clock, double rateFactor = 1.0);

    // Counts of sample n since measuring began; by default a number that names n on every axis.
    std::function<Counts(std::int64_t)> counts;
    std::function<int(double)> dieCount; // of the simulated time

    static Counts numbered(std::int64_t sample);

    std::uint8_t reg(std::uint8_t address) const { return m_registers[address]; }
    double trueRateHz() const;
    std::int64_t overwritten() const { return m_overwritten; } // by a full FIFO
    std::int64_t popped() const { return m_popped; }
    const Counts &lastPopped() const { return m_latched; }
    bool reservedWritten() const { return m_reservedWritten; }
    double timeOfSampleS(std::int64_t sample) const; // simulated time

private:
    void point(std::uint8_t reg) override;
    bool writeNext(std::uint8_t byte) override;
    std::uint8_t readNext() override;

    void catchUp();
    void measure(std::int64_t sample);
    std::uint8_t value(std::uint8_t address);
    std::uint8_t outByte(std::uint8_t address);
    std::uint8_t fifoSource() const;
    bool streaming() const;
    bool powered() const;
    void store(std::uint8_t address, std::uint8_t byte);

    SimulatedClock &m_clock;
    bool m_l3gd20h;
    double m_rateFactor;
    std::array<std::uint8_t, 64> m_registers{};
    std::uint8_t m_pointer = 0;
    bool m_increment = false;
    double m_beganS = 0.0;
    std::int64_t m_measured = 0; // since it began
    std::deque<Counts> m_fifo;
    Counts m_newest{};
    Counts m_latched{}; // what a read that has begun goes on with
    std::array<bool, 3> m_held{};
    Counts m_first{}; // what the high-pass filter takes off
    std::int64_t m_overwritten = 0;
    std::int64_t m_popped = 0;
    bool m_reservedWritten = false;
};

} // namespace driftbench::test
