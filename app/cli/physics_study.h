// All that `driftbench-cli physics` shows: the combs over a range of temperature, how sensitive they are, and
// what the temperature-correlated quantities explain of their error.
#pragma once

#include "engine/base/result.h"
#include "engine/evaluation/tcq_explained.h"
#include "engine/physics/comb_sensitivities.h"
#include "engine/physics/comb_sweep.h"

#include <string>
#include <vector>

namespace driftbench::cli {

struct PhysicsRequest
{
    CombParameters comb;
    CombTransducer transducer;
    CombSweepRange range;
};

struct GapProfile
{
    double temperatureC = 0.0;
    Eigen::VectorXd gapUm; // at PhysicsStudy::alongUm
};

struct PhysicsStudy
{
    PhysicsRequest request;
    CombSweep table;
    CombSweep curve; // the same range in kCurvePoints, for plots and for the quantities
    CombSensitivities sensitivities;
    double sensitivitiesAtC = 0.0;    // the end of the table
    std::vector<TcqShare> quantities; // empty where there is nothing to explain, for this reason:
    std::string nothingToExplain;
    double thinnestCombUm = 0.0; // by Eq. (8), anywhere in the table; below zero the formula no longer holds
    Eigen::VectorXd alongUm;
    std::vector<GapProfile> gaps;
};

inline constexpr int kCurvePoints = 501;

// The errors of CombCapacitor::create and sweepComb.
Result<PhysicsStudy> studyPhysics(const PhysicsRequest &request);

} // namespace driftbench::cli
