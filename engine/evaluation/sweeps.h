// A run's sweeps: stretches over which the temperature goes one way.
#pragma once

#include "engine/features/run_features.h"

#include <vector>

namespace driftbench {

struct Sweep
{
    Eigen::Index first = 0; // samples first .. last - 1 of the run
    Eigen::Index last = 0;
    bool heating = true;
};

// A turn counts when the temperature comes back by more than a tenth of the run's span and by more than
// 2 degrees; holds belong to the sweeps beside them. Together the sweeps are the whole run.
std::vector<Sweep> sweepsOf(const RunFeatures &run);

// The samples of one sweep that are usable for training.
ThermalCurve curveOf(const RunFeatures &run, const Sweep &sweep);

} // namespace driftbench
