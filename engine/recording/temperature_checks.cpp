#include "engine/base/statistics.h"
#include "engine/base/text.h"
#include "engine/recording/quality_checks.h"

#include <algorithm>
#include <cmath>

namespace driftbench::quality {

namespace {

// Readings outside are no temperatures of a sensor.
constexpr double kColdestC = -273.15;
constexpr double kHottestC = 500.0;
// One sample this far from both neighbours, on the same side, is a faulty reading.
constexpr double kSpikeC = 5.0;
// A reading that repeats this long, and then jumps, was stuck.
constexpr double kShortestStuckS = 60.0;
constexpr std::size_t kFewestStuck = 30;
constexpr double kStuckJumpC = 2.0;
constexpr double kStuckJumpSteps = 3.0; // in usual steps of the reading

bool isSpike(double before, double here, double after)
{
    return std::min(here - before, here - after) > kSpikeC || std::min(before - here, after - here) > kSpikeC;
}

void maskFaults(Draft &draft, const UsableColumns &columns)
{
    const std::vector<double> &values = columns.temperatureC;
    Eigen::Index faults = 0;
    double firstS = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool outside = values[i] < kColdestC || values[i] > kHottestC;
        const bool inside = i > 0 && i + 1 < values.size();
        if (!outside && !(inside && isSpike(values[i - 1], values[i], values[i + 1])))
            continue;
        draft.exclude(columns.rows[i], MaskReason::TemperatureFault);
        firstS = faults++ == 0 ? columns.timeS[i] : firstS;
    }
    if (faults > 0) {
        draft.note(FindingSeverity::Warning, "temperature fault",
                   countOf(faults, "sample") + (faults == 1 ? " has a temperature" : " have a temperature") +
                       " far off the samples around, the first at " + fixed(firstS, 1) + " s: masked.",
                   firstS, firstS);
    }
}

// The usual step of the reading: median size of its changes; 0 without any.
double usualStepC(const std::vector<double> &values)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (values[i] != values[i - 1])
            steps.push_back(std::abs(values[i] - values[i - 1]));
    }
    return steps.empty() ? 0.0 : median(std::move(steps));
}

bool jumps(const std::vector<double> &values, std::size_t at)
{
    return std::abs(values[at] - values[at - 1]) >=
           std::max(kStuckJumpC, kStuckJumpSteps * usualStepC(values));
}

void maskStuck(Draft &draft, const UsableColumns &columns)
{
    const std::vector<double> &values = columns.temperatureC;
    for (std::size_t first = 0; first < values.size();) {
        std::size_t end = first + 1;
        while (end < values.size() && values[end] == values[first])
            ++end;
        const double durationS = columns.timeS[end - 1] - columns.timeS[first];
        const bool isLong = durationS >= kShortestStuckS && end - first >= kFewestStuck;
        if (isLong && end < values.size() && jumps(values, end)) {
            for (std::size_t i = first + 1; i < end; ++i)
                draft.exclude(columns.rows[i], MaskReason::TemperatureFault);
            draft.note(FindingSeverity::Warning, "temperature stuck",
                       "The temperature stands at " + forReading(values[first], 2) + " °C from " +
                           rangeText(columns.timeS[first], columns.timeS[end - 1]) + " and then jumps by " +
                           forReading(values[end] - values[end - 1], 1) + " °C: " +
                           countOf(static_cast<Eigen::Index>(end - first - 1), "sample") + " masked.",
                       columns.timeS[first], columns.timeS[end - 1]);
        }
        first = end;
    }
}

// A thermometer whose reading changes from sample to sample and then never again has stopped.
void reportStoppedAtEnd(Draft &draft, const UsableColumns &columns)
{
    const std::vector<double> &values = columns.temperatureC;
    if (values.size() < 2 * kFewestStuck)
        return;
    std::size_t first = values.size() - 1;
    while (first > 0 && values[first - 1] == values.back())
        --first;
    std::size_t changes = 0;
    for (std::size_t i = 1; i < first; ++i)
        changes += values[i] != values[i - 1] ? 1 : 0;
    const double durationS = columns.timeS.back() - columns.timeS[first];
    const bool usuallyRestless = first > kFewestStuck && 2 * changes > first;
    if (usuallyRestless && durationS >= kShortestStuckS && values.size() - first >= kFewestStuck) {
        draft.note(FindingSeverity::Warning, "temperature stuck",
                   "The temperature, restless before, stands at " + forReading(values.back(), 2) +
                       " °C from " + rangeText(columns.timeS[first], columns.timeS.back()) +
                       ", to the end: check the thermometer.",
                   columns.timeS[first], columns.timeS.back());
    }
}

} // namespace

void checkTemperature(Draft &draft)
{
    maskFaults(draft, draft.usable());
    const UsableColumns &columns = draft.usable();
    maskStuck(draft, columns);
    reportStoppedAtEnd(draft, columns);
}

} // namespace driftbench::quality
