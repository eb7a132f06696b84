#include "engine/base/statistics.h"
#include "engine/base/text.h"
#include "engine/recording/quality_checks.h"

#include <algorithm>
#include <cmath>

namespace driftbench::quality {

namespace {

// A stretch of equal readings.
struct Dwell
{
    double startS = 0.0;
    double endS = 0.0;
    double temperatureC = 0.0;

    double durationS() const { return endS - startS; }
};

struct Knot
{
    double timeS;
    double temperatureC;
};

// A dwell this many times longer than usual is a plateau.
constexpr double kLongDwell = 3.0;
// Steps from here on are worth a note although they are left as they are.
constexpr double kVisibleStepC = 0.1;

// The smallest change of the reading; 0 where it never changes.
double smallestStepC(const std::vector<double> &values)
{
    double smallest = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double step = std::abs(values[i] - values[i - 1]);
        if (step > 0.0 && (smallest == 0.0 || step < smallest))
            smallest = step;
    }
    return smallest;
}

// Each dwell ends half way to the first sample of the next.
std::vector<Dwell> dwellsOf(const UsableColumns &columns)
{
    const double startS = columns.timeS.front();
    std::vector<Dwell> dwells{{startS, startS, columns.temperatureC.front()}};
    for (std::size_t i = 1; i < columns.size(); ++i) {
        if (columns.temperatureC[i] != dwells.back().temperatureC) {
            const double changeS = 0.5 * (columns.timeS[i - 1] + columns.timeS[i]);
            dwells.back().endS = changeS;
            dwells.push_back({changeS, changeS, columns.temperatureC[i]});
        }
        dwells.back().endS = columns.timeS[i];
    }
    return dwells;
}

// One pass that takes out dwells which are shorter than both their neighbours and return to the same reading:
// flicker where the temperature passes from one reading to the next.
std::vector<Dwell> withoutShortestFlicker(const std::vector<Dwell> &dwells)
{
    std::vector<Dwell> kept;
    for (std::size_t i = 0; i < dwells.size(); ++i) {
        const bool returns =
            !kept.empty() && i + 1 < dwells.size() && kept.back().temperatureC == dwells[i + 1].temperatureC;
        if (returns &&
            dwells[i].durationS() <= std::min(kept.back().durationS(), dwells[i + 1].durationS())) {
            kept.back().endS = dwells[i + 1].endS;
            ++i;
        } else {
            kept.push_back(dwells[i]);
        }
    }
    return kept;
}

std::vector<Dwell> withoutFlicker(std::vector<Dwell> dwells)
{
    for (std::size_t before = dwells.size() + 1; dwells.size() < before;) {
        before = dwells.size();
        dwells = withoutShortestFlicker(dwells);
    }
    return dwells;
}

// A knot at the middle of each dwell; a long one keeps two, half a usual dwell from its ends. The first and
// the last dwell are cut off by the recording: they count from the end that was seen.
std::vector<Knot> knotsOf(const std::vector<Dwell> &dwells)
{
    std::vector<double> durations;
    for (const Dwell &dwell : dwells)
        durations.push_back(dwell.durationS());
    const double usualS = median(std::move(durations));
    std::vector<Knot> knots;
    for (std::size_t i = 0; i < dwells.size(); ++i) {
        const Dwell &dwell = dwells[i];
        const bool first = i == 0;
        const bool last = i + 1 == dwells.size();
        const double earlyS = first ? dwell.startS : dwell.startS + 0.5 * usualS;
        const double lateS = last ? dwell.endS : dwell.endS - 0.5 * usualS;
        if (dwell.durationS() > kLongDwell * usualS) {
            knots.push_back({earlyS, dwell.temperatureC});
            knots.push_back({lateS, dwell.temperatureC});
        } else if (first || last) {
            knots.push_back({first ? lateS : earlyS, dwell.temperatureC});
        } else {
            knots.push_back({0.5 * (dwell.startS + dwell.endS), dwell.temperatureC});
        }
    }
    return knots;
}

// Before the first knot and after the last the lines go on for half a step: a reading says no more.
std::vector<double> interpolated(const UsableColumns &columns, const std::vector<Knot> &knots)
{
    std::vector<double> values(columns.size());
    std::size_t k = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const double timeS = columns.timeS[i];
        while (k + 2 < knots.size() && knots[k + 1].timeS < timeS)
            ++k;
        const Knot &a = knots[k];
        const Knot &b = knots[k + 1];
        const double part = std::clamp((timeS - a.timeS) / (b.timeS - a.timeS), -0.5, 1.5);
        values[i] = a.temperatureC + part * (b.temperatureC - a.temperatureC);
    }
    return values;
}

} // namespace

void interpolateStairs(Draft &draft, const QualityOptions &options)
{
    const UsableColumns &columns = draft.usable();
    const double stepC = smallestStepC(columns.temperatureC);
    if (stepC < kVisibleStepC)
        return;
    if (stepC < options.coarseTemperatureC) {
        draft.note(FindingSeverity::Note, "temperature steps",
                   "The temperature is recorded in steps of " + fixed(stepC, 2) + " °C.");
        return;
    }
    const std::vector<Dwell> dwells = withoutFlicker(dwellsOf(columns));
    if (dwells.size() < 3) {
        draft.note(FindingSeverity::Warning, "temperature stairs",
                   "The temperature is recorded in steps of " + fixed(stepC, 1) +
                       " °C and takes too few of them to be interpolated.");
        return;
    }
    draft.replaceTemperature(columns.rows, interpolated(columns, knotsOf(dwells)));
    draft.note(FindingSeverity::Warning, "temperature stairs",
               "The temperature is recorded in steps of " + fixed(stepC, 1) +
                   " °C: it is interpolated between the middles of its " +
                   countOf(static_cast<Eigen::Index>(dwells.size()), "dwell") + ".");
}

} // namespace driftbench::quality
