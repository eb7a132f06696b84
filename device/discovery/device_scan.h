// Looks which devices are plugged in and inside those that it may look into: the list of device_list.h with
// details.
//
// Looking inside opens a device for a moment: a native bridge is asked for its info, on an I2C bus the known
// gyros and thermometers are looked for by their ids. Nothing is changed in them but the speed of the bus.
// What was found is remembered as long as the device is plugged in; where a device could not be opened that
// is tried again each time, as a permission may have come. A device that this program uses is never opened,
// nor an I2C chip that another one has open, whose transfers the look would break; a native bridge answers to
// both.
//
// Takes 30 to 55 ms, and up to a second when new devices come: not on a thread that draws.
#pragma once

#include "device/discovery/device_list.h"
#include "device/hid_access.h"

#include <map>

namespace driftbench {

struct ScanRequest
{
    std::vector<HidIdentity> inUse{}; // by this program
    bool afresh = false;              // look inside all again
};

class DeviceScanner
{
public:
    explicit DeviceScanner(HidAccess access = hidDevicesOfThisComputer(), std::vector<UsbId> nativeIds = {})
        : m_access(std::move(access)), m_nativeIds(std::move(nativeIds))
    {
    }

    DeviceList scan(const ScanRequest &request = {});

private:
    void lookInside(DeviceEntry &entry);

    HidAccess m_access;
    std::vector<UsbId> m_nativeIds;
    std::map<std::string, Result<DeviceDetails>> m_known; // by path and serial number
};

} // namespace driftbench
