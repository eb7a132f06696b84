#include "device/i2c/hid_exchange.h"

#include <algorithm>

namespace driftbench {

namespace {

// More than any queue between the bridge and here holds (hidraw: 64).
constexpr int kMostPending = 128;

} // namespace

Result<std::span<const std::uint8_t>> awaitReport(HidTransport &transport, std::uint8_t first,
                                                  std::uint8_t last, std::span<std::uint8_t> buffer,
                                                  std::chrono::milliseconds timeout)
{
    for (int dropped = 0; dropped < kMostPending; ++dropped) {
        const Result<std::size_t> size = transport.read(buffer, timeout);
        if (!size)
            return size.error();
        if (*size == 0)
            break;
        if (buffer[0] >= first && buffer[0] <= last)
            return std::span<const std::uint8_t>(buffer.first(std::min(*size, buffer.size())));
    }
    return std::span<const std::uint8_t>{};
}

Status discardReports(HidTransport &transport)
{
    std::uint8_t buffer[64];
    for (int dropped = 0; dropped < kMostPending; ++dropped) {
        const Result<std::size_t> size = transport.read(buffer, std::chrono::milliseconds(0));
        if (!size)
            return size.error();
        if (*size == 0)
            break;
    }
    return {};
}

std::string bridgeName(const std::string &chip, const HidIdentity &identity)
{
    const std::string &which = identity.serial.empty() ? identity.path : identity.serial;
    return which.empty() ? chip : chip + " " + which;
}

Error bridgeSilent(const std::string &name)
{
    return {Errc::DeviceSilent, name + " does not answer; unplug it and plug it in again."};
}

} // namespace driftbench
