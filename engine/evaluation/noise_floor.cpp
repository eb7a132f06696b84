#include "engine/evaluation/noise_floor.h"

#include "engine/base/statistics.h"

#include <cmath>
#include <limits>

namespace driftbench {

Eigen::Vector3d noiseFloor(const RunFeatures &run, double cellWidthC)
{
    ThermalCurve cells(cellWidthC);
    if (run.deltaT.size() > 0)
        cells.makeRoomFrom(run.deltaT.minCoeff());
    for (Eigen::Index row = 0; row < run.deltaT.size(); ++row)
        run.addTo(cells, row);
    return cells.pooledVariance();
}

namespace {

double medianInterval(const Eigen::VectorXd &timeS)
{
    std::vector<double> intervals(static_cast<std::size_t>(timeS.size() - 1));
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        intervals[i] = timeS[row + 1] - timeS[row];
    }
    return median(std::move(intervals));
}

} // namespace

std::vector<TimeWindow> averagingWindows(const Eigen::VectorXd &timeS, double windowS)
{
    std::vector<TimeWindow> windows;
    if (timeS.size() < 2)
        return windows;
    const double halfFull = 0.5 * windowS / medianInterval(timeS);
    const auto windowOf = [&](Eigen::Index sample) {
        return std::floor((timeS[sample] - timeS[0]) / windowS);
    };
    for (Eigen::Index first = 0; first < timeS.size();) {
        const double window = windowOf(first);
        Eigen::Index last = first + 1;
        while (last < timeS.size() && windowOf(last) == window)
            ++last;
        if (static_cast<double>(last - first) >= halfFull)
            windows.push_back({first, last});
        first = last;
    }
    return windows;
}

Eigen::Vector3d rmsAfterAveraging(const std::vector<TimeWindow> &windows, const Eigen::MatrixX3d &residualDps)
{
    if (windows.empty())
        return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    for (const TimeWindow &window : windows) {
        const auto rows = residualDps.middleRows(window.first, window.last - window.first);
        squares += rows.colwise().mean().transpose().cwiseAbs2();
    }
    return (squares / static_cast<double>(windows.size())).cwiseSqrt();
}

Eigen::Vector3d rmsAfterAveraging(const Eigen::VectorXd &timeS, const Eigen::MatrixX3d &residualDps,
                                  double windowS)
{
    return rmsAfterAveraging(averagingWindows(timeS, windowS), residualDps);
}

} // namespace driftbench
