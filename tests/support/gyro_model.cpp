#include "support/gyro_model.h"

#include <cmath>
#include <stdexcept>

namespace driftbench::test {

namespace {

// The data sheets' numbers, apart from those of the driver on purpose.
constexpr std::uint8_t kWhoAmI = 0x0F;
constexpr std::uint8_t kCtrl1 = 0x20;
constexpr std::uint8_t kCtrl4 = 0x23;
constexpr std::uint8_t kCtrl5 = 0x24;
constexpr std::uint8_t kOutTemp = 0x26;
constexpr std::uint8_t kStatus = 0x27;
constexpr std::uint8_t kOutXLow = 0x28;
constexpr std::uint8_t kOutZHigh = 0x2D;
constexpr std::uint8_t kFifoCtrl = 0x2E;
constexpr std::uint8_t kFifoSrc = 0x2F;
constexpr std::uint8_t kLowOdr = 0x39;
constexpr std::size_t kDepth = 32;

bool readOnly(std::uint8_t address)
{
    return address == kWhoAmI || (address >= kOutTemp && address <= kOutZHigh) || address == kFifoSrc;
}

} // namespace

GyroModel::GyroModel(const std::string &model, SimulatedClock &clock, double rateFactor)
    : counts(numbered)
    , dieCount([](double) { return 20; })
    , m_clock(clock)
    , m_l3gd20h(model == "L3GD20H")
    , m_rateFactor(rateFactor)
{
    if (!m_l3gd20h && model != "I3G4250D")
        throw std::invalid_argument("no model of " + model);
    m_registers[kWhoAmI] = m_l3gd20h ? 0xD7 : 0xD3;
    m_registers[kCtrl1] = 0x07; // after power-up: axes on, measuring off
}

Counts GyroModel::numbered(std::int64_t sample)
{
    const auto low = static_cast<std::int16_t>(sample % 30011);
    return {low, static_cast<std::int16_t>(-low), static_cast<std::int16_t>(sample / 30011 - 1)};
}

bool GyroModel::powered() const
{
    return (m_registers[kCtrl1] & 0x08) != 0;
}

bool GyroModel::streaming() const
{
    return (m_registers[kCtrl5] & 0x40) != 0 && m_registers[kFifoCtrl] >> 5 == 2;
}

double GyroModel::trueRateHz() const
{
    const double lowest = m_l3gd20h && (m_registers[kLowOdr] & 1) != 0 ? 12.5 : 100.0;
    const int power = m_registers[kCtrl1] >> 6;
    return m_rateFactor * (lowest == 12.5 && power == 3 ? 50.0 : lowest * (1 << power));
}

double GyroModel::timeOfSampleS(std::int64_t sample) const
{
    return m_beganS + static_cast<double>(sample + 1) / trueRateHz();
}

void GyroModel::catchUp()
{
    if (!powered())
        return;
    const auto due = static_cast<std::int64_t>(std::floor((m_clock.nowS() - m_beganS) * trueRateHz() + 1e-9));
    for (; m_measured < due; ++m_measured)
        measure(m_measured);
}

void GyroModel::measure(std::int64_t sample)
{
    m_newest = counts(sample);
    if (sample == 0)
        m_first = m_newest;
    if ((m_registers[kCtrl5] & 0x10) != 0) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            m_newest[axis] = static_cast<std::int16_t>(m_newest[axis] - m_first[axis]);
    }
    if (!streaming())
        return;
    if (m_fifo.size() == kDepth) {
        m_fifo.pop_front();
        ++m_overwritten;
    }
    m_fifo.push_back(m_newest);
}

void GyroModel::point(std::uint8_t reg)
{
    m_pointer = reg & 0x3F;
    m_increment = (reg & 0x80) != 0;
    m_held = {};
}

bool GyroModel::writeNext(std::uint8_t byte)
{
    catchUp();
    store(m_pointer, byte);
    if (m_increment)
        m_pointer = (m_pointer + 1) & 0x3F;
    return true;
}

void GyroModel::store(std::uint8_t address, std::uint8_t byte)
{
    if (readOnly(address))
        return;
    if (address == kLowOdr && !m_l3gd20h) {
        m_reservedWritten = true;
        return;
    }
    const bool restarts = address == kCtrl1 || address == kLowOdr;
    if (address == kCtrl4 && !m_l3gd20h)
        byte &= 0x7F; // no block data update
    m_registers[address] = byte;
    if (restarts) {
        m_beganS = m_clock.nowS();
        m_measured = 0;
    }
    if (!streaming())
        m_fifo.clear();
}

std::uint8_t GyroModel::readNext()
{
    catchUp();
    const std::uint8_t byte = value(m_pointer);
    if (m_increment)
        m_pointer = m_pointer == kOutZHigh && streaming() ? kOutXLow : (m_pointer + 1) & 0x3F;
    return byte;
}

std::uint8_t GyroModel::value(std::uint8_t address)
{
    if (address >= kOutXLow && address <= kOutZHigh)
        return outByte(address);
    switch (address) {
    case kOutTemp:
        return static_cast<std::uint8_t>(static_cast<std::int8_t>(dieCount(m_clock.nowS())));
    case kStatus:
        return m_measured > 0 ? 0x0F : 0x00;
    case kFifoSrc:
        return fifoSource();
    default:
        return m_registers[address];
    }
}

std::uint8_t GyroModel::outByte(std::uint8_t address)
{
    const std::size_t axis = (address - kOutXLow) / 2;
    const bool high = ((address - kOutXLow) & 1) != 0;
    const bool blockUpdate = (m_registers[kCtrl4] & 0x80) != 0;
    if (streaming()) {
        if (address == kOutXLow && !m_fifo.empty()) {
            m_latched = m_fifo.front();
            m_fifo.pop_front();
            ++m_popped;
        }
    } else if (!high || !blockUpdate || !m_held[axis]) {
        m_latched[axis] = m_newest[axis];
        m_held[axis] = !high;
    }
    const auto bits = static_cast<std::uint16_t>(m_latched[axis]);
    return static_cast<std::uint8_t>(high ? bits >> 8 : bits & 0xFF);
}

std::uint8_t GyroModel::fifoSource() const
{
    if (m_fifo.size() >= kDepth)
        return 0x40 | 0x1F;
    if (m_fifo.empty())
        return 0x20;
    return static_cast<std::uint8_t>(m_fifo.size());
}

} // namespace driftbench::test
