// Heating against cooling: what a curve of temperature alone cannot follow.
#pragma once

#include "engine/features/run_features.h"

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

namespace driftbench {

// Mean TDE of one sweep of one run at one temperature.
struct Passage
{
    std::string run;
    bool heating = true;
    Eigen::Vector3d tdeDps = Eigen::Vector3d::Zero();
};

struct Hysteresis
{
    bool heatingAndCooling = false; // both directions occur at common temperatures
    // Rms over common 1 degree cells of the difference of heating and cooling, per axis; NaN without both.
    Eigen::Vector3d rmsDps = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    // Where most passages meet (the middle of such temperatures, a multiple of 5 degrees; of 1 degree if the
    // campaign spans less than 20), and what each reads there (within 1 degree). NaN and empty where no two
    // meet.
    double meetingTemperatureC = std::numeric_limits<double>::quiet_NaN();
    std::vector<Passage> passages; // in the order of runs and time
};

Hysteresis analyseHysteresis(const TrainingSet &set);

} // namespace driftbench
