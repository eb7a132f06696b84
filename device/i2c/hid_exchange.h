// What the USB bridges share: waiting for the report that answers a request.
#pragma once

#include "device/hid_transport.h"

#include <chrono>
#include <cstdint>
#include <span>
#include <string>

namespace driftbench {

// The next report whose first byte lies in first..last; others, which answer requests that were given up, are
// dropped. Empty if none came in time.
Result<std::span<const std::uint8_t>> awaitReport(HidTransport &transport, std::uint8_t first,
                                                  std::uint8_t last, std::span<std::uint8_t> buffer,
                                                  std::chrono::milliseconds timeout);

// Drops the reports that wait to be read.
Status discardReports(HidTransport &transport);

// "MCP2221A 0002137645": the chip and its serial number, else its path.
std::string bridgeName(const std::string &chip, const HidIdentity &identity);

Error bridgeSilent(const std::string &name);

} // namespace driftbench
