#include "engine/exports/device_compensation.h"

#include <algorithm>
#include <cassert>

namespace driftbench {

namespace {

constexpr std::int32_t kMostCounts = 65536;

std::int32_t countsOfUnits(std::int32_t units, int fractionBits, std::uint16_t sensitivity)
{
    int bits = 0;
    while ((std::uint64_t{100000} << bits) / sensitivity < (std::uint64_t{1} << 30))
        ++bits;
    const auto multiplier = static_cast<std::int64_t>((std::uint64_t{100000} << bits) / sensitivity);
    const int shift = bits + fractionBits;
    // C++20 defines the shift of a negative number as rounding down.
    const std::int64_t counts = (units * multiplier + (std::int64_t{1} << (shift - 1))) >> shift;
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(counts, -kMostCounts, kMostCounts));
}

std::int32_t countsOfDps(float dps, std::uint16_t sensitivity)
{
    const float counts = dps * (100000.0F / static_cast<float>(sensitivity));
    const float held = std::clamp(counts, -65536.0F, 65536.0F);
    const auto rounded = static_cast<std::int32_t>(held < 0.0F ? held - 0.5F : held + 0.5F);
    return std::clamp(rounded, -kMostCounts, kMostCounts);
}

} // namespace

DeviceCompensation::DeviceCompensation(const DeviceImage &image, std::uint16_t sensitivity)
    : m_fixed(image.fixed), m_sensitivity(sensitivity)
{
    assert(sensitivity > 0);
    if (!m_fixed)
        m_float.emplace(image.table);
}

std::array<std::int32_t, 3> DeviceCompensation::tdeCounts(std::int32_t temperatureMilliC) const
{
    std::array<std::int32_t, 3> counts{};
    if (m_fixed) {
        const auto units = tdeUnits(*m_fixed, temperatureMilliC);
        for (std::size_t axis = 0; axis < 3; ++axis)
            counts[axis] = countsOfUnits(units[axis], m_fixed->fractionBits, m_sensitivity);
        return counts;
    }
    const TableApply<float>::Column temperatureC =
        TableApply<float>::Column::Constant(1, static_cast<float>(temperatureMilliC) / 1000.0F);
    const TableApply<float>::Columns tdeDps = m_float->tde(temperatureC);
    for (std::size_t axis = 0; axis < 3; ++axis)
        counts[axis] = countsOfDps(tdeDps(0, static_cast<Eigen::Index>(axis)), m_sensitivity);
    return counts;
}

std::int16_t DeviceCompensation::compensated(std::int16_t rawCounts, std::int32_t tdeCounts)
{
    return static_cast<std::int16_t>(std::clamp<std::int32_t>(rawCounts - tdeCounts, INT16_MIN, INT16_MAX));
}

} // namespace driftbench
