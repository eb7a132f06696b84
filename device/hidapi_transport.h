// HID devices of this computer, through hidapi (its hidraw backend under Linux).
//
// Threads may use all of it at the same time, but each transport one only.
//
// Errors of openHidDevice: DeviceNotFound (nothing at the path), DeviceNotPermitted (with how to install the
// udev rule), DeviceInUse, DeviceRefused (anything else, with the system's words). Errors of the transport as
// hid_transport.h says; a signal while reading is a time-out. An exchange that fails as it does when the
// cable is pulled waits a moment for the kernel to notice that the device has gone, and then says so.
#pragma once

#include "device/hid_transport.h"

#include <memory>
#include <vector>

namespace driftbench {

// All that are plugged in. Takes 30 to 55 ms: not on a thread that draws.
std::vector<HidIdentity> listHidDevices();

// identity: one of the list; only its path is used to open it. It is ours alone as long as it is open: a
// second one, of this or another program that locks the node, is DeviceInUse.
Result<std::unique_ptr<HidTransport>> openHidDevice(const HidIdentity &identity);

} // namespace driftbench
