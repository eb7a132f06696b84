#include "device/discovery/device_match.h"

#include "device/bridge/bridge_protocol.h"

#include <algorithm>

namespace driftbench {

namespace {

struct Wanted
{
    std::string what;   // "native gyro bridge"
    std::string serial; // or path; empty: any
    std::vector<UsbId> ids;
    std::string prefix; // of a choice that names one: "hid:"
    std::string suffix; // "/auto"
};

bool isNamed(const HidIdentity &device, const std::string &serial)
{
    return serial.empty() || device.serial == serial || device.path == serial;
}

const std::string &nameOf(const HidIdentity &device)
{
    return device.serial.empty() ? device.path : device.serial;
}

Error notPluggedIn(const Wanted &wanted)
{
    if (wanted.serial.empty())
        return {Errc::DeviceNotFound,
                "No " + wanted.what + " is plugged in; plug one in, or choose the source simulated."};
    return {Errc::DeviceNotFound, "No " + wanted.what + " with the serial number or path " + wanted.serial +
                                      " is plugged in; check it and the cable."};
}

Error severalFit(const Wanted &wanted, const std::vector<HidIdentity> &fit)
{
    std::string names;
    for (const HidIdentity &each : fit)
        names += (names.empty() ? "" : ", ") + nameOf(each);
    // Serial numbers that are the same do not tell them apart.
    const bool sameName = fit.size() > 1 && nameOf(fit[0]) == nameOf(fit[1]);
    const std::string &example = sameName ? fit[0].path : nameOf(fit[0]);
    return {Errc::InvalidOption, "More than one " + wanted.what + " is plugged in (" + names +
                                     "); say which, like " + wanted.prefix + example + wanted.suffix + "."};
}

Result<HidIdentity> find(const std::vector<HidIdentity> &plugged, const Wanted &wanted,
                         const KernelReports &kernel)
{
    std::vector<HidIdentity> fit;
    for (const HidIdentity &device : withoutOtherInterfaces(plugged)) {
        if (hasId(device, wanted.ids) && isNamed(device, wanted.serial))
            fit.push_back(device);
    }
    if (fit.size() == 1)
        return fit.front();
    if (fit.size() > 1)
        return severalFit(wanted, fit);
    for (const UsbId &id : wanted.ids) {
        const KernelDriverReport report = kernel(id);
        const Status status = report.status();
        if (!status && report.state != KernelDriverState::NotPluggedIn)
            return status.error();
    }
    return notPluggedIn(wanted);
}

} // namespace

std::vector<UsbId> nativeIds(const std::vector<UsbId> &chosen)
{
    return chosen.empty() ? std::vector<UsbId>{{BRIDGE_VENDOR_ID, BRIDGE_PRODUCT_ID}} : chosen;
}

bool hasId(const HidIdentity &identity, const std::vector<UsbId> &ids)
{
    return std::ranges::find(ids, UsbId{identity.vendorId, identity.productId}) != ids.end();
}

std::vector<HidIdentity> withoutOtherInterfaces(const std::vector<HidIdentity> &devices)
{
    const auto isOtherInterface = [&](const HidIdentity &device) {
        if (i2cChipOf(device) != I2cChip::Ft260 || device.interfaceNumber <= 0)
            return false;
        return std::ranges::any_of(devices, [&](const HidIdentity &other) {
            return i2cChipOf(other) == I2cChip::Ft260 && other.serial == device.serial &&
                   other.interfaceNumber == 0;
        });
    };
    std::vector<HidIdentity> meant;
    std::ranges::remove_copy_if(devices, std::back_inserter(meant), isOtherInterface);
    return meant;
}

Result<HidIdentity> findNativeBridge(const std::vector<HidIdentity> &plugged, const NativeChoice &choice,
                                     const KernelReports &kernel)
{
    return find(plugged, {"native gyro bridge", choice.serial, nativeIds(choice.ids), "hid:", ""}, kernel);
}

Result<HidIdentity> findI2cChip(const std::vector<HidIdentity> &plugged, const I2cChoice &choice,
                                const KernelReports &kernel)
{
    const I2cChipDescription &chip = describe(choice.chip);
    return find(plugged,
                {std::string(chip.name),
                 choice.serial,
                 {{chip.vendorId, chip.productId}},
                 "i2c:" + std::string(chip.key) + ":",
                 "/auto"},
                kernel);
}

} // namespace driftbench
