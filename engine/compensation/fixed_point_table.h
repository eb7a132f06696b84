// A compensation table in integers, for devices without a floating-point unit.
//
// This arithmetic is a contract: the exported C header and the firmware must give the same bits.
// In: temperature in whole millidegrees Celsius (int32). Out: tde as int32 in units of 2^-F dps, three axes.
//   t  = clamp(temperature, firstMilliC, lastMilliC)            outside, the end value is held
//   p  = ((uint64)(t - firstMilliC) * reciprocal) >> shift      position in 2^-16 cells, rounded down
//   i  = min(p >> 16, n - 2),  f = p - (i << 16)                0 <= f <= 65536
//   tde = v_i + floor(((int64)(v_{i+1} - v_i) * f + 32768) / 65536)
// with n knots v (n x 3, int32) and
//   reciprocal = floor((n - 1) 2^(16 + shift) / (lastMilliC - firstMilliC))   in [2^30, 2^31)
//   F (fractionBits): the largest up to 30 with |v| < 2^30, so that a difference of two knots fits int32.
// No division is needed: the slope per cell is the difference of two knots. floor() of a negative number by a
// right shift is not portable in C99; add 2^49 before the shift (unsigned) and take 2^33 away after it.
//
// Error against the same table in real numbers, at a whole millidegree, per axis:
//   2^-(F+1) for the knots + 2^-(F+1) for the last rounding + D (1 + (n - 1) 2^-14) 2^-16
// where D is the largest difference of two neighbouring knots: p is rounded down by less than 1, and the
// reciprocal, short of the true one by less than 2^-30 of itself, takes off at most 2^-30 of p <= (n - 1)
// 2^16.
#pragma once

#include "engine/compensation/compensation_table.h"

#include <array>
#include <cstdint>
#include <vector>

namespace driftbench {

struct FixedPointTable
{
    std::int32_t firstMilliC = 0;
    std::int32_t lastMilliC = 0;
    std::uint32_t reciprocal = 0;
    int shift = 0;
    int fractionBits = 0; // F
    std::vector<std::array<std::int32_t, 3>> values;
    double errorBoundDps = 0.0; // of the formula above, the largest over the axes
    // What rounding a temperature to the millidegree adds: half a millidegree on the steepest cell.
    double temperatureRoundingDps = 0.0;

    double dpsPerUnit() const;
    bool operator==(const FixedPointTable &) const = default;
};

FixedPointTable makeFixedPointTable(const CompensationTable &table);

std::array<std::int32_t, 3> tdeUnits(const FixedPointTable &table, std::int32_t temperatureMilliC);

} // namespace driftbench
