// The initial hold: the stretch at the start of a run in which the temperature is held (the paper: 30 min at
// -40 degrees Celsius). Its mean temperature is the campaign's reference where the runs share it, and its
// mean rate may stand for the reference rate.
//
// The temperature counts as held while it stays within 0.5 degrees of its median in the first minute, for 60
// s at least, unless it drifts through that band: the means of the stretch's halves must agree within 0.25
// degrees. The end is set back to where the temperature last was within 0.1 degrees of the hold, so that the
// start of the ramp does not count.
#pragma once

#include "engine/recording/run.h"

#include <Eigen/Core>
#include <optional>

namespace driftbench {

struct InitialHold
{
    Eigen::Index endSample = 0; // one past the last sample of the hold
    Eigen::Index samples = 0;   // usable ones
    double startS = 0.0;
    double endS = 0.0;
    double meanTemperatureC = 0.0;
    Eigen::Vector3d meanRateDps = Eigen::Vector3d::Zero(); // as measured
};

// Nothing if the run does not start with a hold.
std::optional<InitialHold> findInitialHold(const Run &run);

} // namespace driftbench
