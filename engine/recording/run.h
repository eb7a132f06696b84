// A run is one temperature sweep of one sensor: a recording, the rate that was really there, and what of the
// recording is usable. A campaign is several runs of one sensor.
#pragma once

#include "engine/recording/mask.h"
#include "engine/recording/recording.h"

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace driftbench {

enum class FindingSeverity
{
    Note,
    Warning,
    Refusal
};

// Something that was noticed about a recording.
struct Finding
{
    FindingSeverity severity = FindingSeverity::Note;
    std::string
        kind; // "gap", "motion", "temperature stairs", ... the same word for the same thing everywhere
    std::string message; // a sentence with figures: what, where, and what was done
    double startS = 0.0; // where it is, in the recording's time; start = end = 0 where it is everywhere
    double endS = 0.0;
};

struct Run
{
    std::string name; // short and unique in the campaign: the file name without its ending
    std::shared_ptr<const Recording> recording;
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    Mask mask;                     // as long as the recording
    std::vector<Finding> findings; // in the order of time
};

struct Campaign
{
    std::vector<Run> runs;
    SensorIdentity sensor;
    std::vector<std::string> warnings; // about the runs together
};

} // namespace driftbench
