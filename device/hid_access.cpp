#include "device/hid_access.h"

#include "device/hidapi_transport.h"
#include "device/node_holders.h"

namespace driftbench {

HidAccess hidDevicesOfThisComputer()
{
    HidAccess access{listHidDevices, openHidDevice};
    access.heldElsewhere = [](const HidIdentity &identity) { return isHeldElsewhere(identity.path); };
    return access;
}

} // namespace driftbench
