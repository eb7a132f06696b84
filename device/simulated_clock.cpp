#include "device/simulated_clock.h"

namespace driftbench {

SimulatedClock::SimulatedClock(double speed, double startS)
    : m_speed(speed), m_startS(startS), m_steadyStartS(SteadyClock().nowS()), m_nowS(startS)
{
}

double SimulatedClock::nowS() const
{
    return runsByItself() ? m_startS + (SteadyClock().nowS() - m_steadyStartS) * m_speed : m_nowS.load();
}

void SimulatedClock::waitS(double durationS)
{
    if (runsByItself())
        SteadyClock().waitS(durationS / m_speed);
    else
        m_nowS.fetch_add(durationS);
}

void SimulatedClock::advanceTo(double timeS)
{
    double nowS = m_nowS.load();
    while (nowS < timeS && !m_nowS.compare_exchange_weak(nowS, timeS)) {
    }
}

} // namespace driftbench
