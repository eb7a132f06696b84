#include "app/cli/device_choice.h"

namespace driftbench::cli {

void addUsbIdOption(CLI::App &command, std::vector<std::string> &usbIds)
{
    command
        .add_option("--usb-id", usbIds,
                    "hid: USB ids of the native bridge, in hex (default 1209:0001, which is kept for tests)")
        ->type_name("VID:PID")
        ->take_all()
        ->allow_extra_args(false);
}

Result<std::vector<UsbId>> usbIdsOf(const std::vector<std::string> &texts)
{
    std::vector<UsbId> ids;
    for (const std::string &text : texts) {
        const auto id = parseUsbId(text);
        if (!id)
            return id.error();
        ids.push_back(*id);
    }
    return ids;
}

void addDeviceOptions(CLI::App &command, DeviceChoice &choice)
{
    command
        .add_option("--device", choice.device,
                    "simulated (default), inside this program; hid: the native bridge that is plugged in; "
                    "hid:SERIAL")
        ->type_name("NAME");
    addUsbIdOption(command, choice.usbIds);
    command
        .add_option("--flash", choice.flash,
                    "simulated: file that keeps the device's tables from one command to the next")
        ->type_name("FILE");
    command.add_option("--sensor", choice.sensor, "simulated: its gyro, I3G4250D (default) or L3GD20H")
        ->type_name("NAME");
}

Result<OpenedBridge> connectDevice(const DeviceChoice &choice)
{
    auto source = parseSourceChoice(choice.device);
    if (!source)
        return source.error();
    auto ids = usbIdsOf(choice.usbIds);
    if (!ids)
        return ids.error();
    if (auto *native = source->as<NativeChoice>())
        native->ids = *std::move(ids);
    if (auto *simulated = source->as<SimulatedChoice>()) {
        simulated->speed = 0.0; // as fast as it is asked
        simulated->flashFile = choice.flash;
        if (choice.sensor)
            simulated->sensor = *choice.sensor;
    }
    return openBridge(*source);
}

} // namespace driftbench::cli
