#include "vm/real_time_mcp2221a.h"

#include <array>
#include <thread>

namespace driftbench::test {

namespace {

constexpr std::uint8_t kGyroAddress = 0x6B;
constexpr std::chrono::microseconds kPoll{500}; // reports are a millisecond apart

// 64 bytes in and 64 bytes out on the vendor's page, without ids.
constexpr std::array<std::uint8_t, 27> kDescriptor{
    0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08,
    0x95, 0x40, 0x09, 0x02, 0x81, 0x02, 0x95, 0x40, 0x09, 0x03, 0x91, 0x02, 0xC0,
};

} // namespace

RealTimeMcp2221a::RealTimeMcp2221a()
    : m_gyro("L3GD20H", m_clock), m_chip(m_clock, m_bus), m_aheadS(m_clock.nowS() - SteadyClock().nowS())
{
    m_bus.attach(kGyroAddress, m_gyro);
}

std::span<const std::uint8_t> RealTimeMcp2221a::descriptor()
{
    return kDescriptor;
}

void RealTimeMcp2221a::catchUp()
{
    m_clock.advanceTo(SteadyClock().nowS() + m_aheadS);
}

Result<std::size_t> RealTimeMcp2221a::read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout)
{
    const auto until = std::chrono::steady_clock::now() + timeout;
    for (;;) {
        {
            const std::lock_guard lock(m_mutex);
            catchUp();
            const auto length = m_chip.read(report, std::chrono::milliseconds(0));
            if (!length || *length > 0)
                return length;
        }
        if (std::chrono::steady_clock::now() >= until)
            return std::size_t{0};
        std::this_thread::sleep_for(kPoll);
    }
}

Status RealTimeMcp2221a::write(std::span<const std::uint8_t> report)
{
    const std::lock_guard lock(m_mutex);
    catchUp();
    return m_chip.write(report);
}

Result<std::size_t> RealTimeMcp2221a::getFeature(std::span<std::uint8_t> report)
{
    const std::lock_guard lock(m_mutex);
    return m_chip.getFeature(report);
}

Status RealTimeMcp2221a::sendFeature(std::span<const std::uint8_t> report)
{
    const std::lock_guard lock(m_mutex);
    return m_chip.sendFeature(report);
}

} // namespace driftbench::test
