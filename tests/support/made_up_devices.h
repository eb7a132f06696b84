// HID devices that a test makes up: a list, and for each a way to open it.
#pragma once

#include "device/hid_access.h"

#include <functional>
#include <utility>
#include <vector>

namespace driftbench::test {

class MadeUpDevices
{
public:
    using Open = std::function<Result<std::unique_ptr<HidTransport>>()>;

    void plugIn(HidIdentity identity, Open open)
    {
        m_devices.push_back({std::move(identity), std::move(open)});
    }
    void unplug(const std::string &path)
    {
        std::erase_if(m_devices, [&](const auto &device) { return device.first.path == path; });
    }

    // Must not outlive this.
    HidAccess access(HostClock *clock = nullptr)
    {
        HidAccess made;
        made.list = [this] {
            std::vector<HidIdentity> identities;
            for (const auto &[identity, open] : m_devices)
                identities.push_back(identity);
            return identities;
        };
        made.open = [this](const HidIdentity &identity) -> Result<std::unique_ptr<HidTransport>> {
            for (const auto &[each, open] : m_devices) {
                if (each.path != identity.path)
                    continue;
                ++opened;
                return open();
            }
            return Error{Errc::DeviceNotFound, "There is no device at " + identity.path + "."};
        };
        made.sysfs = "/no/sysfs/here";
        made.clock = clock;
        return made;
    }

    int opened = 0; // how often

private:
    std::vector<std::pair<HidIdentity, Open>> m_devices;
};

} // namespace driftbench::test
