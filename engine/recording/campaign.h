// Several prepared runs become a campaign of one sensor.
//
// The runs' names are made unique, the reference rate is set, and what does not fit together is refused:
// another sensor's run, the same recording twice, rates in different units.
//
// Units: a run in rad/s beside runs in dps shows noise and swing smaller by 57.296 on every axis. If both
// ratios lie within 15 % of that, it is an error; if only the noise does, a warning. A run whose noise
// density is implausible for a MEMS gyro (below 0.0008 or above 0.7 dps/sqrt(Hz), median of the axes) gets a
// warning.
#pragma once

#include "engine/base/result.h"
#include "engine/recording/run.h"

#include <Eigen/Core>
#include <vector>

namespace driftbench {

// The rate that was really there.
enum class ReferenceRateKind
{
    Given,       // the same for all runs: zero, or what the rate table did
    InitialHold, // per run the mean of its initial hold; takes each run's bias there with it, so that an
                 // absolute judgement no longer sees the turn-on bias
    OfEachRun,   // as it stands in each run
};

struct CampaignOptions
{
    ReferenceRateKind referenceRate = ReferenceRateKind::Given;
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
};

// Errors: DifferentSensors, SameRecordingTwice, UnitsDiffer (each names the two runs), NothingUsable (no
// runs, or no initial hold where its mean is wanted).
Result<Campaign> makeCampaign(std::vector<Run> runs, const CampaignOptions &options = {});

} // namespace driftbench
