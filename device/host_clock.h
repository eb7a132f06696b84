// The host's clock as the device drivers see it, so that tests can let simulated time pass instead of
// waiting.
#pragma once

namespace driftbench {

class HostClock
{
public:
    virtual ~HostClock() = default;

    virtual double nowS() const = 0; // monotonic; its zero means nothing
    virtual void waitS(double durationS) = 0;

protected:
    HostClock() = default;
    HostClock(const HostClock &) = default;
    HostClock &operator=(const HostClock &) = default;
};

class SteadyClock final : public HostClock
{
public:
    double nowS() const override;
    void waitS(double durationS) override;
};

} // namespace driftbench
