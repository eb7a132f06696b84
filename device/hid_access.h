// How drivers come to HID devices: those of this computer, or those that a test makes up.
#pragma once

#include "device/hid_transport.h"
#include "device/host_clock.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace driftbench {

struct HidAccess
{
    std::function<std::vector<HidIdentity>()> list;
    std::function<Result<std::unique_ptr<HidTransport>>(const HidIdentity &)> open;
    std::filesystem::path sysfs = "/sys"; // what the kernel says of devices that are not in the list
    HostClock *clock = nullptr;           // that of the devices, which outlives them; null: a steady clock
    // Whether a program that does not lock the nodes has it open; null: none has.
    std::function<bool(const HidIdentity &)> heldElsewhere{};
};

HidAccess hidDevicesOfThisComputer();

} // namespace driftbench
