// What no function of temperature can remove from a run, and what is left after averaging.
#pragma once

#include "engine/features/run_features.h"

#include <Eigen/Core>

namespace driftbench {

// Variance within temperature cells of cellWidthC, corrected for degrees of freedom, per axis in dps^2.
// With a slope of the curve inside a cell the cell's own trend counts as noise; 0.5 degrees keeps that small.
Eigen::Vector3d noiseFloor(const RunFeatures &run, double cellWidthC = 0.5);

// Rms of the residual after averaging over consecutive windows of windowS seconds (only windows that are at
// least half full), per axis in dps. residualDps: M x 3 at timeS.
Eigen::Vector3d rmsAfterAveraging(const Eigen::VectorXd &timeS, const Eigen::MatrixX3d &residualDps,
                                  double windowS = 10.0);

} // namespace driftbench
