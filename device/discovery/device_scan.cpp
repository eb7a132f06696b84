#include "device/discovery/device_scan.h"

#include "device/bridge/bridge_client.h"
#include "device/gyros/st_gyro.h"

namespace driftbench {

namespace {

constexpr int kBusKHz = 100; // that of the slowest sensor

Result<DeviceDetails> lookIntoNative(std::unique_ptr<HidTransport> transport, HostClock &clock)
{
    const auto client = BridgeClient::open(std::move(transport), clock);
    if (!client)
        return client.error();
    const BridgeInfo &info = client->info();
    return DeviceDetails{info.sensor, info.firmwareText(),
                         std::to_string(info.major) + "." + std::to_string(info.minor),
                         info.can(BRIDGE_CAN_EXTERNAL) ? "external" : ""};
}

Result<DeviceDetails> lookOntoBus(I2cChip chip, std::unique_ptr<HidTransport> transport)
{
    const auto bus = openI2cChip(chip, std::move(transport), kBusKHz);
    if (!bus)
        return bus.error();
    const auto gyro = StGyro::find(**bus);
    if (!gyro)
        return gyro.error();
    const auto thermometer = I2cThermometer::find(**bus);
    if (!thermometer)
        return thermometer.error();
    return DeviceDetails{{std::string(gyro->description().model), ""},
                         "",
                         "",
                         *thermometer ? std::string(thermometerName((*thermometer)->model())) : ""};
}

// Whether the same look may end otherwise although nothing was plugged in or out.
bool maySoonDiffer(Errc code)
{
    switch (code) {
    case Errc::DeviceNotFound:
    case Errc::DeviceNotPermitted:
    case Errc::DeviceHeldByKernel:
    case Errc::DeviceInUse:
    case Errc::DeviceUnplugged:
        return true;
    default:
        return false;
    }
}

std::string keyOf(const DeviceEntry &entry)
{
    return entry.identity.path + '\n' + entry.identity.serial;
}

} // namespace

DeviceList DeviceScanner::scan(const ScanRequest &request)
{
    const KernelReports kernel = [this](UsbId id) {
        return kernelDriverState(m_access.sysfs, id.vendorId, id.productId);
    };
    DeviceList list = listDevices(m_access.list(), kernel, {m_nativeIds, request.inUse});
    std::map<std::string, Result<DeviceDetails>> before;
    before.swap(m_known);
    for (DeviceEntry &entry : list) {
        if (entry.kind == DeviceKind::SimulatedBridge || !entry.status)
            continue;
        const auto known = before.find(keyOf(entry));
        if (known != before.end() && (!request.afresh || entry.inUse)) {
            takeDetails(entry, known->second);
            m_known.insert(*known);
        } else if (!entry.inUse) {
            lookInside(entry);
        }
    }
    return list;
}

void DeviceScanner::lookInside(DeviceEntry &entry)
{
    if (entry.chip && m_access.heldElsewhere && m_access.heldElsewhere(entry.identity)) {
        entry.status = Error{Errc::DeviceInUse, "Another program holds the " + entry.name + " at " +
                                                    entry.identity.path + "; close that program."};
        return;
    }
    auto transport = m_access.open(entry.identity);
    SteadyClock steady;
    HostClock &clock = m_access.clock ? *m_access.clock : steady;
    const Result<DeviceDetails> found = !transport   ? Result<DeviceDetails>(transport.error())
                                        : entry.chip ? lookOntoBus(*entry.chip, *std::move(transport))
                                                     : lookIntoNative(*std::move(transport), clock);
    takeDetails(entry, found);
    if (found || !maySoonDiffer(found.error().code))
        m_known.insert_or_assign(keyOf(entry), found);
}

} // namespace driftbench
