#include "app/cli/device_choice.h"

#include "device/simulated_bridge.h"
#include "engine/physics/datasheets.h"
#include "engine/physics/sensor_presets.h"

namespace driftbench::cli {

namespace {

Result<ConnectedDevice> connectSimulated(const DeviceChoice &choice)
{
    auto simulation = presetSimulation(choice.sensor, Eigen::Vector3d::Zero());
    if (!simulation)
        return simulation.error();
    SimulatedBoardOptions options{*std::move(simulation)};
    options.speed = 0.0; // as fast as it is asked
    options.flashFile = choice.flash;
    auto board = SimulatedBoard::create(std::move(options));
    if (!board)
        return board.error();
    auto transport = SimulatedBridge::open(*board);
    if (!transport)
        return transport.error();
    auto client = BridgeClient::open(*std::move(transport), (*board)->clock());
    if (!client)
        return client.error();
    return ConnectedDevice{*std::move(board), nullptr, std::make_unique<BridgeClient>(*std::move(client))};
}

} // namespace

void addDeviceOptions(CLI::App &command, DeviceChoice &choice)
{
    command.add_option("--device", choice.device, "simulated (default): a bridge inside this program")
        ->type_name("NAME");
    command
        .add_option("--flash", choice.flash,
                    "simulated: file that keeps the device's tables from one command to the next")
        ->type_name("FILE");
    command.add_option("--sensor", choice.sensor, "simulated: its gyro, I3G4250D (default) or L3GD20H")
        ->type_name("NAME");
}

Result<ConnectedDevice> connectDevice(const DeviceChoice &choice)
{
    if (choice.device == "simulated")
        return connectSimulated(choice);
    return Error{Errc::InvalidOption, "There is no device \"" + choice.device + "\"; say simulated."};
}

} // namespace driftbench::cli
