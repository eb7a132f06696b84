#include "engine/base/text.h"
#include "engine/recording/rate_blocks.h"

#include <algorithm>
#include <cmath>

namespace driftbench::quality {

namespace {

// Shaken: at least kFewestLoud of kLoudWindow samples in a row are far off. Fewer are outliers.
constexpr std::size_t kLoudWindow = 10;
constexpr std::size_t kFewestLoud = 5;
// A turn is over when this part of its height, at most, is left.
constexpr double kComesBack = 0.3;
// A step as high as this, this close to an end of the log, is a turn of which only one edge was recorded.
constexpr double kHalfTurnDps = 1.0;
constexpr double kHalfTurnS = 60.0;

struct Span
{
    double startS;
    double endS;
};

// Far off the levels of its own and both neighbouring blocks, so that the edge of a step is not.
std::vector<bool> loudSamples(const UsableColumns &columns, const std::vector<RateBlock> &blocks,
                              const MotionOptions &options)
{
    const std::array<double, kAxisCount> noise = quietNoiseDps(blocks);
    std::vector<bool> loud(columns.size(), false);
    for (std::size_t axis = 0; axis < noise.size(); ++axis) {
        const double threshold = std::max(options.smallestShakeDps, options.noiseFactor * noise[axis]);
        const std::vector<double> &rate = columns.rateDps[axis];
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            const double own = blocks[b].medianDps[axis];
            const double before = blocks[b == 0 ? b : b - 1].medianDps[axis];
            const double after = blocks[b + 1 == blocks.size() ? b : b + 1].medianDps[axis];
            for (std::size_t i = blocks[b].first; i < blocks[b].end; ++i) {
                if (std::abs(rate[i] - own) > threshold && std::abs(rate[i] - before) > threshold &&
                    std::abs(rate[i] - after) > threshold)
                    loud[i] = true;
            }
        }
    }
    return loud;
}

// Where rows are means, shaking averages out of them but not out of the scatter of their samples.
void addLoudMeans(const PointSamples &points, const std::vector<Eigen::Index> &rows,
                  const MotionOptions &options, std::vector<bool> &loud)
{
    if (points.empty())
        return;
    std::vector<float> sorted(rows.size());
    for (Eigen::Index axis = 0; axis < kAxisCount; ++axis) {
        const auto varianceOf = [&](Eigen::Index row) { return points.varianceDps2(row, axis); };
        std::transform(rows.begin(), rows.end(), sorted.begin(), varianceOf);
        const auto quiet = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 5);
        std::nth_element(sorted.begin(), quiet, sorted.end());
        const double threshold =
            std::max(options.smallestShakeDps, options.noiseFactor * std::sqrt(static_cast<double>(*quiet)));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (static_cast<double>(varianceOf(rows[i])) > threshold * threshold)
                loud[i] = true;
        }
    }
}

std::vector<Span> shakenSpans(const UsableColumns &columns, const std::vector<bool> &loud)
{
    std::vector<Span> spans;
    std::vector<std::size_t> recent; // loud samples
    for (std::size_t i = 0; i < loud.size(); ++i) {
        if (!loud[i])
            continue;
        recent.push_back(i);
        if (recent.size() < kFewestLoud)
            continue;
        const std::size_t first = recent[recent.size() - kFewestLoud];
        if (i - first < kLoudWindow)
            spans.push_back({columns.timeS[first], columns.timeS[i]});
    }
    return spans;
}

// Joined where they overlap or lie closer than joinS; in the order of time.
std::vector<Span> joined(std::vector<Span> spans, double joinS)
{
    std::sort(spans.begin(), spans.end(), [](const Span &a, const Span &b) { return a.startS < b.startS; });
    std::vector<Span> result;
    for (const Span &span : spans) {
        if (!result.empty() && span.startS <= result.back().endS + joinS)
            result.back().endS = std::max(result.back().endS, span.endS);
        else
            result.push_back(span);
    }
    return result;
}

std::vector<RateBlock> quietBlocks(const UsableColumns &columns, const std::vector<RateBlock> &blocks,
                                   const std::vector<Span> &shaken)
{
    std::vector<RateBlock> quiet;
    auto next = shaken.begin();
    for (const RateBlock &block : blocks) {
        while (next != shaken.end() && next->endS < columns.timeS[block.first])
            ++next;
        if (next == shaken.end() || columns.timeS[block.end - 1] < next->startS)
            quiet.push_back(block);
    }
    return quiet;
}

// The steps of one axis, sorted into turns (the rate comes back) and steps of the bias (it stays).
struct SortedSteps
{
    std::vector<Span> turns;
    std::vector<RateStep> bias;
};

// The step at which the rate is back where it was before `first`, or the end of steps.
std::size_t returnOf(const std::vector<RateStep> &steps, std::size_t first,
                     const std::vector<RateBlock> &blocks, const MotionOptions &options)
{
    double height = 0.0;
    double highest = 0.0;
    for (std::size_t i = first; i < steps.size(); ++i) {
        if (blocks[steps[i].firstBlock].timeS - blocks[steps[first].lastBlock].timeS > options.longestS)
            break;
        height += steps[i].heightDps;
        highest = std::max(highest, std::abs(height));
        if (i > first && highest >= options.smallestDps && std::abs(height) <= kComesBack * highest)
            return i;
    }
    return steps.size();
}

