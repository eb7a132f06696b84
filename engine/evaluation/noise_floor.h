// What no function of temperature can remove from a run, and what is left after averaging.
#pragma once

#include "engine/features/run_features.h"

#include <Eigen/Core>
#include <vector>

namespace driftbench {

// Variance within temperature cells of cellWidthC, corrected for degrees of freedom, per axis in dps^2, of
// the samples usable for judging (what every MSD is taken over). With a slope of the curve inside a cell the
// cell's own trend counts as noise; 0.5 degrees keeps that small. NaN if no cell has two samples.
Eigen::Vector3d noiseFloor(const RunFeatures &run, double cellWidthC = 0.5);

// Samples first .. last - 1 of a window of time.
struct TimeWindow
{
    Eigen::Index first = 0;
    Eigen::Index last = 0;
};

// Consecutive windows of windowS seconds from the first sample on; only those that are at least half full
// (against the median interval).
std::vector<TimeWindow> averagingWindows(const Eigen::VectorXd &timeS, double windowS = 10.0);

// Rms of the windows' means, per axis in dps; NaN without a window. residualDps: M x 3.
Eigen::Vector3d rmsAfterAveraging(const std::vector<TimeWindow> &windows,
                                  const Eigen::MatrixX3d &residualDps);
Eigen::Vector3d rmsAfterAveraging(const Eigen::VectorXd &timeS, const Eigen::MatrixX3d &residualDps,
                                  double windowS = 10.0);

} // namespace driftbench
