#include "widgets/live/value_ranges.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr double kHides =
    8.0; // a strip whose data fill less than this part of the widest gets its own
static constexpr double kBelow = 0.03;
static constexpr double kAbove = 0.06;
static constexpr double kParts = 5.0;         // the span has about so many round steps
static constexpr double kSmallestSpan = 1e-3; // dps; nothing measured is smaller
static constexpr double kFilled = 0.5;

static double spanOf(const Extent &extent)
{
    return extent.empty() ? 0.0 : std::max(extent.high() - extent.low(), kSmallestSpan);
}

static double roundStep(double wanted)
{
    const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double mantissa : {1.0, 2.0, 5.0}) {
        if (mantissa * decade >= wanted)
            return mantissa * decade;
    }
    return 10.0 * decade;
}

static double roundLow(const Extent &extent, double span)
{
    const double step = roundStep(span / kParts);
    return std::floor((extent.low() - kBelow * span) / step) * step;
}

static ValueRange ownRange(const Extent &extent)
{
    const double span = spanOf(extent);
    return {roundLow(extent, span), extent.high() + kAbove * span};
}

static bool stillFits(const std::array<Extent, 3> &data, const std::array<ValueRange, 3> &ranges,
                      const std::array<ValueRange, 3> &before)
{
    for (std::size_t i = 0; i < data.size(); ++i) {
        if (data[i].empty())
            continue;
        if (data[i].low() < before[i].low || data[i].high() > before[i].high)
            return false;
        if (ranges[i].span() < kFilled * before[i].span())
            return false;
    }
    return true;
}

std::array<ValueRange, 3> commonRanges(const std::array<Extent, 3> &data,
                                       const std::optional<std::array<ValueRange, 3>> &before)
{
    double widest = 0.0;
    double narrowest = INFINITY;
    for (const Extent &extent : data) {
        if (extent.empty())
            continue;
        widest = std::max(widest, spanOf(extent));
        narrowest = std::min(narrowest, spanOf(extent));
    }
    std::array<ValueRange, 3> ranges;
    if (widest == 0.0)
        return ranges;
    const bool common = widest <= kHides * narrowest;
    double span = 0.0;
    for (std::size_t i = 0; i < data.size(); ++i) {
        if (data[i].empty())
            continue;
        ranges[i] = ownRange(data[i]);
        if (common)
            ranges[i].low = roundLow(data[i], widest);
        span = std::max(span, data[i].high() + kAbove * widest - ranges[i].low);
    }
    for (std::size_t i = 0; i < data.size(); ++i) {
        if (data[i].empty())
            ranges[i] = {-0.5 * span, 0.5 * span};
        else if (common)
            ranges[i].high = ranges[i].low + span;
    }
    return before && stillFits(data, ranges, *before) ? *before : ranges;
}

} // namespace driftbench
