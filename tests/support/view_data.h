// Data as the views get them, made without any other part of the engine than the features: a campaign of runs
// over the paper's profile (hold at -40, steps of 0.5 degrees up to 85, hold), curved drift, white noise.
#pragma once

#include "engine/base/random.h"
#include "engine/evaluation/allan.h"
#include "engine/features/run_features.h"
#include "engine/models/rbf_trainer.h"
#include "engine/models/trained_model.h"

#include <memory>
#include <vector>

namespace driftbench::test {

inline constexpr double kReferenceTemperatureC = -40.0;

Eigen::Vector3d trueTdeDps(double deltaT);

// secondsASample 0.1: the 111 000 samples of a run of the paper. cooling: the profile backwards.
std::shared_ptr<const RunFeatures> syntheticRun(std::uint64_t seed, double secondsASample,
                                                bool cooling = false);

std::vector<std::shared_ptr<const RunFeatures>> syntheticRuns(int count, double secondsASample);

// Eight Gaussians fitted to the true curve.
TrainedModel syntheticRbf();
TrainedModel syntheticLine();
UncertaintyBand syntheticBand();
RbfSelection syntheticSelection();
AllanCurve syntheticAllan(double driftDpsAtHour);

// TDE of a run less the model's.
Eigen::MatrixX3d residualOf(const RunFeatures &run, const TrainedModel &model);

} // namespace driftbench::test
