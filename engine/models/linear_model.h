// Conventional 1 of the paper (MSD4): least squares on dT.   tde = b + a dT
#pragma once

#include "engine/features/run_features.h"
#include "engine/models/model_concept.h"

namespace driftbench {

struct LinearModel
{
    static constexpr FeatureSet kFeatures = FeatureSet::DeltaT;

    Eigen::Vector3d biasDps = Eigen::Vector3d::Zero();      // b
    Eigen::Vector3d slopeDpsPerC = Eigen::Vector3d::Zero(); // a

    Eigen::MatrixX3d predict(const Eigen::MatrixXd &quantities) const; // N x 1
};

LinearModel fitLinear(const TrainingSet &set);

} // namespace driftbench
