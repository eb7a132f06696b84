#include "engine/base/text.h"
#include "engine/recording/quality_checks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace driftbench::quality {

namespace {

// Width of the blocks and distance in robust sigmas: docs/method.md, section 4.
constexpr std::size_t kBlockSamples = 51;
constexpr double kSigmas = 5.0;

// Medians of blocks of samples, each standing for the middle of its block.
struct BlockMedians
{
    std::vector<double> middles; // as sample numbers
    std::vector<double> medians;
};

BlockMedians blockMedians(const std::vector<double> &values)
{
    BlockMedians blocks;
    std::array<double, 2 * kBlockSamples> block{};
    for (std::size_t first = 0; first < values.size();) {
        std::size_t end = std::min(first + kBlockSamples, values.size());
        // A short rest at the end belongs to the last block.
        if (values.size() - end < kBlockSamples / 2)
            end = values.size();
        const auto last = std::copy(values.begin() + static_cast<std::ptrdiff_t>(first),
                                    values.begin() + static_cast<std::ptrdiff_t>(end), block.begin());
        const auto middle = block.begin() + static_cast<std::ptrdiff_t>((end - first) / 2);
        std::nth_element(block.begin(), middle, last);
        blocks.middles.push_back(0.5 * static_cast<double>(first + end - 1));
        blocks.medians.push_back(*middle);
        first = end;
    }
    return blocks;
}

// Distances from straight lines between the medians, held before the first and after the last.
void residualSizes(const std::vector<double> &values, const BlockMedians &blocks, std::vector<double> &sizes)
{
    const auto &[middles, medians] = blocks;
    sizes.resize(values.size());
    std::size_t i = 0;
    for (; i < values.size() && static_cast<double>(i) <= middles.front(); ++i)
        sizes[i] = std::abs(values[i] - medians.front());
    for (std::size_t k = 0; k + 1 < middles.size(); ++k) {
        const double slope = (medians[k + 1] - medians[k]) / (middles[k + 1] - middles[k]);
        for (; static_cast<double>(i) <= middles[k + 1]; ++i)
            sizes[i] = std::abs(values[i] - medians[k] - slope * (static_cast<double>(i) - middles[k]));
    }
    for (; i < values.size(); ++i)
        sizes[i] = std::abs(values[i] - medians.back());
}

double medianOfCopy(const std::vector<double> &values, std::vector<double> &buffer)
{
    buffer = values;
    const auto middle = buffer.begin() + static_cast<std::ptrdiff_t>(buffer.size() / 2);
    std::nth_element(buffer.begin(), middle, buffer.end());
    return *middle;
}

} // namespace

void checkOutliers(Draft &draft)
{
    const UsableColumns &columns = draft.usable();
    if (columns.size() < kBlockSamples)
        return;
    std::vector<double> sizes;
    std::vector<double> buffer;
    for (const std::vector<double> &rate : columns.rateDps) {
        residualSizes(rate, blockMedians(rate), sizes);
        const double limit = kSigmas * 1.4826 * medianOfCopy(sizes, buffer);
        if (limit == 0.0)
            continue;
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            if (sizes[i] > limit)
                draft.exclude(columns.rows[i], MaskReason::Outlier);
        }
    }
    const Eigen::Index masked = draft.mask().count(MaskReason::Outlier);
    if (masked == 0)
        return;
    const double percent = 100.0 * static_cast<double>(masked) / static_cast<double>(columns.size());
    draft.note(FindingSeverity::Note, "outlier",
               countOf(masked, "sample") + " (" + fixed(percent, 2) + " %) more than " + fixed(kSigmas, 0) +
                   " times the noise off the samples around: left out of training, kept for judging.");
}

} // namespace driftbench::quality
