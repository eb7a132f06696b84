#include "engine/recording/initial_hold.h"

#include "engine/base/statistics.h"

#include <cmath>
#include <vector>

namespace driftbench {

namespace {

constexpr double kBandC = 0.5;
constexpr double kShortestS = 60.0;
constexpr double kLargestDriftC = 0.25;
constexpr double kRampC = 0.1;

std::vector<Eigen::Index> usableRows(const Run &run)
{
    std::vector<Eigen::Index> rows;
    for (Eigen::Index i = 0; i < run.mask.size(); ++i) {
        if (run.mask.usableForJudging(i))
            rows.push_back(i);
    }
    return rows;
}

double meanTemperature(const Recording &recording, const std::vector<Eigen::Index> &rows, std::size_t first,
                       std::size_t end)
{
    double sum = 0.0;
    for (std::size_t i = first; i < end; ++i)
        sum += recording.temperatureC[rows[i]];
    return sum / static_cast<double>(end - first);
}

// The median of the first minute stands for the level of the hold.
double earlyLevelC(const Recording &recording, const std::vector<Eigen::Index> &rows)
{
    std::vector<double> early;
    for (const Eigen::Index row : rows) {
        if (recording.timeS[row] - recording.timeS[rows.front()] > kShortestS)
            break;
        early.push_back(recording.temperatureC[row]);
    }
    return median(std::move(early));
}

} // namespace

std::optional<InitialHold> findInitialHold(const Run &run)
{
    const Recording &recording = *run.recording;
    const std::vector<Eigen::Index> rows = usableRows(run);
    if (rows.empty())
        return std::nullopt;
    const double levelC = earlyLevelC(recording, rows);
    const auto offLevel = [&](std::size_t i) { return std::abs(recording.temperatureC[rows[i]] - levelC); };
    std::size_t end = 0;
    while (end < rows.size() && offLevel(end) <= kBandC)
        ++end;
    if (end < rows.size()) {
        while (end > 0 && offLevel(end - 1) > kRampC)
            --end;
    }
    if (end < 2)
        return std::nullopt;
    const double startS = recording.timeS[rows.front()];
    const double endS = recording.timeS[rows[end - 1]];
    const double driftC =
        meanTemperature(recording, rows, end / 2, end) - meanTemperature(recording, rows, 0, end / 2);
    if (endS - startS < kShortestS || std::abs(driftC) > kLargestDriftC)
        return std::nullopt;
    InitialHold hold;
    hold.endSample = rows[end - 1] + 1;
    hold.samples = static_cast<Eigen::Index>(end);
    hold.startS = startS;
    hold.endS = endS;
    hold.meanTemperatureC = meanTemperature(recording, rows, 0, end);
    for (std::size_t i = 0; i < end; ++i)
        hold.meanRateDps += recording.rateDps.row(rows[i]).transpose() / static_cast<double>(end);
    return hold;
}

} // namespace driftbench
