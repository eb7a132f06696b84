// A simulated board for tests that is as fast as it is read, on a short and quiet run.
#pragma once

#include "device/bridge/bridge_client.h"
#include "device/simulated_bridge.h"
#include "engine/physics/sensor_presets.h"

#include <memory>

namespace driftbench::test {

// durationS at the L3GD20H's preset, heating from 20 to 40 degrees.
inline SimulatedBoardOptions quickBoard(double durationS)
{
    SimulationOptions simulation = *presetSimulation("L3GD20H", Eigen::Vector3d::Zero());
    simulation.sensor.serial = "SIM-0001";
    simulation.profile = *TemperatureProfile::build(
        "test", 20.0, {HoldSegment{0.1 * durationS}, RampSegment{40.0, 1.0, 0.045 * durationS}});
    SimulatedBoardOptions options{std::move(simulation)};
    options.speed = 0.0;
    return options;
}

inline BridgeClient connectTo(const std::shared_ptr<SimulatedBoard> &board)
{
    return *BridgeClient::open(*SimulatedBridge::open(board), board->clock());
}

} // namespace driftbench::test
