#include "engine/compensation/fixed_point_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace driftbench {

namespace {

constexpr int kMostFractionBits = 30;
constexpr int kFewestFractionBits = -30;
constexpr double kValueLimit = 1073741824.0; // 2^30

int chooseFractionBits(double largestDps)
{
    int bits = kMostFractionBits;
    // Rounding may carry a value up to the next integer, which must still lie below the limit.
    while (bits > kFewestFractionBits && std::ldexp(largestDps, bits) + 0.5 >= kValueLimit)
        --bits;
    return bits;
}

void setReciprocal(FixedPointTable &fixed, std::uint64_t cells)
{
    const auto span = static_cast<std::uint64_t>(fixed.lastMilliC - fixed.firstMilliC);
    // cells <= span < 2^20, so that cells << (16 + shift) stays below 2^31 * 2^20.
    while (((cells << (16 + fixed.shift)) / span) < (std::uint64_t{1} << 30))
        ++fixed.shift;
    fixed.reciprocal = static_cast<std::uint32_t>((cells << (16 + fixed.shift)) / span);
}

} // namespace

double FixedPointTable::dpsPerUnit() const
{
    return std::ldexp(1.0, -fractionBits);
}

FixedPointTable makeFixedPointTable(const CompensationTable &table)
{
    assert(table.size() >= 2 && table.tdeDps.allFinite());
    FixedPointTable fixed;
    fixed.firstMilliC = table.firstMilliC;
    fixed.lastMilliC = table.lastMilliC;
    fixed.fractionBits = chooseFractionBits(table.tdeDps.cwiseAbs().maxCoeff());
    setReciprocal(fixed, static_cast<std::uint64_t>(table.size() - 1));

    fixed.values.resize(static_cast<std::size_t>(table.size()));
    std::int64_t steepest = 0;
    for (std::size_t i = 0; i < fixed.values.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double dps = table.tdeDps(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(axis));
            fixed.values[i][axis] =
                static_cast<std::int32_t>(std::lround(std::ldexp(dps, fixed.fractionBits)));
            if (i > 0) {
                const std::int64_t difference =
                    std::int64_t{fixed.values[i][axis]} - fixed.values[i - 1][axis];
                steepest = std::max(steepest, std::abs(difference));
            }
        }
    }
    // In units of the last bit. The knots' own rounding may have made the steepest cell one unit flatter.
    const double difference = static_cast<double>(steepest + 1);
    const double cells = static_cast<double>(table.size() - 1);
    fixed.errorBoundDps = (1.0 + difference * (1.0 + std::ldexp(cells, -14)) / 65536.0) * fixed.dpsPerUnit();
    fixed.temperatureRoundingDps = difference * fixed.dpsPerUnit() / table.stepC() * 0.0005;
    return fixed;
}

std::array<std::int32_t, 3> tdeUnits(const FixedPointTable &table, std::int32_t temperatureMilliC)
{
    const std::int32_t held = std::clamp(temperatureMilliC, table.firstMilliC, table.lastMilliC);
    const auto offset = static_cast<std::uint64_t>(held - table.firstMilliC);
    const std::uint64_t position = (offset * table.reciprocal) >> table.shift;
    const std::uint64_t cell = std::min<std::uint64_t>(position >> 16, table.values.size() - 2);
    const auto fraction = static_cast<std::int64_t>(position - (cell << 16));
    std::array<std::int32_t, 3> units{};
    for (std::size_t axis = 0; axis < units.size(); ++axis) {
        const std::int32_t value = table.values[cell][axis];
        const std::int64_t difference = std::int64_t{table.values[cell + 1][axis]} - value;
        // C++20 defines the shift of a negative number as rounding down.
        units[axis] = static_cast<std::int32_t>(value + ((difference * fraction + 32768) >> 16));
    }
    return units;
}

} // namespace driftbench
