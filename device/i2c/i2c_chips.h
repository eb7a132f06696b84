// The USB-to-I2C bridges that are known, as data, and one way to open whichever it is.
#pragma once

#include "device/hid_transport.h"
#include "device/i2c/i2c_bus.h"

#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace driftbench {

enum class I2cChip
{
    Mcp2221a,
    Cp2112,
    Ft260
};

struct I2cChipDescription
{
    I2cChip chip;
    std::string_view name; // "MCP2221A"
    std::string_view key;  // "mcp2221a", as users write it
    std::uint16_t vendorId;
    std::uint16_t productId;
    std::string_view kernelModule; // of the kernel's own driver
    bool needsKernelModule;        // hid-generic refuses the chip
};

std::span<const I2cChipDescription> i2cChips();
const I2cChipDescription &describe(I2cChip chip);
std::optional<I2cChip> i2cChipNamed(std::string_view key); // capitals do not matter
std::optional<I2cChip> i2cChipOf(const HidIdentity &identity);

// The errors of Mcp2221a, Cp2112 and Ft260.
Result<std::unique_ptr<I2cBus>> openI2cChip(I2cChip chip, std::unique_ptr<HidTransport> transport, int kHz);

} // namespace driftbench
