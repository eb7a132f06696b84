#include "engine/base/statistics.h"
#include "engine/recording/rate_blocks.h"

#include <algorithm>
#include <cmath>

namespace driftbench::quality {

namespace {

constexpr std::array<std::size_t, 4> kWidths{1, 2, 4, 8};
// Blocks further apart than this are not compared with each other.
constexpr double kLongestBreakS = 60.0;
constexpr double kLongestBreakBlocks = 3.0;
// The running median that stands for slow drift, in blocks: half its length, which of the values it looks at,
// and how often it is worked out.
constexpr std::size_t kDriftReach = 60;
constexpr std::size_t kDriftStride = 3;
constexpr std::size_t kDriftEvery = 20;
// Smaller steps are not worth a word.
constexpr double kSmallestStepDps = 0.02;

using Series = std::vector<double>;

Series prefixSums(const Series &values)
{
    Series sums(values.size() + 1, 0.0);
    for (std::size_t i = 0; i < values.size(); ++i)
        sums[i + 1] = sums[i] + values[i];
    return sums;
}

// Mean of w values after k less that of w values before k.
Series differencesAcross(const Series &values, std::size_t width)
{
    const Series sums = prefixSums(values);
    Series differences(values.size(), 0.0);
    for (std::size_t k = width; k + width < values.size(); ++k) {
        const double after = sums[k + width + 1] - sums[k + 1];
        const double before = sums[k] - sums[k - width];
        differences[k] = (after - before) / static_cast<double>(width);
    }
    return differences;
}

void subtractRunningMedian(Series &values, std::size_t margin)
{
    if (values.size() <= 2 * margin)
        return;
    const Series original = values;
    const std::size_t last = original.size() - margin;
    Series nearby;
    for (std::size_t start = margin; start < last; start += kDriftEvery) {
        const std::size_t centre = std::min(start + kDriftEvery / 2, last - 1);
        const std::size_t low = centre > margin + kDriftReach ? centre - kDriftReach : margin;
        nearby.clear();
        for (std::size_t i = low; i < std::min(centre + kDriftReach + 1, last); i += kDriftStride)
            nearby.push_back(original[i]);
        const auto middle = nearby.begin() + static_cast<std::ptrdiff_t>(nearby.size() / 2);
        std::nth_element(nearby.begin(), middle, nearby.end());
        for (std::size_t i = start; i < std::min(start + kDriftEvery, last); ++i)
            values[i] -= *middle;
    }
}

Series sharpDifferences(const Series &values, std::size_t width)
{
    Series differences = differencesAcross(values, width);
    subtractRunningMedian(differences, width);
    return differences;
}

// Standard deviation from the lower quartile of the sizes, which motion in half of the log does not reach.
double quietSigma(Series sizes)
{
    constexpr double kQuartileOfHalfNormal = 0.31863936396437514;
    for (double &size : sizes)
        size = std::abs(size);
    const auto quartile = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 4);
    std::nth_element(sizes.begin(), quartile, sizes.end());
    return *quartile / kQuartileOfHalfNormal;
}

// Where the stretches without a long break begin; ends with the number of blocks.
std::vector<std::size_t> stretchStarts(const std::vector<RateBlock> &blocks)
{
    Series spacings;
    for (std::size_t i = 1; i < blocks.size(); ++i)
        spacings.push_back(blocks[i].timeS - blocks[i - 1].timeS);
    const double longestS = std::max(kLongestBreakS, kLongestBreakBlocks * median(std::move(spacings)));
    std::vector<std::size_t> starts{0};
    for (std::size_t i = 1; i < blocks.size(); ++i) {
        if (blocks[i].timeS - blocks[i - 1].timeS > longestS)
            starts.push_back(i);
    }
    starts.push_back(blocks.size());
    return starts;
}

// One width over one stretch of blocks: which blocks have enough neighbours, and the temperature there.
struct Scan
{
    std::size_t width = 0;
    std::size_t first = 0; // of the stretch
    std::size_t size = 0;
    Series temperature; // sharp differences

