#include "engine/recording/rate_blocks.h"

#include "engine/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace driftbench::quality {

namespace {

constexpr double kBlockS = 2.0;
constexpr std::size_t kFewestInBlock = 8;

double medianInPlace(std::vector<double> &values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1)
        return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

RateBlock summarised(const UsableColumns &columns, std::size_t first, std::size_t end,
                     std::vector<double> &buffer)
{
    RateBlock block;
    block.first = first;
    block.end = end;
    block.timeS = columns.timeS[first + (end - first) / 2];
    const auto count = static_cast<double>(end - first);
    for (std::size_t i = first; i < end; ++i)
        block.temperatureC += columns.temperatureC[i] / count;
    for (std::size_t axis = 0; axis < columns.rateDps.size(); ++axis) {
        const auto begin = columns.rateDps[axis].begin();
        buffer.assign(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end));
        const double level = medianInPlace(buffer);
        double deviations = 0.0;
        for (const double value : buffer)
            deviations += std::abs(value - level);
        block.medianDps[axis] = level;
        block.scatterDps[axis] = deviations / count * std::sqrt(0.5 * std::numbers::pi);
    }
    return block;
}

} // namespace

std::vector<RateBlock> rateBlocks(const UsableColumns &columns, double intervalS, double gapFactor)
{
    std::vector<RateBlock> blocks;
    if (columns.size() < 2)
        return blocks;
    const double perBlock = std::min(kBlockS / intervalS, static_cast<double>(columns.size()));
    const std::size_t wanted = std::max(kFewestInBlock, static_cast<std::size_t>(std::llround(perBlock)));
    std::vector<double> buffer;
    for (std::size_t first = 0; first < columns.size();) {
        std::size_t end = first + 1;
        while (end < columns.size() && end - first < wanted &&
               columns.timeS[end] - columns.timeS[end - 1] <= gapFactor * intervalS)
            ++end;
        blocks.push_back(summarised(columns, first, end, buffer));
        first = end;
    }
    return blocks;
}

std::array<double, kAxisCount> quietNoiseDps(const std::vector<RateBlock> &blocks)
{
    std::array<double, kAxisCount> noise{};
    for (std::size_t axis = 0; axis < noise.size(); ++axis) {
        std::vector<double> scatters;
        scatters.reserve(blocks.size());
        for (const RateBlock &block : blocks) {
            if (block.end - block.first >= kFewestInBlock)
                scatters.push_back(block.scatterDps[axis]);
        }
        if (scatters.empty())
            continue;
        const auto quantile = scatters.begin() + static_cast<std::ptrdiff_t>(scatters.size() / 5);
        std::nth_element(scatters.begin(), quantile, scatters.end());
        noise[axis] = *quantile;
    }
    return noise;
}

} // namespace driftbench::quality
