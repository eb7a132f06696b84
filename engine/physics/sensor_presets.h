// Simulated sensors made from datasheet figures, the comb physics and the size of the drift that the paper
// measured, so that the columns before and after compensation lie where Tables 1-6 have them.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/simulation_options.h"

#include <Eigen/Core>
#include <string_view>

namespace driftbench {

// The gyro of that model (datasheets.h) in the paper's chamber on the paper's profile, at a reference rate:
// noise, quantisation, range, spread and the drift curves of its combs. Errc::InvalidOption for an unknown
// model or a rate outside its range.
Result<SimulationOptions> presetSimulation(std::string_view model, const Eigen::Vector3d &referenceRateDps);

} // namespace driftbench
