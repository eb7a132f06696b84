// What the parts of the `device` command share: which device, and how it answers.
#pragma once

#include "app/cli/command.h"
#include "app/cli/device_choice.h"

namespace driftbench::cli {

struct DeviceArguments
{
    DeviceChoice choice;
    bool json = false;
};

// A part of `device` with the options that name the device; the example is what follows "device".
CLI::App *addDevicePart(CLI::App &device, const std::string &name, const std::string &description,
                        const std::string &example, DeviceArguments &arguments);

void addDeviceUpload(CLI::App &device, Invocation &invocation);

} // namespace driftbench::cli
