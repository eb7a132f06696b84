#include "device/discovery/kernel_driver_state.h"

#include "device/i2c/i2c_chips.h"

#include <algorithm>
#include <system_error>

namespace driftbench {

namespace {

namespace fs = std::filesystem;

std::string hexWord(std::uint16_t word, const char *digits)
{
    std::string text;
    for (int shift = 12; shift >= 0; shift -= 4)
        text += digits[word >> shift & 15];
    return text;
}

// A native bridge has no driver of its own.
I2cChipDescription chipOf(std::uint16_t vendorId, std::uint16_t productId)
{
    HidIdentity identity;
    identity.vendorId = vendorId;
    identity.productId = productId;
    if (const auto chip = i2cChipOf(identity))
        return describe(*chip);
    return {{}, "HID device", "", vendorId, productId, "", false};
}

// The last part of where a link leads; empty if there is none.
std::string linkedName(const fs::path &link)
{
    std::error_code error;
    const fs::path target = fs::read_symlink(link, error);
    return error ? std::string() : target.filename().string();
}

std::vector<std::string> namesIn(const fs::path &folder)
{
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string adviceFor(const I2cChipDescription &chip, const KernelDriverReport &report, bool moduleLoaded)
{
    const char *const kLower = "0123456789abcdef";
    const std::string device =
        std::string(chip.name) + " " + hexWord(chip.vendorId, kLower) + ":" + hexWord(chip.productId, kLower);
    switch (report.state) {
    case KernelDriverState::NotPluggedIn:
        return "No " + device + " is plugged in.";
    case KernelDriverState::HeldByDriver: {
        const std::string module = report.module.empty() ? std::string(chip.kernelModule) : report.module;
        if (chip.needsKernelModule || module.empty())
            return "The kernel driver " + report.driver + " holds the " + device +
                   " and gives no hidraw; unplug it and plug it in again.";
        return "The kernel driver " + report.driver + " holds the " + device + "; run \"sudo rmmod " +
               module + "\" and write \"blacklist " + module +
               "\" into /etc/modprobe.d/driftbench.conf, which needs no replugging.";
    }
    case KernelDriverState::NoDriver:
        if (chip.needsKernelModule && !moduleLoaded)
            return "The " + device +
                   " has no kernel driver, and no other than its own takes it; run \"sudo modprobe " +
                   std::string(chip.kernelModule) + "\" and never blacklist it.";
        if (moduleLoaded)
            return "The kernel driver " + std::string(chip.kernelModule) + " could not start the " + device +
                   "; unplug it and plug it in again.";
        return "The " + device + " has no kernel driver; run \"sudo modprobe hid_generic\".";
    case KernelDriverState::Usable:
        break;
    }
    return {};
}

} // namespace

Status KernelDriverReport::status() const
{
    switch (state) {
    case KernelDriverState::NotPluggedIn:
        return Error{Errc::DeviceNotFound, advice};
    case KernelDriverState::HeldByDriver:
    case KernelDriverState::NoDriver:
        return Error{Errc::DeviceHeldByKernel, advice};
    case KernelDriverState::Usable:
        break;
    }
    return {};
}

KernelDriverReport kernelDriverState(const fs::path &sysfs, std::uint16_t vendorId, std::uint16_t productId)
{
    const char *const kUpper = "0123456789ABCDEF";
    const std::string prefix = "0003:" + hexWord(vendorId, kUpper) + ":" + hexWord(productId, kUpper) + ".";
    const fs::path devices = sysfs / "bus" / "hid" / "devices";
    KernelDriverReport report;
    for (const std::string &name : namesIn(devices)) {
        if (name.rfind(prefix, 0) != 0)
            continue;
        const fs::path device = devices / name;
        const std::vector<std::string> nodes = namesIn(device / "hidraw");
        const std::string driver = linkedName(device / "driver");
        const KernelDriverState state = !nodes.empty()   ? KernelDriverState::Usable
                                        : driver.empty() ? KernelDriverState::NoDriver
                                                         : KernelDriverState::HeldByDriver;
        // Usable is best; a driver that holds one of two says more than the other one's lack of a driver.
        const bool better =
            report.state == KernelDriverState::NotPluggedIn || state == KernelDriverState::Usable ||
            (state == KernelDriverState::HeldByDriver && report.state == KernelDriverState::NoDriver);
        report.hidrawNodes.insert(report.hidrawNodes.end(), nodes.begin(), nodes.end());
        if (!better)
            continue;
        report.state = state;
        report.driver = driver;
        report.module = linkedName(device / "driver" / "module");
    }
    const I2cChipDescription chip = chipOf(vendorId, productId);
    std::error_code error;
    report.advice = adviceFor(
        chip, report, !chip.kernelModule.empty() && fs::exists(sysfs / "module" / chip.kernelModule, error));
    return report;
}

} // namespace driftbench
