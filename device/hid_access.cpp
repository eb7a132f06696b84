#include "device/hid_access.h"

#include "device/hidapi_transport.h"

namespace driftbench {

HidAccess hidDevicesOfThisComputer()
{
    return {listHidDevices, openHidDevice};
}

} // namespace driftbench
