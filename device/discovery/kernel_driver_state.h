// What the Linux kernel does with the USB bridges that one can buy, read from sysfs, and what the user must
// do so that they can be opened through hidraw.
//
// For every /sys/bus/hid/devices/0003:<VID>:<PID>.* the link "driver", its link "module" and the directory
// "hidraw" tell: the kernel's own driver may keep hidraw away (MCP2221A), be the only one that gives it
// (CP2112, which hid-generic refuses) or do so like hid-generic (FT260).
#pragma once

#include "engine/base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace driftbench {

enum class KernelDriverState
{
    NotPluggedIn,
    HeldByDriver, // a driver that gives no hidraw
    NoDriver,     // plugged in, and no driver took it
    Usable,       // hidraw is there; whether it may be opened is a matter of permission
};

struct KernelDriverReport
{
    KernelDriverState state = KernelDriverState::NotPluggedIn;
    std::string driver;                   // "mcp2221", empty: none
    std::string module;                   // "hid_mcp2221", empty: none, or built in
    std::vector<std::string> hidrawNodes; // "hidraw3"; more than one: interfaces or several devices
    std::string advice;                   // what is the matter and what to do, a sentence; empty if usable

    // DeviceNotFound, DeviceHeldByKernel or fine, with the advice.
    Status status() const;
};

// Several of one kind: the best that one of them has. sysfs is "/sys", or a tree made like it.
KernelDriverReport kernelDriverState(const std::filesystem::path &sysfs, std::uint16_t vendorId,
                                     std::uint16_t productId);

} // namespace driftbench
