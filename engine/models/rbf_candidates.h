// Where Gaussians may stand, and how wide they may be.
#pragma once

#include "engine/models/rbf_path.h"

namespace driftbench {

struct RbfCandidates
{
    Eigen::MatrixX3d centres; // M x 3, standardised
    Eigen::VectorXd widths;   // M, standardised
    std::vector<double> centreDeltaT;
    std::vector<double> widthDeltaT;
};

// Preset best: widths w = span * 2^-l, centres every w / 2 with both ends; sigma = |phi(d + w) - phi(d - w)|
// / 2 in standardised TCQ space. A candidate is kept only where data support it: the largest hole between
// occupied cells within d +- 2 w is at most w, and at least 50 samples lie within d +- w. Without that rule a
// gap in temperature is bridged by whatever the noise suggests.
//
// Preset paper (options.standardisedWidth > 0): one sigma, centres at 65 temperatures, the same rule with the
// width in degrees that this sigma has there.
RbfCandidates rbfCandidates(const ThermalRows &rows, const Standardiser &inputs,
                            const RbfPathOptions &options);

} // namespace driftbench
