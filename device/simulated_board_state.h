// The inside of a simulated board; private to it. What its functions do with time and faults is under the
// board's lock.
#pragma once

#include "device/simulated_board.h"
#include "device/simulated_clock.h"
#include "device/simulated_faults.h"
#include "device/simulated_gyro.h"

#include "device/firmware/bridge_device.h"

#include <array>
#include <memory>
#include <mutex>
#include <optional>

namespace driftbench {

inline constexpr std::array kSimulatedRangeFactors{1, 2, 8}; // as the gyros of the datasheets have them

struct SimulatedBoard::State
{
    explicit State(SimulatedBoardOptions given);
    void powerUp();
    void unplug();
    bool streams() const { return device.config.stream == 1; }
    bool isGone(int of) const { return !plugged || of != session; }
    bool isExchangeGone(int of);
    std::uint32_t deviceClockUs(double timeS) const;
    void takeSample();
    void takeSamplesUntil(double timeS);
    std::optional<BridgeReport> nextReport();
    double waitForSampleS(double deadlineS);
    void startOrStopGyro(bool streamedBefore);
    Status afterSet(std::uint8_t command, int operationsBefore);

    static Error gone();

    std::mutex mutex;
    SimulatedBoardOptions options;
    SimulatedClock clock;
    SimulatedGyro gyro;
    SimulatedFaults faults;
    RamFlash flash;
    HidIdentity hid;
    bridge_identity identity;
    std::unique_ptr<bridge_report[]> ring;
    bridge_device device{};
    bool plugged = true;
    int session = 0;
    double powerUpS = 0.0;
};

} // namespace driftbench
