#include "engine/recording/run_report.h"

#include "engine/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace driftbench {

namespace {

constexpr double kNoiseCellC = 0.5;
constexpr double kCoverageCellC = 1.0;
// Heating and cooling are told apart by the temperature this long before and after.
constexpr double kTrendReachS = 30.0;

std::vector<Eigen::Index> usableRows(const Run &run)
{
    std::vector<Eigen::Index> rows;
    rows.reserve(static_cast<std::size_t>(run.mask.size()));
    for (Eigen::Index i = 0; i < run.mask.size(); ++i) {
        if (run.mask.usableForJudging(i))
            rows.push_back(i);
    }
    return rows;
}

void describeMask(const Run &run, RunReport &report)
{
    for (const MaskReason reason : kMaskReasons) {
        const Eigen::Index count = run.mask.count(reason);
        if (count > 0) {
            report.masked.push_back(
                {reason, count, 100.0 * static_cast<double>(count) / static_cast<double>(report.samples)});
        }
    }
}

void describeTime(const Recording &recording, const std::vector<Eigen::Index> &rows, RunReport &report)
{
    report.startS = recording.timeS[rows.front()];
    report.durationS = recording.timeS[rows.back()] - report.startS;
    std::vector<double> intervals;
    intervals.reserve(rows.size());
    for (std::size_t i = 1; i < rows.size(); ++i)
        intervals.push_back(recording.timeS[rows[i]] - recording.timeS[rows[i - 1]]);
    if (intervals.empty())
        return;
    report.intervalS = median(intervals);
    report.intervalJitterS = robustSigma(std::move(intervals));
    report.sampleRateHz = 1.0 / report.intervalS;
}

// Degrees per minute around each usable sample.
std::vector<double> temperatureTrend(const Recording &recording, const std::vector<Eigen::Index> &rows)
{
    std::vector<double> trend(rows.size(), 0.0);
    std::size_t before = 0;
    std::size_t after = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double timeS = recording.timeS[rows[i]];
        while (recording.timeS[rows[before]] < timeS - kTrendReachS)
            ++before;
        while (after + 1 < rows.size() && recording.timeS[rows[after + 1]] <= timeS + kTrendReachS)
            ++after;
        const double durationS = recording.timeS[rows[after]] - recording.timeS[rows[before]];
        if (durationS > 0.0) {
            trend[i] = 60.0 * (recording.temperatureC[rows[after]] - recording.temperatureC[rows[before]]) /
                       durationS;
        }
    }
    return trend;
}

void describeCoverage(const Recording &recording, const std::vector<Eigen::Index> &rows, RunReport &report)
{
    const std::vector<double> trend = temperatureTrend(recording, rows);
    const double firstCell = std::floor(report.lowestTemperatureC / kCoverageCellC);
    const double lastCell = std::floor(report.highestTemperatureC / kCoverageCellC);
    report.coverage.resize(static_cast<std::size_t>(lastCell - firstCell) + 1);
    for (std::size_t c = 0; c < report.coverage.size(); ++c)
        report.coverage[c].centreC = (firstCell + static_cast<double>(c) + 0.5) * kCoverageCellC;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CoverageCell &cell = report.coverage[static_cast<std::size_t>(
            std::floor(recording.temperatureC[rows[i]] / kCoverageCellC) - firstCell)];
        (trend[i] >= 0.0 ? cell.heatingS : cell.coolingS) += report.intervalS;
        report.largestHeatingCPerMin = std::max(report.largestHeatingCPerMin, trend[i]);
        report.largestCoolingCPerMin = std::max(report.largestCoolingCPerMin, -trend[i]);
    }
    const auto occupied = std::count_if(report.coverage.begin(), report.coverage.end(),
                                        [](const CoverageCell &c) { return c.heatingS + c.coolingS > 0.0; });
    const auto both =
        std::count_if(report.coverage.begin(), report.coverage.end(),
                      [](const CoverageCell &c) { return c.heatingS > 0.0 && c.coolingS > 0.0; });
    if (occupied > 0)
        report.heatedAndCooledPart = static_cast<double>(both) / static_cast<double>(occupied);
}

double noiseWithinCells(const Recording &recording, const std::vector<Eigen::Index> &rows, int axis,
                        double lowestC)
{
    struct Cell
    {
        double count = 0.0;
        double mean = 0.0;
    };
    std::vector<Cell> cells;
    double squares = 0.0;
    double freedom = 0.0;
    for (const Eigen::Index row : rows) {
        const auto index = static_cast<std::size_t>((recording.temperatureC[row] - lowestC) / kNoiseCellC);
        if (index >= cells.size())
            cells.resize(index + 1);
        Cell &cell = cells[index];
        // Welford's update: no cancellation with a large reference rate.
        cell.count += 1.0;
        const double offset = recording.rateDps(row, axis) - cell.mean;
        cell.mean += offset / cell.count;
        squares += offset * (recording.rateDps(row, axis) - cell.mean);
        freedom += cell.count > 1.0 ? 1.0 : 0.0;
    }
    return freedom > 0.0 ? std::sqrt(squares / freedom) : std::numeric_limits<double>::quiet_NaN();
}

AxisReport describeAxis(const Recording &recording, const std::vector<Eigen::Index> &rows, int axis,
                        double lowestC)
{
    AxisReport report;
    std::vector<double> differences;
    differences.reserve(rows.size());
    report.lowestDps = report.highestDps = recording.rateDps(rows.front(), axis);
    double sum = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double rate = recording.rateDps(rows[i], axis);
        sum += rate;
        report.lowestDps = std::min(report.lowestDps, rate);
        report.highestDps = std::max(report.highestDps, rate);
        if (i > 0)
            differences.push_back(rate - recording.rateDps(rows[i - 1], axis));
    }
    report.meanDps = sum / static_cast<double>(rows.size());
    report.noiseWithinCellDps = noiseWithinCells(recording, rows, axis, lowestC);
    report.noiseDifferencesDps = robustSigma(std::move(differences)) / std::numbers::sqrt2;
    return report;
}

} // namespace

RunReport summarise(const Run &run)
{
    const Recording &recording = *run.recording;
    RunReport report;
    report.samples = recording.size();
    report.usableForJudging = run.mask.countUsableForJudging();
    report.usableForTraining = run.mask.countUsableForTraining();
    describeMask(run, report);
    const std::vector<Eigen::Index> rows = usableRows(run);
    if (rows.empty())
        return report;
    describeTime(recording, rows, report);
    const auto colder = [&](Eigen::Index a, Eigen::Index b) {
        return recording.temperatureC[a] < recording.temperatureC[b];
    };
    const auto [low, high] = std::minmax_element(rows.begin(), rows.end(), colder);
    report.lowestTemperatureC = recording.temperatureC[*low];
    report.highestTemperatureC = recording.temperatureC[*high];
    describeCoverage(recording, rows, report);
    for (int axis = 0; axis < kAxisCount; ++axis)
        report.axes[static_cast<std::size_t>(axis)] =
            describeAxis(recording, rows, axis, report.lowestTemperatureC);
    return report;
}

} // namespace driftbench
