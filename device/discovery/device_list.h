// What is plugged in, each with what it is, how a source is chosen from it and whether it can be used: the
// list a user chooses from. Pure: what was seen goes in, the list comes out; device_scan.h looks.
//
// The simulated bridge is always there and comes first. Then native bridges, then I2C chips; those that a
// kernel driver keeps away, which have no hidraw; and what this program uses and has lost. Devices are told
// by their USB ids alone: some systems know neither manufacturer nor interface nor bus.
#pragma once

#include "device/discovery/device_match.h"
#include "device/hid_transport.h"
#include "device/source_choice.h"
#include "engine/recording/recording.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

enum class DeviceKind
{
    SimulatedBridge,
    NativeBridge,
    I2cChip
};

// From a look inside.
struct DeviceDetails
{
    SensorIdentity sensor;   // of I2C chips: the gyro that answers; no serial number
    std::string firmware;    // "1.0.0", of native bridges
    std::string protocol;    // "1.0", of native bridges
    std::string thermometer; // "TMP117"; "external" of native bridges; empty: that of the die alone
};

struct DeviceEntry
{
    DeviceKind kind = DeviceKind::SimulatedBridge;
    std::optional<I2cChip> chip{};
    std::string name{};     // "native gyro bridge", "MCP2221A"
    std::string source{};   // what parseSourceChoice takes
    HidIdentity identity{}; // without path where there is no hidraw
    std::optional<DeviceDetails> details{};
    bool inUse = false; // by this program, which leaves it alone
    // Fine, or what keeps it from being used: DeviceNotPermitted, DeviceHeldByKernel, DeviceInUse,
    // BusNoAcknowledge, BusStuck, DeviceUnplugged, ProtocolVersion, WrongSensor, and the other errors of the
    // drivers.
    Status status{};

    bool usable() const { return status.ok() && !inUse; }
    std::string identityText() const; // "I3G4250D SIM-0001", "0002137645 with L3GD20H"
    std::string sentence() const;     // of the status
};

using DeviceList = std::vector<DeviceEntry>;

bool sameDevices(const DeviceList &left, const DeviceList &right);

// "ready", "in use here", "not permitted", "bus stuck": the status in a word or two.
std::string_view deviceStatusText(const DeviceEntry &entry);

// DeviceNotFound with what to do where nothing is plugged in beside the simulated bridge.
Status somethingPluggedIn(const DeviceList &list);

struct DeviceListOptions
{
    std::vector<UsbId> nativeIds{};   // none: the protocol's own
    std::vector<HidIdentity> inUse{}; // by this program
};

// Without details. kernel is asked for the ids of which no HID device is seen.
DeviceList listDevices(const std::vector<HidIdentity> &seen, const KernelReports &kernel,
                       const DeviceListOptions &options);

// What a look inside has found.
void takeDetails(DeviceEntry &entry, const Result<DeviceDetails> &found);

} // namespace driftbench