Span blockSpan(const UsableColumns &columns, const std::vector<RateBlock> &blocks, std::size_t first,
               std::size_t last)
{
    return {columns.timeS[blocks[first].first], columns.timeS[blocks[last].end - 1]};
}

SortedSteps sortedSteps(const std::vector<RateStep> &steps, const UsableColumns &columns,
                        const std::vector<RateBlock> &blocks, const MotionOptions &options)
{
    SortedSteps sorted;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const RateStep &step = steps[i];
        const std::size_t back = returnOf(steps, i, blocks, options);
        const bool large = std::abs(step.heightDps) >= kHalfTurnDps;
        if (back < steps.size()) {
            sorted.turns.push_back(blockSpan(columns, blocks, step.firstBlock, steps[back].lastBlock));
            i = back;
        } else if (large && blocks[step.lastBlock].timeS - columns.timeS.front() < kHalfTurnS) {
            sorted.turns.push_back(blockSpan(columns, blocks, 0, step.lastBlock));
        } else if (large && columns.timeS.back() - blocks[step.firstBlock].timeS < kHalfTurnS) {
            sorted.turns.push_back(blockSpan(columns, blocks, step.firstBlock, blocks.size() - 1));
        } else {
            sorted.bias.push_back(step);
        }
    }
    return sorted;
}

void reportBiasSteps(Draft &draft, std::size_t axis, const std::vector<RateStep> &steps,
                     const std::vector<RateBlock> &blocks)
{
    if (steps.empty())
        return;
    const auto largest = std::max_element(steps.begin(), steps.end(), [](const auto &a, const auto &b) {
        return std::abs(a.heightDps) < std::abs(b.heightDps);
    });
    const double firstS = blocks[steps.front().firstBlock].timeS;
    const double lastS = blocks[steps.back().lastBlock].timeS;
    const std::string largestText =
        forReading(largest->heightDps, 3) + " dps at " + fixed(blocks[largest->firstBlock].timeS, 1) + " s";
    const std::string axisName(kAxisNames[axis]);
    const std::string what = steps.size() == 1
                                 ? "The bias of " + axisName + " steps by " + largestText
                                 : "The bias of " + axisName + " steps " + std::to_string(steps.size()) +
                                       " times from " + rangeText(firstS, lastS) + ", the largest step is " +
                                       largestText;
    draft.note(FindingSeverity::Warning, "bias step", what + "; nothing is masked.", firstS, lastS);
}

void maskSpan(Draft &draft, const UsableColumns &columns, const Span &span)
{
    const auto first = std::lower_bound(columns.timeS.begin(), columns.timeS.end(), span.startS);
    const auto end = std::upper_bound(first, columns.timeS.end(), span.endS);
    for (auto i = first; i != end; ++i)
        draft.exclude(columns.rows[static_cast<std::size_t>(i - columns.timeS.begin())], MaskReason::Motion);
    const auto masked = static_cast<Eigen::Index>(end - first);
    const double percent = 100.0 * static_cast<double>(masked) / static_cast<double>(draft.recording.size());
    draft.note(FindingSeverity::Warning, "motion",
               "The gyro moved from " + rangeText(span.startS, span.endS) + ": " + countText(masked) +
                   " of " + countText(draft.recording.size()) + " samples (" + fixed(percent, 1) +
                   " %) are masked.",
               span.startS, span.endS);
}

void reportTotal(Draft &draft, const std::vector<Span> &moved)
{
    if (moved.size() < 2)
        return;
    double totalS = 0.0;
    for (const Span &span : moved)
        totalS += span.endS - span.startS;
    const Eigen::Index masked = draft.mask().count(MaskReason::Motion);
    const double percent = 100.0 * static_cast<double>(masked) / static_cast<double>(draft.recording.size());
    draft.note(FindingSeverity::Warning, "motion",
               "The gyro moved " + std::to_string(moved.size()) + " times, for " + fixed(totalS, 1) +
                   " s in all: " + countText(masked) + " samples (" + fixed(percent, 1) + " %) are masked.",
               moved.front().startS, moved.back().endS);
}

} // namespace

void checkMotion(Draft &draft, const QualityOptions &options)
{
    const MotionOptions &motion = options.motion;
    const UsableColumns &columns = draft.usable();
    const std::vector<RateBlock> blocks = rateBlocks(columns, draft.intervalS, options.gapFactor);
    if (blocks.empty())
        return;
    std::vector<bool> loud = loudSamples(columns, blocks, motion);
    addLoudMeans(draft.recording.points, columns.rows, motion, loud);
    std::vector<Span> moved = joined(shakenSpans(columns, loud), motion.settleS);
    const std::vector<RateBlock> quiet = quietBlocks(columns, blocks, moved);
    const auto steps = rateSteps(quiet, motion);
    for (std::size_t axis = 0; axis < steps.size(); ++axis) {
        const SortedSteps sorted = sortedSteps(steps[axis], columns, quiet, motion);
        moved.insert(moved.end(), sorted.turns.begin(), sorted.turns.end());
        reportBiasSteps(draft, axis, sorted.bias, quiet);
    }
    for (Span &span : moved) {
        span = {std::max(span.startS - motion.paddingS, columns.timeS.front()),
                std::min(span.endS + motion.paddingS, columns.timeS.back())};
    }
    moved = joined(std::move(moved), motion.settleS);
    for (const Span &span : moved)
        maskSpan(draft, columns, span);
    reportTotal(draft, moved);
}

} // namespace driftbench::quality
