// A held-out run before and after a model, as it is drawn: TDE over time and its Allan deviation.
//
// Before is the TDE less the constant that was trained without the run (so that drift shows, not bias), after
// the TDE less the model. Where judging is anchored, each has the mean of the run's start removed, as in
// scoring.h. dps; N samples usable for judging.
#pragma once

#include "engine/evaluation/allan.h"
#include "engine/evaluation/scoring.h"
#include "engine/features/run_features.h"
#include "engine/models/trained_model.h"

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace driftbench {

struct JudgedTraces
{
    std::string run;
    std::string model;
    std::vector<std::string> trainedOn;
    bool lessConstant = false; // false: there was no constant, before is the TDE itself
    Eigen::VectorXd timeS;     // N
    Eigen::MatrixX3d beforeDps;
    Eigen::MatrixX3d afterDps;
    AllanCurve allanBefore;
    AllanCurve allanAfter;
};

// model, constant (may be null): trained without the run, which has their reference temperature.
JudgedTraces judgedTraces(const std::shared_ptr<const RunFeatures> &run, const TrainedModel &model,
                          const TrainedModel *constant, Judging judging);

} // namespace driftbench
