// The value ranges of strips that stand below each other: the same span for all, so that they compare, unless
// that would hide what one of them shows; and steady while their data move.
#pragma once

#include "widgets/plot/plot_style.h"

#include <array>
#include <optional>

namespace driftbench {

struct ValueRange
{
    double low = 0.0;
    double high = 1.0;

    double span() const { return high - low; }
    friend bool operator==(const ValueRange &, const ValueRange &) = default;
};

// The lower ends are round numbers. Strips without data get the common span around zero. `before` is kept as
// long as all data are within it and fill half of what they would fill.
std::array<ValueRange, 3> commonRanges(const std::array<Extent, 3> &data,
                                       const std::optional<std::array<ValueRange, 3>> &before);

} // namespace driftbench
