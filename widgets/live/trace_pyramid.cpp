#include "widgets/live/trace_pyramid.h"

#include "engine/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

static constexpr double kGapColumns = 3.0;       // narrower ones are not seen
static constexpr std::int64_t kFewIntervals = 8; // below, nothing is said about gaps
static constexpr int kLevels = 12;               // the last has stretches of 67 million samples

TracePyramid::TracePyramid()
{
    std::int64_t samples = kFirstStretch;
    for (int level = 0; level < kLevels; ++level, samples *= kGrowth)
        m_levels.push_back({samples, ChunkRing<Stretch>{kStretches}, {}});
}

double TracePyramid::intervalS() const
{
    return m_intervals > 0 ? m_coveredS / static_cast<double>(m_intervals) : 0.0;
}

TracePyramid::Stretch TracePyramid::stretchOf(const Sample &sample)
{
    return {sample.timeS, sample.timeS, 1, sample.values, sample.values, sample.values};
}

// Where one of the two has no value the other's counts; beside a change of model the mean of one stretch is
// therefore that of its compensated part.
void TracePyramid::merge(Stretch &into, const Stretch &part)
{
    if (into.count == 0) {
        into = part;
        return;
    }
    const auto before = static_cast<float>(into.count);
    const auto after = static_cast<float>(part.count);
    for (std::size_t trace = 0; trace < kTraces; ++trace) {
        if (std::isnan(part.mean[trace]))
            continue;
        if (std::isnan(into.mean[trace])) {
            into.low[trace] = part.low[trace];
            into.high[trace] = part.high[trace];
            into.mean[trace] = part.mean[trace];
            continue;
        }
        into.low[trace] = std::min(into.low[trace], part.low[trace]);
        into.high[trace] = std::max(into.high[trace], part.high[trace]);
        into.mean[trace] += (part.mean[trace] - into.mean[trace]) * (after / (before + after));
    }
    into.lastS = part.lastS;
    into.count += part.count;
}

void TracePyramid::close(std::size_t level)
{
    Stretch &open = m_levels[level].open;
    m_levels[level].closed.push(open);
    if (level + 1 < m_levels.size()) {
        Level &next = m_levels[level + 1];
        merge(next.open, open);
        if (next.open.count >= next.samples)
            close(level + 1);
    }
    open = {};
}

// From the finest level up: what is closed below goes into what is open above.
void TracePyramid::closeForGap(double gapS)
{
    for (std::size_t level = 0; level < m_levels.size(); ++level) {
        const double lengthS = static_cast<double>(m_levels[level].samples) * intervalS();
        if (level > 0 && lengthS >= gapS)
            return;
        if (m_levels[level].open.count > 0)
            close(level);
    }
}

void TracePyramid::add(double timeS, const Values &values)
{
    if (!std::isfinite(timeS) || (m_count > 0 && timeS <= m_lastS)) {
        ++m_leftOut;
        return;
    }
    Sample sample{timeS, values};
    for (float &value : sample.values)
        value = std::isfinite(value) ? value : std::numeric_limits<float>::quiet_NaN();
    if (m_count == 0) {
        m_firstS = timeS;
    } else {
        const double stepS = timeS - m_lastS;
        if (m_intervals >= kFewIntervals && stepS > kGapIntervals * intervalS()) {
            closeForGap(stepS);
        } else {
            m_coveredS += stepS;
            ++m_intervals;
        }
    }
    m_samples.push(sample);
    merge(m_levels.front().open, stretchOf(sample));
    if (m_levels.front().open.count >= kFirstStretch)
        close(0);
    ++m_count;
    m_lastS = timeS;
}

int TracePyramid::levelFor(double columnS) const
{
    int level = -1;
    for (const Level &candidate : m_levels) {
        if (static_cast<double>(candidate.samples) * intervalS() > columnS)
            break;
        ++level;
    }
    return level;
}

std::optional<double> TracePyramid::oldestOf(int level) const
{
    if (level < 0)
        return m_samples.hasDropped() ? std::optional(m_samples.front().timeS) : std::nullopt;
    const auto &closed = m_levels[static_cast<std::size_t>(level)].closed;
    return closed.hasDropped() ? std::optional(closed.front().firstS) : std::nullopt;
}

