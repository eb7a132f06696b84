// How much of an error over temperature the temperature-correlated quantities (TCQs) explain: the claim of
// the paper's Eqs. (3) and (12), tested.
//
// For each set of quantities Q the error is fitted by least squares, e = c0 + sum of c_i Q_i(dT), and
//   unexplained  1 - R^2 = sum of residual^2 / sum of (e - mean e)^2
//   rms, largest of the residual, in the unit of the error
// The sets are {dT}, {dT, dT^2}, {dT, dT^2, sgn(dT) sqrt|dT|} of the paper and, for comparison, as many terms
// without a root: {dT, dT^2, dT^3}.
#pragma once

#include "engine/base/result.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace driftbench {

struct TcqShare
{
    std::string name;       // "ΔT, ΔT², √ΔT"
    Eigen::Index terms = 0; // with the constant
    double explained = 0.0; // R^2
    double unexplained = 0.0;
    double residualRms = 0.0;
    double residualLargest = 0.0;
    Eigen::VectorXd residual; // N
};

// deltaTC, error: N each. Errc::TooFewSamples with fewer than eight points, ConstantTemperature or
// InvalidOption where all temperatures or all errors are the same.
Result<std::vector<TcqShare>> explainedByQuantities(const Eigen::VectorXd &deltaTC,
                                                    const Eigen::VectorXd &error);

} // namespace driftbench
