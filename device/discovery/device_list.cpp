#include "device/discovery/device_list.h"

#include "device/bridge/bridge_protocol.h"
#include "engine/base/text.h"

#include <algorithm>
#include <tuple>

namespace driftbench {

namespace {

bool isSameDevice(const HidIdentity &left, const HidIdentity &right)
{
    const bool sameId = left.vendorId == right.vendorId && left.productId == right.productId;
    return sameId && (left.serial.empty() ? left.path == right.path : left.serial == right.serial);
}

bool isIn(const std::vector<HidIdentity> &devices, const HidIdentity &identity)
{
    return std::ranges::any_of(devices,
                               [&](const HidIdentity &device) { return isSameDevice(device, identity); });
}

bool isSimulated(const HidIdentity &identity)
{
    return identity.path.starts_with("simulated:");
}

bool same(const Status &left, const Status &right)
{
    if (left.ok() || right.ok())
        return left.ok() == right.ok();
    return left.error().code == right.error().code && left.error().message == right.error().message;
}

bool same(const std::optional<DeviceDetails> &left, const std::optional<DeviceDetails> &right)
{
    const auto parts = [](const DeviceDetails &details) {
        return std::tie(details.sensor.model, details.sensor.serial, details.firmware, details.protocol,
                        details.thermometer);
    };
    return left.has_value() == right.has_value() && (!left || parts(*left) == parts(*right));
}

bool sameEntry(const DeviceEntry &left, const DeviceEntry &right)
{
    return left.kind == right.kind && left.chip == right.chip && left.source == right.source &&
           left.identity.path == right.identity.path && left.identity.serial == right.identity.serial &&
           same(left.details, right.details) && left.inUse == right.inUse && same(left.status, right.status);
}

DeviceEntry simulatedEntry()
{
    DeviceEntry entry{DeviceKind::SimulatedBridge};
    entry.name = "simulated bridge";
    entry.source = "simulated";
    entry.identity = {BRIDGE_VENDOR_ID, BRIDGE_PRODUCT_ID, "Driftbench", "Simulated gyro bridge", "", "", 0};
    return entry;
}

// Its serial number, or its path where that is empty or another one has the same.
std::string handleOf(const HidIdentity &device, const std::vector<HidIdentity> &all)
{
    const auto twins = std::ranges::count_if(all, [&](const HidIdentity &other) {
        return other.vendorId == device.vendorId && other.productId == device.productId &&
               other.serial == device.serial;
    });
    return device.serial.empty() || twins > 1 ? device.path : device.serial;
}

DeviceEntry nativeEntry(const HidIdentity &device, const std::string &handle)
{
    DeviceEntry entry{DeviceKind::NativeBridge};
    entry.name = "native gyro bridge";
    entry.source = handle.empty() ? "hid" : "hid:" + handle;
    entry.identity = device;
    return entry;
}

DeviceEntry chipEntry(I2cChip chip, const HidIdentity &device, const std::string &handle)
{
    DeviceEntry entry{DeviceKind::I2cChip, chip};
    entry.name = describe(chip).name;
    entry.source = "i2c:" + std::string(describe(chip).key) + (handle.empty() ? "" : ":" + handle) + "/auto";
    entry.identity = device;
    return entry;
}

// What the kernel keeps away, if none of its kind is seen.
void addKept(DeviceList &list, const std::vector<HidIdentity> &seen, const KernelReports &kernel,
             DeviceEntry entry)
{
    const UsbId id{entry.identity.vendorId, entry.identity.productId};
    if (std::ranges::any_of(seen, [&](const HidIdentity &device) { return hasId(device, {id}); }))
        return;
    const KernelDriverReport report = kernel(id);
    entry.status = report.status();
    if (report.state != KernelDriverState::NotPluggedIn && !entry.status)
        list.push_back(std::move(entry));
}

DeviceEntry lostEntry(const HidIdentity &device)
{
    const auto chip = i2cChipOf(device);
    const std::string handle = device.serial.empty() ? device.path : device.serial;
    DeviceEntry entry = chip ? chipEntry(*chip, device, handle) : nativeEntry(device, handle);
    entry.inUse = true;
    entry.status = Error{Errc::DeviceUnplugged, "The " + entry.name + " " + handle +
                                                    " was unplugged while it was in use; plug it in again."};
    return entry;
}

} // namespace

std::string DeviceEntry::identityText() const
{
    const std::string handle = identity.serial.empty() ? identity.path : identity.serial;
    if (kind == DeviceKind::SimulatedBridge)
        return "inside this program";
    if (kind == DeviceKind::NativeBridge)
        return details ? details->sensor.text() : handle;
    if (!details)
        return handle;
    return handle + (handle.empty() ? "" : " with ") + details->sensor.model +
           (details->thermometer.empty() ? "" : " and " + details->thermometer);
}

std::string DeviceEntry::sentence() const
{
    if (!status)
        return status.error().message;
    if (inUse)
        return "This program is using it.";
    return kind == DeviceKind::SimulatedBridge ? "It is always there and needs no hardware."
                                               : "It can be used.";
}

bool sameDevices(const DeviceList &left, const DeviceList &right)
{
    return std::ranges::equal(left, right, sameEntry);
}

std::string_view deviceStatusText(const DeviceEntry &entry)
{
    if (entry.status)
        return entry.inUse ? "in use here" : "ready";
    switch (entry.status.error().code) {
    case Errc::DeviceNotFound:
        return "gone";
    case Errc::DeviceNotPermitted:
        return "not permitted";
    case Errc::DeviceHeldByKernel:
        return "held by the kernel";
    case Errc::DeviceInUse:
        return "in use elsewhere";
    case Errc::DeviceUnplugged:
        return "unplugged";
    case Errc::DeviceSilent:
        return "silent";
    case Errc::ProtocolVersion:
        return "other protocol";
    case Errc::WrongSensor:
        return "wrong sensor";
    case Errc::BusNoAcknowledge:
        return "no sensor answers";
    case Errc::BusStuck:
        return "bus stuck";
    case Errc::DamagedReport:
        return "damaged reports";
    default:
        return "refused";
    }
}

Status somethingPluggedIn(const DeviceList &list)
{
    const bool any = std::ranges::any_of(
        list, [](const DeviceEntry &entry) { return entry.kind != DeviceKind::SimulatedBridge; });
    if (any)
        return {};
    return Error{Errc::DeviceNotFound,
                 "No device is plugged in; plug in a native gyro bridge, an MCP2221A, a CP2112 or an FT260, "
                 "or use the simulated bridge."};
}

DeviceList listDevices(const std::vector<HidIdentity> &seen, const KernelReports &kernel,
                       const DeviceListOptions &options)
{
    const std::vector<UsbId> native = nativeIds(options.nativeIds);
    const std::vector<HidIdentity> devices = withoutOtherInterfaces(seen);
    DeviceList list{simulatedEntry()};
    list.front().inUse = std::ranges::any_of(options.inUse, isSimulated);
    for (const HidIdentity &device : devices) {
        if (hasId(device, native))
            list.push_back(nativeEntry(device, handleOf(device, devices)));
    }
    for (const I2cChipDescription &chip : i2cChips()) {
        for (const HidIdentity &device : devices) {
            if (hasId(device, {{chip.vendorId, chip.productId}}))
                list.push_back(chipEntry(chip.chip, device, handleOf(device, devices)));
        }
    }
    for (DeviceEntry &entry : list)
        entry.inUse = entry.inUse || isIn(options.inUse, entry.identity);
    for (const UsbId &id : native)
        addKept(list, seen, kernel, nativeEntry({id.vendorId, id.productId, "", "", "", "", -1}, ""));
    for (const I2cChipDescription &chip : i2cChips())
        addKept(list, seen, kernel,
                chipEntry(chip.chip, {chip.vendorId, chip.productId, "", "", "", "", -1}, ""));
    for (const HidIdentity &device : options.inUse) {
        if (!isSimulated(device) && !device.path.empty() && !isIn(devices, device))
            list.push_back(lostEntry(device));
    }
    return list;
}

void takeDetails(DeviceEntry &entry, const Result<DeviceDetails> &found)
{
    if (!found) {
        entry.status = found.error();
        return;
    }
    entry.details = *found;
    entry.status = {};
    if (entry.kind != DeviceKind::I2cChip)
        return;
    // What answers there can be named now.
    const std::size_t gyro = entry.source.rfind('/');
    entry.source = entry.source.substr(0, gyro + 1) + lowered(found->sensor.model) +
                   (found->thermometer.empty() ? "" : "+" + lowered(found->thermometer));
}

} // namespace driftbench
