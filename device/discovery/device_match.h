// Which of the plugged-in HID devices a choice means. Pure: a list and what the kernel says in, one device or
// the reason out.
//
// A device is told by its USB ids and, if the choice names one, its serial number or path. Where a device has
// several HID interfaces (FT260), the first is the one that is meant; some systems know no interface numbers
// (-1), and then each may be it.
//
// Errors: DeviceNotFound, DeviceHeldByKernel (with what to do), InvalidOption where several fit.
#pragma once

#include "device/discovery/kernel_driver_state.h"
#include "device/hid_transport.h"
#include "device/source_choice.h"

#include <functional>
#include <vector>

namespace driftbench {

// The ids of native bridges as the choice has them, or the protocol's own.
std::vector<UsbId> nativeIds(const std::vector<UsbId> &chosen);
bool hasId(const HidIdentity &identity, const std::vector<UsbId> &ids);

// Without the interfaces that are not meant; in the order of the list.
std::vector<HidIdentity> withoutOtherInterfaces(const std::vector<HidIdentity> &devices);

using KernelReports = std::function<KernelDriverReport(UsbId)>;

Result<HidIdentity> findNativeBridge(const std::vector<HidIdentity> &plugged, const NativeChoice &choice,
                                     const KernelReports &kernel);
Result<HidIdentity> findI2cChip(const std::vector<HidIdentity> &plugged, const I2cChoice &choice,
                                const KernelReports &kernel);

} // namespace driftbench
