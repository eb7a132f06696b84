// The temperature-correlated quantities (TCQs) of the paper, Eqs. (3) and (12): dT, dT^2, dT^(1/2).
//
// dT = T - Tref in degrees Celsius, Tref being one reference temperature per campaign, kept in every model.
// Noise makes dT < 0 around the reference, so the root is the signed one: sgn(dT) sqrt(|dT|).
#pragma once

#include <Eigen/Core>
#include <string_view>

namespace driftbench {

// Which TCQs a model looks at. The number of a set is the number of its columns.
enum class FeatureSet
{
    DeltaT = 1,            // [dT]
    DeltaTSquared = 2,     // [dT, dT^2]
    DeltaTSquaredRoot = 3, // [dT, dT^2, sgn(dT) sqrt|dT|]
};

std::string_view featureSetName(FeatureSet set);

double signedRoot(double deltaT);

Eigen::Vector3d temperatureQuantities(double deltaT);

// N -> N x F
Eigen::MatrixXd temperatureQuantities(FeatureSet set, const Eigen::VectorXd &deltaT);

} // namespace driftbench
