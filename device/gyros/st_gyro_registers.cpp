#include "device/gyros/st_gyro_registers.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace driftbench::st_gyro {

namespace {

constexpr std::array kRanges{
    RangeSetting{245.0, 0.00875, 0x00},
    RangeSetting{500.0, 0.0175, 0x10},
    RangeSetting{2000.0, 0.07, 0x20},
};

constexpr std::array kL3gd20hRates{
    RateSetting{12.5, 0x00, 0x01},  RateSetting{25.0, 0x40, 0x01},  RateSetting{50.0, 0x80, 0x01},
    RateSetting{100.0, 0x00, 0x00}, RateSetting{200.0, 0x40, 0x00}, RateSetting{400.0, 0x80, 0x00},
    RateSetting{800.0, 0xC0, 0x00},
};

constexpr std::array kI3g4250dRates{
    RateSetting{100.0, 0x00, 0x00},
    RateSetting{200.0, 0x40, 0x00},
    RateSetting{400.0, 0x80, 0x00},
    RateSetting{800.0, 0xC0, 0x00},
};

constexpr std::array kDescriptions{
    Description{"I3G4250D", 0xD3, {0x68, 0x69}, false, false, kRanges, kI3g4250dRates},
    Description{"L3GD20H", 0xD7, {0x6A, 0x6B}, true, true, kRanges, kL3gd20hRates},
};

constexpr std::uint8_t kFifoOverrun = 0x40;
constexpr std::uint8_t kFifoEmpty = 0x20;
constexpr std::uint8_t kFifoLevel = 0x1F;

} // namespace

std::span<const Description> descriptions()
{
    return kDescriptions;
}

const Description *descriptionOf(std::string_view model)
{
    const auto found = std::find_if(kDescriptions.begin(), kDescriptions.end(),
                                    [&](const Description &known) { return known.model == model; });
    return found != kDescriptions.end() ? &*found : nullptr;
}

std::string_view modelOfWhoAmI(std::uint8_t whoAmI)
{
    switch (whoAmI) {
    case 0xD3:
        return "I3G4250D or L3G4200D";
    case 0xD4:
        return "L3GD20";
    case 0xD7:
        return "L3GD20H";
    default:
        return {};
    }
}

std::optional<RangeSetting> rangeFor(const Description &description, double rangeDps)
{
    for (const RangeSetting &range : description.ranges) {
        if (range.rangeDps >= rangeDps)
            return range;
    }
    return {};
}

std::optional<RateSetting> rateFor(const Description &description, double rateHz)
{
    for (const RateSetting &rate : description.rates) {
        if (rate.rateHz >= rateHz)
            return rate;
    }
    return {};
}

FifoState decodeFifoState(std::uint8_t fifoSrc)
{
    FifoState state;
    state.full = (fifoSrc & kFifoOverrun) != 0;
    if (state.full)
        state.samples = kFifoSamples;
    else if ((fifoSrc & kFifoEmpty) == 0)
        state.samples = fifoSrc & kFifoLevel;
    return state;
}

Counts decodeCounts(std::span<const std::uint8_t> bytes, std::size_t sample)
{
    assert((sample + 1) * kBytesPerSample <= bytes.size());
    Counts counts;
    for (std::size_t axis = 0; axis < counts.size(); ++axis) {
        const std::size_t at = sample * kBytesPerSample + 2 * axis;
        counts[axis] = static_cast<std::int16_t>(bytes[at] | bytes[at + 1] << 8);
    }
    return counts;
}

bool saturated(const Counts &counts)
{
    return std::any_of(counts.begin(), counts.end(), [](std::int16_t count) {
        return count == std::numeric_limits<std::int16_t>::max() ||
               count == std::numeric_limits<std::int16_t>::min();
    });
}

int decodeDieCount(std::uint8_t outTemp)
{
    return static_cast<std::int8_t>(outTemp);
}

} // namespace driftbench::st_gyro
