#include "app/cli/device_choice.h"

#include "device/hidapi_transport.h"
#include "device/simulated_bridge.h"
#include "engine/physics/sensor_presets.h"

#include <vector>

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

// The native bridges that are plugged in, those with this serial number only, if there is one.
std::vector<HidIdentity> pluggedBridges(const std::string &serial)
{
    std::vector<HidIdentity> found;
    for (const HidIdentity &each : listHidDevices()) {
        if (each.vendorId == BRIDGE_VENDOR_ID && each.productId == BRIDGE_PRODUCT_ID &&
            (serial.empty() || each.serial == serial))
            found.push_back(each);
    }
    return found;
}

Result<ConnectedDevice> connectHid(const std::string &serial)
{
    const auto found = pluggedBridges(serial);
    if (found.empty())
        return Error{Errc::DeviceNotFound,
                     serial.empty()
                         ? "No native gyro bridge is plugged in; plug one in, or say --device simulated."
                         : "No native gyro bridge with the serial number " + serial +
                               " is plugged in; check the number and the cable."};
    if (found.size() > 1) {
        std::string serials;
        for (const HidIdentity &each : found)
            serials += (serials.empty() ? "" : ", ") + each.serial;
        return Error{Errc::InvalidOption, "More than one native gyro bridge is plugged in (" + serials +
                                              "); say which, like --device hid:" + found.front().serial +
                                              "."};
    }
    auto transport = openHidDevice(found.front());
    if (!transport)
        return transport.error();
    auto clock = std::make_unique<SteadyClock>();
    auto client = BridgeClient::open(*std::move(transport), *clock);
    if (!client)
        return client.error();
    return ConnectedDevice{nullptr, std::move(clock), std::make_unique<BridgeClient>(*std::move(client))};
}

} // namespace

void addDeviceOptions(CLI::App &command, DeviceChoice &choice)
{
    command
        .add_option(
            "--device", choice.device,
            "simulated (default), inside this program; hid: the native bridge that is plugged in; hid:SERIAL")
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
    if (choice.device == "hid" || choice.device.starts_with("hid:"))
        return connectHid(choice.device == "hid" ? "" : choice.device.substr(4));
    return Error{Errc::InvalidOption,
                 "\"" + choice.device + "\" is no device; say simulated, hid, or hid: and a serial number."};
}

} // namespace driftbench::cli