template <class Ring, class Time>
static std::size_t firstAtOrAfter(const Ring &ring, double timeS, Time timeOf)
{
    std::size_t low = 0;
    std::size_t high = ring.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (timeOf(ring[middle]) < timeS)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

template <class F>
void TracePyramid::visitLevel(int level, double fromS, double toS, F &&each) const
{
    if (level < 0) {
        const auto first = firstAtOrAfter(m_samples, fromS, [](const Sample &s) { return s.timeS; });
        for (std::size_t i = first; i < m_samples.size() && m_samples[i].timeS <= toS; ++i)
            each(stretchOf(m_samples[i]));
        return;
    }
    const auto &closed = m_levels[static_cast<std::size_t>(level)].closed;
    const auto first = firstAtOrAfter(closed, fromS, [](const Stretch &s) { return s.lastS; });
    for (std::size_t i = first; i < closed.size() && closed[i].firstS <= toS; ++i)
        each(closed[i]);
}

template <class F>
void TracePyramid::visit(int level, double fromS, double toS, F &&each) const
{
    // Where the wanted level begins only after fromS, a coarser one has the part before it; a stretch of that
    // may reach over the border, so what follows starts behind it.
    int coarsest = level;
    while (coarsest + 1 < static_cast<int>(m_levels.size()) && oldestOf(coarsest).value_or(fromS) > fromS)
        ++coarsest;
    double reachedS = -kInfinity;
    for (int at = coarsest; at >= level; --at) {
        const double endS = at > level ? oldestOf(at - 1).value_or(toS) : toS;
        visitLevel(at, fromS, std::min(endS, toS), [&](const Stretch &stretch) {
            if (stretch.firstS > reachedS) {
                each(stretch);
                reachedS = stretch.lastS;
            }
        });
    }
    // The newest samples are in stretches that are still open, the oldest of them on the coarsest level.
    for (int at = level; at >= 0; --at) {
        const Stretch &open = m_levels[static_cast<std::size_t>(at)].open;
        if (open.count > 0 && open.lastS >= fromS && open.firstS <= toS && open.firstS > reachedS)
            each(open);
    }
}

namespace {

struct Column
{
    std::int64_t index = 0;
    double firstS = 0.0, lastS = 0.0;
    double timeSum = 0.0;
    double count = 0.0;
    std::array<double, TracePyramid::kTraces> low, high, sum, values;

    explicit Column(std::int64_t at) : index(at)
    {
        low.fill(kInfinity);
        high.fill(-kInfinity);
        sum.fill(0.0);
        values.fill(0.0);
    }
};

} // namespace

static void append(TracePyramid::Envelopes &result, const Column &column)
{
    result.timeS.append(column.timeSum / column.count);
    for (std::size_t trace = 0; trace < TracePyramid::kTraces; ++trace) {
        const bool any = column.values[trace] > 0.0;
        result.low[trace].append(any ? column.low[trace] : kNaN);
        result.high[trace].append(any ? column.high[trace] : kNaN);
        result.mean[trace].append(any ? column.sum[trace] / column.values[trace] : kNaN);
    }
}

static void appendBreak(TracePyramid::Envelopes &result, double timeS)
{
    result.timeS.append(timeS);
    for (auto *values : {&result.low, &result.high, &result.mean}) {
        for (QVector<double> &trace : *values)
            trace.append(std::numeric_limits<double>::quiet_NaN());
    }
}

TracePyramid::Envelopes TracePyramid::envelopes(double fromS, double toS, double columnS) const
{
    Envelopes result;
    if (empty() || !(toS >= fromS) || !(columnS > 0.0))
        return result;
    const double gapS = std::max(kGapColumns * columnS, kGapIntervals * intervalS());
    std::optional<Column> column;
    const auto finish = [&] {
        if (column)
            append(result, *column);
    };
    visit(levelFor(columnS), fromS, toS, [&](const Stretch &stretch) {
        const double middleS = 0.5 * (stretch.firstS + stretch.lastS);
        const auto index = static_cast<std::int64_t>(std::floor(middleS / columnS));
        const bool afterGap = column && stretch.firstS - column->lastS > gapS;
        if (!column || index != column->index || afterGap) {
            finish();
            if (afterGap)
                appendBreak(result, 0.5 * (column->lastS + stretch.firstS));
            column.emplace(index);
            column->firstS = stretch.firstS;
        }
        const auto count = static_cast<double>(stretch.count);
        column->lastS = stretch.lastS;
        column->timeSum += middleS * count;
        column->count += count;
        for (std::size_t trace = 0; trace < kTraces; ++trace) {
            if (std::isnan(stretch.mean[trace]))
                continue;
            column->low[trace] = std::min(column->low[trace], static_cast<double>(stretch.low[trace]));
            column->high[trace] = std::max(column->high[trace], static_cast<double>(stretch.high[trace]));
            column->sum[trace] += stretch.mean[trace] * count;
            column->values[trace] += count;
        }
    });
    finish();
    return result;
}

std::optional<std::array<double, TracePyramid::kTraces>> TracePyramid::means(double fromS, double toS) const
{
    static constexpr double kParts = 64.0; // edges count to this part of the whole
    std::array<double, kTraces> sums{}, counts{};
    bool any = false;
    if (empty() || !(toS >= fromS))
        return std::nullopt;
    visit(levelFor((toS - fromS) / kParts), fromS, toS, [&](const Stretch &stretch) {
        any = true;
        for (std::size_t trace = 0; trace < kTraces; ++trace) {
            if (std::isnan(stretch.mean[trace]))
                continue;
            sums[trace] += stretch.mean[trace] * static_cast<double>(stretch.count);
            counts[trace] += static_cast<double>(stretch.count);
        }
    });
    if (!any)
        return std::nullopt;
    for (std::size_t trace = 0; trace < kTraces; ++trace)
        sums[trace] /= counts[trace]; // 0 / 0: NaN
    return sums;
}

std::size_t TracePyramid::bytes() const
{
    std::size_t bytes = m_samples.size() * sizeof(Sample);
    for (const Level &level : m_levels)
        bytes += level.closed.size() * sizeof(Stretch);
    return bytes;
}

} // namespace driftbench
