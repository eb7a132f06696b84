// A clock that only moves when somebody waits on it or a model takes its time.
#pragma once

#include "device/host_clock.h"

namespace driftbench::test {

class SimClock final : public HostClock
{
public:
    double nowS() const override { return m_nowS; }
    void waitS(double durationS) override { m_nowS += durationS; }
    void moveTo(double timeS) { m_nowS = timeS > m_nowS ? timeS : m_nowS; }

private:
    double m_nowS = 1000.0; // somewhere: nobody may take the zero for granted
};

} // namespace driftbench::test
