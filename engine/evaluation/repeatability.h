// How repeatable a campaign's bias is, without any model: the curve that the runs share against the way each
// differs from it.
//
// In cells of 1 degree: V_repeat is the variance of the runs' means within a cell, pooled over the cells by
// degrees of freedom; V_curve the variance of the cells' means over the range, less what V_repeat adds to it.
// A model fitted to the other R - 1 runs can at best reach
//   G* = V_curve / (V_curve + V_repeat R / (R - 1))
// of the constant's error on a run it has not seen. A single run is taken sweep by sweep.
#pragma once

#include "engine/features/run_features.h"

#include <Eigen/Core>

namespace driftbench {

struct Repeatability
{
    int runs = 0;                  // or sweeps, R
    bool sweeps = false;           // of a single run
    Eigen::Vector3d curveRmsDps;   // sqrt V_curve
    Eigen::Vector3d repeatRmsDps;  // sqrt V_repeat; NaN where no two share a temperature
    Eigen::Vector3d gainModelFree; // G*; NaN likewise
    Eigen::Vector3d inRunVariance; // dps^2, of 1 degree cell means within a run, noise removed, mean of runs
};

Repeatability analyseRepeatability(const TrainingSet &set);

} // namespace driftbench