    bool reaches() const { return size > 2 * width; }
};

Series part(const Series &values, const Scan &scan)
{
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(scan.first);
    return {begin, begin + static_cast<std::ptrdiff_t>(scan.size)};
}

bool overlaps(const std::vector<RateStep> &steps, std::size_t first, std::size_t last)
{
    return std::any_of(steps.begin(), steps.end(), [&](const RateStep &step) {
        return step.firstBlock <= last && first <= step.lastBlock;
    });
}

double meanOf(const Series &values, std::size_t first, std::size_t count)
{
    return mean(std::span(values).subspan(first, count));
}

// Appends what one scan finds, unless a narrower one found a step close by.
void findSteps(const Scan &scan, const Series &rateDps, const Series &differences, double noiseDps,
               double steepestDpsPerC, std::vector<RateStep> &steps)
{
    const std::size_t width = scan.width;
    const auto sign = [&](std::size_t k) {
        const double threshold =
            std::max(kSmallestStepDps, noiseDps) + steepestDpsPerC * std::abs(scan.temperature[k]);
        return std::abs(differences[k]) < threshold ? 0 : (differences[k] > 0.0 ? 1 : -1);
    };
    std::vector<RateStep> found;
    for (std::size_t k = width; k + width < scan.size; ++k) {
        if (sign(k) == 0)
            continue;
        std::size_t last = k;
        while (last + width + 1 < scan.size && sign(last + 1) == sign(k))
            ++last;
        const std::size_t firstBlock = scan.first + k;
        const std::size_t lastBlock = scan.first + last;
        if (!overlaps(steps, firstBlock - width, lastBlock + width)) {
            const double height =
                meanOf(rateDps, lastBlock + 1, width) - meanOf(rateDps, firstBlock - width, width);
            found.push_back({firstBlock, lastBlock, height});
        }
        k = last;
    }
    steps.insert(steps.end(), found.begin(), found.end());
}

// All scans of one width, with the temperature that the three axes share.
std::vector<Scan> scansOf(const std::vector<RateBlock> &blocks, const std::vector<std::size_t> &starts,
                          std::size_t width)
{
    Series temperature(blocks.size());
    std::transform(blocks.begin(), blocks.end(), temperature.begin(),
                   [](const RateBlock &block) { return block.temperatureC; });
    std::vector<Scan> scans;
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
        Scan scan{width, starts[i], starts[i + 1] - starts[i], {}};
        if (!scan.reaches())
            continue;
        scan.temperature = sharpDifferences(part(temperature, scan), width);
        scans.push_back(std::move(scan));
    }
    return scans;
}

void findStepsOfWidth(const std::vector<Scan> &scans, const Series &rateDps, const MotionOptions &options,
                      std::vector<RateStep> &steps)
{
    std::vector<Series> differences;
    Series all;
    for (const Scan &scan : scans) {
        differences.push_back(sharpDifferences(part(rateDps, scan), scan.width));
        all.insert(all.end(), differences.back().begin() + static_cast<std::ptrdiff_t>(scan.width),
                   differences.back().end() - static_cast<std::ptrdiff_t>(scan.width));
    }
    if (all.empty())
        return;
    const double noiseDps = options.noiseFactor * quietSigma(std::move(all));
    for (std::size_t i = 0; i < scans.size(); ++i)
        findSteps(scans[i], rateDps, differences[i], noiseDps, options.steepestDriftDpsPerC, steps);
}

} // namespace

std::array<std::vector<RateStep>, kAxisCount> rateSteps(const std::vector<RateBlock> &blocks,
                                                        const MotionOptions &options)
{
    std::array<std::vector<RateStep>, kAxisCount> steps;
    if (blocks.empty())
        return steps;
    const std::vector<std::size_t> starts = stretchStarts(blocks);
    std::array<Series, kAxisCount> rateDps;
    for (std::size_t axis = 0; axis < rateDps.size(); ++axis) {
        for (const RateBlock &block : blocks)
            rateDps[axis].push_back(block.medianDps[axis]);
    }
    for (const std::size_t width : kWidths) {
        const std::vector<Scan> scans = scansOf(blocks, starts, width);
        for (std::size_t axis = 0; axis < rateDps.size(); ++axis)
            findStepsOfWidth(scans, rateDps[axis], options, steps[axis]);
    }
    for (std::vector<RateStep> &found : steps) {
        std::sort(found.begin(), found.end(),
                  [](const RateStep &a, const RateStep &b) { return a.firstBlock < b.firstBlock; });
    }
    return steps;
}

} // namespace driftbench::quality
