// The peers' model: a cubic in temperature,
//   tde = c0 + c1 d + c2 d^2 + c3 d^3   with d = dT - centre
// fitted as PX4 does offline (Tools/process_sensor_caldata.py: median filter of 31 samples, 2000 temperature
// bins averaged, cubic polyfit about the middle of the range) or as ArduPilot does
// (Tools/scripts/tempcal_IMU.py: means of 2 s, cubic polyfit about 35 degrees Celsius).
#pragma once

#include "engine/features/run_features.h"
#include "engine/models/model_concept.h"

namespace driftbench {

struct PolynomialModel
{
    static constexpr FeatureSet kFeatures = FeatureSet::DeltaT;

    double centreDeltaT = 0.0; // d = dT - centreDeltaT
    Eigen::Matrix<double, 4, 3> coefficients =
        Eigen::Matrix<double, 4, 3>::Zero(); // row: power, column: axis; dps/C^k

    Eigen::MatrixX3d predict(const Eigen::MatrixXd &quantities) const; // N x 1
};

PolynomialModel fitCubicAsPx4(const TrainingSet &set);
PolynomialModel fitCubicAsArduPilot(const TrainingSet &set);

} // namespace driftbench
