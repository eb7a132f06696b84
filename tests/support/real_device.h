// A board in real time, and the way to it that a program takes: by libhidapi, by serial number.
#pragma once

#include "device/hidapi_transport.h"
#include "support/simulated_device.h"

#include <optional>

namespace driftbench::test {

// Its ring holds 3.6 s at 1 kHz: what is tested is the way of the samples, not when a busy computer lets
// their reader run.
inline SimulatedBoardOptions realTimeBoard(double profileS = 60.0)
{
    SimulatedBoardOptions options = quickBoard(profileS);
    options.speed = 1.0;
    options.ringReports = 512;
    return options;
}

inline std::optional<HidIdentity> listed(const std::string &serial)
{
    for (const HidIdentity &each : listHidDevices()) {
        if (each.serial == serial)
            return each;
    }
    return std::nullopt;
}

inline Result<std::unique_ptr<HidTransport>> openListed(const std::string &serial)
{
    if (const auto found = listed(serial))
        return openHidDevice(*found);
    return Error{Errc::DeviceNotFound, "There is no " + serial + "."};
}

} // namespace driftbench::test
