// A HID device as bytes: the one way by which every driver here reaches its hardware, the simulated bridge or
// a device model of the tests.
//
// Byte 0 of every buffer is the report id, 0 for devices whose reports are not numbered: a write of 64 bytes
// to such a device takes a buffer of 65. What a read returns has an id in byte 0 only if the reports are
// numbered, as hidapi does it.
//
// Errors: DeviceUnplugged once the device is gone, whatever is called; DeviceRefused where the device does
// not take or answer a report; DeviceSilent where an answer does not come in time. After DeviceUnplugged
// nothing but destruction makes sense.
#pragma once

#include "engine/base/result.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace driftbench {

struct HidIdentity
{
    std::uint16_t vendorId = 0;
    std::uint16_t productId = 0;
    std::string manufacturer; // may be empty
    std::string product;      // may be empty
    std::string serial;       // may be empty
    std::string path;         // what opens it: "/dev/hidraw3", "simulated:SIM-0001"
    int interfaceNumber = -1; // -1: not known
};

class HidTransport
{
public:
    virtual ~HidTransport() = default;

    virtual const HidIdentity &identity() const = 0;

    // The next input report; 0 bytes if none came in time. Longer reports are cut to the buffer.
    virtual Result<std::size_t> read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout) = 0;
    virtual Status write(std::span<const std::uint8_t> report) = 0;
    // report[0] names the report; how many bytes came, the id included.
    virtual Result<std::size_t> getFeature(std::span<std::uint8_t> report) = 0;
    virtual Status sendFeature(std::span<const std::uint8_t> report) = 0;

protected:
    HidTransport() = default;
    HidTransport(const HidTransport &) = default;
    HidTransport &operator=(const HidTransport &) = default;
};

} // namespace driftbench
