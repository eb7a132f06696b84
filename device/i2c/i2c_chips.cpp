#include "device/i2c/i2c_chips.h"

#include "device/i2c/cp2112.h"
#include "device/i2c/ft260.h"
#include "device/i2c/mcp2221a.h"
#include "engine/base/text.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace driftbench {

namespace {

// In the order of I2cChip.
constexpr std::array kChips{
    I2cChipDescription{I2cChip::Mcp2221a, "MCP2221A", "mcp2221a", mcp2221a::kVendorId, mcp2221a::kProductId,
                       "hid_mcp2221", false},
    I2cChipDescription{I2cChip::Cp2112, "CP2112", "cp2112", cp2112::kVendorId, cp2112::kProductId,
                       "hid_cp2112", true},
    I2cChipDescription{I2cChip::Ft260, "FT260", "ft260", ft260::kVendorId, ft260::kProductId, "hid_ft260",
                       false},
};

template <class Driver>
Result<std::unique_ptr<I2cBus>> openAs(std::unique_ptr<HidTransport> transport, int kHz)
{
    auto bus = Driver::open(std::move(transport), kHz);
    if (!bus)
        return bus.error();
    return std::unique_ptr<I2cBus>(*std::move(bus));
}

} // namespace

std::span<const I2cChipDescription> i2cChips()
{
    return kChips;
}

const I2cChipDescription &describe(I2cChip chip)
{
    return kChips[static_cast<std::size_t>(chip)];
}

std::optional<I2cChip> i2cChipNamed(std::string_view key)
{
    const std::string name = lowered(key);
    const auto found = std::ranges::find(kChips, name, &I2cChipDescription::key);
    return found != kChips.end() ? std::optional(found->chip) : std::nullopt;
}

std::optional<I2cChip> i2cChipOf(const HidIdentity &identity)
{
    const auto found = std::ranges::find_if(kChips, [&](const I2cChipDescription &chip) {
        return chip.vendorId == identity.vendorId && chip.productId == identity.productId;
    });
    return found != kChips.end() ? std::optional(found->chip) : std::nullopt;
}

Result<std::unique_ptr<I2cBus>> openI2cChip(I2cChip chip, std::unique_ptr<HidTransport> transport, int kHz)
{
    switch (chip) {
    case I2cChip::Mcp2221a:
        return openAs<Mcp2221a>(std::move(transport), kHz);
    case I2cChip::Cp2112:
        return openAs<Cp2112>(std::move(transport), kHz);
    case I2cChip::Ft260:
        return openAs<Ft260>(std::move(transport), kHz);
    }
    assert(false);
    return Error{Errc::InvalidOption, "There is no such bridge."};
}

} // namespace driftbench
