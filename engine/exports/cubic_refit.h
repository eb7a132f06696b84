// The autopilots know a cubic only: one is fitted to the chosen model by dense least squares,
//   tde = c0 + c1 d + c2 d^2 + c3 d^3   with d = T - centre
// over 2001 equally spaced temperatures of a range, unlike their own fits independent of how long the log
// stayed at a temperature. What that costs against the model is measured over the whole trained range.
#pragma once

#include "engine/models/trained_model.h"

#include <Eigen/Core>
#include <array>
#include <string>

namespace driftbench {

struct CubicRefit
{
    double centreC = 0.0;
    double lowestTemperatureC = 0.0; // of the fit; outside, the autopilots hold the edge value
    double highestTemperatureC = 0.0;
    Eigen::Matrix<double, 4, 3> coefficientsDps =
        Eigen::Matrix<double, 4, 3>::Zero();                  // row: power, column: axis; dps/C^k
    Eigen::Vector3d largestLossDps = Eigen::Vector3d::Zero(); // of |cubic - model| over the trained range
    Eigen::Vector3d rmsLossDps = Eigen::Vector3d::Zero();

    Eigen::Vector3d tdeDps(double temperatureC) const; // temperature held at the edges of the fit
};

// The model must be one that checkTabulable (compensation_table.h) passed. Axes that are not compensated have
// zeros and no loss.
CubicRefit refitCubic(const TrainedModel &model, const std::array<bool, 3> &compensated, double centreC,
                      double lowestTemperatureC, double highestTemperatureC);

// "Against rbf the cubic is off by up to 0.12 dps (0.04 dps rms) on y, ..." for the compensated axes.
std::string lossSentence(const CubicRefit &cubic, const std::string &modelName,
                         const std::array<bool, 3> &compensated);

} // namespace driftbench
