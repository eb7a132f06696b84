#include "engine/features/temperature_quantities.h"

#include <cmath>

namespace driftbench {

std::string_view featureSetName(FeatureSet set)
{
    switch (set) {
    case FeatureSet::DeltaT:
        return "dT";
    case FeatureSet::DeltaTSquared:
        return "dT,dT^2";
    case FeatureSet::DeltaTSquaredRoot:
        return "dT,dT^2,dT^0.5";
    }
    return "";
}

double signedRoot(double deltaT)
{
    return std::copysign(std::sqrt(std::abs(deltaT)), deltaT);
}

Eigen::Vector3d temperatureQuantities(double deltaT)
{
    return {deltaT, deltaT * deltaT, signedRoot(deltaT)};
}

Eigen::MatrixXd temperatureQuantities(FeatureSet set, const Eigen::VectorXd &deltaT)
{
    const int columns = static_cast<int>(set);
    Eigen::MatrixXd quantities(deltaT.size(), columns);
    quantities.col(0) = deltaT;
    if (columns >= 2)
        quantities.col(1) = deltaT.cwiseAbs2();
    if (columns >= 3)
        quantities.col(2) = deltaT.unaryExpr(&signedRoot);
    return quantities;
}

} // namespace driftbench
