#include "device/host_clock.h"

#include <chrono>
#include <thread>

namespace driftbench {

double SteadyClock::nowS() const
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void SteadyClock::waitS(double durationS)
{
    std::this_thread::sleep_for(std::chrono::duration<double>(durationS));
}

} // namespace driftbench
