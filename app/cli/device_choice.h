// Which device a command talks to, by options, and the way to it.
#pragma once

#include "device/bridge/bridge_client.h"
#include "device/simulated_board.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace driftbench::cli {

struct DeviceChoice
{
    std::string device = "simulated";
    std::string flash;               // of the simulated device; empty: its tables go with the program
    std::string sensor = "I3G4250D"; // of the simulated device
};

void addDeviceOptions(CLI::App &command, DeviceChoice &choice);

// Whatever the client needs lives beside it.
struct ConnectedDevice
{
    std::shared_ptr<SimulatedBoard> board; // if it is simulated
    std::unique_ptr<HostClock> clock;      // if it is real
    std::unique_ptr<BridgeClient> client;
};

// The errors of BridgeClient::open; InvalidOption for a device that is none of those that --device names.
Result<ConnectedDevice> connectDevice(const DeviceChoice &choice);

} // namespace driftbench::cli
