// The gyro and thermometers of the simulated board: a run of the engine's simulator as samples of the
// firmware, each at the host's time at which it is due. See simulated_board.h for what the numbers are.
#pragma once

#include "device/bridge/bridge_codec.h"
#include "device/firmware/bridge_stream.h"
#include "engine/physics/first_order_lag.h"
#include "engine/physics/gyro_simulator.h"

#include <optional>

namespace driftbench {

class SimulatedGyro
{
public:
    SimulatedGyro(SimulationOptions options, bool externalThermometer, int firstRun);

    // From nowS on: another run, or the one that interrupt() cut, if rate and range are the same.
    // InvalidOption if the simulation can't be sampled so fast.
    Status start(std::uint32_t rateMilliHz, BridgeRange range, double nowS);
    void stop(); // the run is over
    void interrupt() { m_interrupted = m_simulator.has_value(); }

    // When the next sample is due; nothing if none comes any more.
    std::optional<double> dueS() const;

    struct Sample
    {
        bridge_sample sample{}; // without its time
        double dueS = 0.0;
        std::uint32_t lostBefore = 0; // in a gap of the simulation
    };
    Sample take(); // only if one is due

private:
    Status restart(std::uint32_t rateMilliHz, BridgeRange range, double nowS);
    void fetch();

    SimulationOptions m_options;
    bool m_externalThermometer;
    int m_run; // the next one
    std::uint32_t m_rateMilliHz = 0;
    BridgeRange m_range;
    bool m_interrupted = false;
    double m_startS = 0.0;
    std::int64_t m_index = -1; // of m_next in its run
    std::int64_t m_lost = 0;   // just before it
    std::optional<GyroSimulator> m_simulator;
    std::optional<GyroSample> m_next;
    std::optional<FirstOrderLag> m_die;
};

} // namespace driftbench
