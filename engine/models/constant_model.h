// The yardstick: one bias per axis, no temperature. What is worse than this must not be exported.
#pragma once

#include "engine/features/run_features.h"
#include "engine/models/model_concept.h"

namespace driftbench {

struct ConstantModel
{
    static constexpr FeatureSet kFeatures = FeatureSet::DeltaT;

    Eigen::Vector3d biasDps = Eigen::Vector3d::Zero();

    Eigen::MatrixX3d predict(const Eigen::MatrixXd &quantities) const
    {
        return biasDps.transpose().replicate(quantities.rows(), 1);
    }
};

// The mean TDE of all training samples.
ConstantModel fitConstant(const TrainingSet &set);

} // namespace driftbench
