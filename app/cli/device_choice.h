// Which native bridge a command talks to, by options, and the way to it.
#pragma once

#include "device/open_source.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace driftbench::cli {

struct DeviceChoice
{
    std::string device = "simulated";
    std::vector<std::string> usbIds;   // that count as native bridges
    std::string flash;                 // of the simulated device; empty: its tables go with the program
    std::optional<std::string> sensor; // of the simulated device
};

void addDeviceOptions(CLI::App &command, DeviceChoice &choice);

// --usb-id: what counts as a native bridge instead of the protocol's own ids.
void addUsbIdOption(CLI::App &command, std::vector<std::string> &usbIds);
Result<std::vector<UsbId>> usbIdsOf(const std::vector<std::string> &texts);

// The errors of openBridge.
Result<OpenedBridge> connectDevice(const DeviceChoice &choice);

} // namespace driftbench::cli
