// Simulated time as a host's clock: so many times as fast as the steady clock, or, with speed 0, standing
// still until someone waits or advances it. Thread-safe.
#pragma once

#include "device/host_clock.h"

#include <atomic>

namespace driftbench {

class SimulatedClock final : public HostClock
{
public:
    // startS: what it shows at first.
    explicit SimulatedClock(double speed, double startS = 0.0);

    double nowS() const override;
    void waitS(double durationS) override; // with speed 0 time is moved on instead

    bool runsByItself() const { return m_speed > 0.0; }
    double speed() const { return m_speed; }
    void advanceTo(double timeS); // only with speed 0; never backwards

private:
    double m_speed;
    double m_startS;
    double m_steadyStartS;
    std::atomic<double> m_nowS; // with speed 0
};

} // namespace driftbench
