#include "engine/base/text.h"
#include "engine/recording/quality_checks.h"

#include <algorithm>
#include <cmath>

namespace driftbench::quality {

namespace {

// A temperature that varies less than this is constant: the scatter of a thermometer, not a sweep.
constexpr double kConstantC = 0.5;
// docs/method.md, section 6: no drift if the variance of the 1 degree cell means, noise removed, is at most
// this part of the variance within the cells.
constexpr double kNoDriftPart = 0.02;
constexpr double kFewestInCell = 8.0;

std::string spanText(double lowC, double highC)
{
    return fixed(highC - lowC, 1) + " °C (" + forReading(lowC, 1) + " to " + forReading(highC, 1) + " °C)";
}

void checkSpan(Draft &draft, const std::vector<double> &temperatureC, const QualityOptions &options)
{
    const auto [low, high] = std::minmax_element(temperatureC.begin(), temperatureC.end());
    const double spanC = *high - *low;
    if (spanC < kConstantC) {
        draft.refuse(Errc::ConstantTemperature, "constant temperature",
                     "The temperature stays at " + forReading(0.5 * (*low + *high), 1) + " °C within " +
                         fixed(spanC, 2) + " °C; record a sweep of at least " +
                         fixed(options.smallestSpanC, 0) + " °C.");
    } else if (spanC < options.smallestSpanC && !options.allowSmallSpan) {
        draft.refuse(Errc::SpanTooSmall, "small span",
                     "The usable temperature span is only " + spanText(*low, *high) + "; at least " +
                         fixed(options.smallestSpanC, 0) + " °C are needed, " +
                         fixed(options.advisedSpanC, 0) + " °C are advised.");
    } else if (spanC < options.advisedSpanC) {
        draft.note(FindingSeverity::Warning, "small span",
                   "The usable temperature span is only " + spanText(*low, *high) + "; at least " +
                       fixed(options.advisedSpanC, 0) + " °C are advised.");
    }
}

// What was recorded, moved or not: a log that is long enough but mostly motion fails by its span instead.
double recordedS(const Draft &draft)
{
    Eigen::Index rows = 0;
    for (Eigen::Index i = 0; i < draft.recording.size(); ++i) {
        const bool bad = draft.mask().has(i, MaskReason::NonFinite) ||
                         draft.mask().has(i, MaskReason::BadTime) ||
                         draft.mask().has(i, MaskReason::Excluded);
        rows += bad ? 0 : 1;
    }
    return static_cast<double>(rows) * draft.intervalS;
}

void checkDuration(Draft &draft, const QualityOptions &options)
{
    const double durationS = recordedS(draft);
    if (durationS >= options.shortestS)
        return;
    const std::string what = "The recording has only " + fixed(durationS, 1) + " s of data";
    if (options.allowShort)
        draft.note(FindingSeverity::Warning, "short", what + ".");
    else
        draft.refuse(Errc::TooShort, "short",
                     what + "; at least " + fixed(options.shortestS, 0) + " s are needed.");
}

struct Cell
{
    double count = 0.0;
    double sum = 0.0;
    double squares = 0.0;
};

struct CellVariances
{
    double ofMeans = 0.0; // with the noise removed
    double within = 0.0;
    double swingDps = 0.0;
    int cells = 0;
};

// Cells of 1 degree; rates count from the first one, so that a reference rate costs no digits.
std::vector<Cell> cellsOf(const std::vector<double> &temperatureC, const std::vector<double> &rateDps)
{
    const auto [low, high] = std::minmax_element(temperatureC.begin(), temperatureC.end());
    const double firstC = std::floor(*low);
    std::vector<Cell> cells(static_cast<std::size_t>(std::floor(*high) - firstC) + 1);
    const double offset = rateDps.front();
    for (std::size_t i = 0; i < rateDps.size(); ++i) {
        Cell &cell = cells[static_cast<std::size_t>(temperatureC[i] - firstC)];
        const double rate = rateDps[i] - offset;
        cell.count += 1.0;
        cell.sum += rate;
        cell.squares += rate * rate;
    }
    return cells;
}

CellVariances cellVariances(const std::vector<Cell> &cells)
{
    CellVariances result;
    double freedom = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    double noiseParts = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
    for (const Cell &cell : cells) {
        if (cell.count < kFewestInCell)
            continue;
        const double mean = cell.sum / cell.count;
        lowest = result.cells == 0 ? mean : std::min(lowest, mean);
        highest = result.cells == 0 ? mean : std::max(highest, mean);
        ++result.cells;
        result.within += cell.squares - cell.sum * mean;
        freedom += cell.count - 1.0;
        sum += mean;
        squares += mean * mean;
        noiseParts += 1.0 / cell.count;
    }
    if (result.cells < 2)
        return result;
    const double cellCount = result.cells;
    result.within /= freedom;
    result.ofMeans = (squares - sum * sum / cellCount) / (cellCount - 1.0);
    result.ofMeans -= result.within * noiseParts / cellCount;
    result.swingDps = highest - lowest;
    return result;
}

// Of the usable rows, where they are means: the noise that is no longer between them.
double varianceWithinMeans(const PointSamples &points, const std::vector<Eigen::Index> &rows, int axis)
{
    if (points.empty())
        return 0.0;
    double samples = 0.0;
    double sum = 0.0;
    for (const Eigen::Index row : rows) {
        samples += points.countAt(row);
        sum += points.countAt(row) * static_cast<double>(points.varianceDps2(row, axis));
    }
    return samples > 0.0 ? sum / samples : 0.0;
}

} // namespace

void checkSufficiency(Draft &draft, const QualityOptions &options)
{
    const Eigen::Index size = draft.recording.size();
    if (size < options.fewestSamples) {
        draft.refuse(Errc::TooFewSamples, "too few samples",
                     "The recording has " + countOf(size, "sample") + "; at least " +
                         countText(options.fewestSamples) + " are needed.");
        return;
    }
    const UsableColumns &columns = draft.usable();
    if (static_cast<Eigen::Index>(columns.size()) < options.fewestSamples) {
        draft.refuse(Errc::NothingUsable, "nothing usable",
                     "Only " + countText(static_cast<Eigen::Index>(columns.size())) + " of " +
                         countOf(size, "sample") +
                         " are usable, the rest is masked; see the findings of this recording.");
        return;
    }
    checkSpan(draft, columns.temperatureC, options);
    checkDuration(draft, options);
}

void checkDrift(Draft &draft)
{
    const UsableColumns &columns = draft.usable();
    if (columns.size() == 0)
        return;
    std::string axes;
    double largestSwingDps = 0.0;
    for (std::size_t axis = 0; axis < columns.rateDps.size(); ++axis) {
        const CellVariances variances = cellVariances(cellsOf(columns.temperatureC, columns.rateDps[axis]));
        const double within = variances.within + varianceWithinMeans(draft.recording.points, columns.rows,
                                                                     static_cast<int>(axis));
        if (variances.cells < 2 || within == 0.0 || variances.ofMeans > kNoDriftPart * within)
            continue;
        axes += (axes.empty() ? "" : ", ") + std::string(kAxisNames[axis]);
        largestSwingDps = std::max(largestSwingDps, variances.swingDps);
    }
    if (axes.empty())
        return;
    draft.note(FindingSeverity::Note, "no drift",
               "The bias of " + axes +
                   " does not change with temperature (the means of 1 °C cells lie within " +
                   fixed(largestSwingDps, 4) +
                   " dps, which the noise explains): there is nothing to compensate, or the data was already "
                   "compensated.");
}

} // namespace driftbench::quality
