// The peers' model: a cubic in temperature,
//   tde = c0 + c1 d + c2 d^2 + c3 d^3   with d = dT - centre
// fitted as PX4 does offline (Tools/process_sensor_caldata.py: median filter of 31 samples, 2000 temperature
// bins averaged, cubic polyfit about the middle of the range) or as ArduPilot does
// (Tools/scripts/tempcal_IMU.py: means of 2 s, cubic polyfit about 35 degrees Celsius).
//
// Followed to the letter: PX4 filters the rates and not the temperature, with zeros beyond both ends of the
// log (scipy's medfilt), spreads the bins evenly over TMIN .. TMAX of the raw temperature, takes the mean
// temperature and rate of each bin and gives every occupied bin the same weight. ArduPilot's means are a
// moving one, one mean for each sample from the window's end on, over 2 * int(samples / seconds) samples, of
// rates and temperature alike. Both clamp the temperature to the fitted range when they correct, as every
// model here does.
//
// The peers fit one log. With several runs the filters work within each run and the bins and the fit are over
// all runs together. Both get the samples that all models are trained on; the peers themselves mask nothing.
// Without samples all coefficients are zero; where a coefficient is not determined (fewer than four different
// temperatures) the shortest scaled solution is taken, as numpy does.
#pragma once

#include "engine/features/run_features.h"
#include "engine/models/model_concept.h"

#include <memory>

namespace driftbench {

struct PolynomialModel
{
    static constexpr FeatureSet kFeatures = FeatureSet::DeltaT;

    double centreDeltaT = 0.0; // d = dT - centreDeltaT
    Eigen::Matrix<double, 4, 3> coefficients =
        Eigen::Matrix<double, 4, 3>::Zero(); // row: power, column: axis; dps/C^k

    Eigen::MatrixX3d predict(const Eigen::MatrixXd &quantities) const; // N x 1
};

// The filtered runs, so that leaving one run out after the other filters each only once. Safe to share
// between threads; holds on to the runs that it has seen.
class PeerSeriesCache;
std::shared_ptr<PeerSeriesCache> makePeerSeriesCache();

PolynomialModel fitCubicAsPx4(const TrainingSet &set,
                              const std::shared_ptr<PeerSeriesCache> &cache = nullptr);
PolynomialModel fitCubicAsArduPilot(const TrainingSet &set,
                                    const std::shared_ptr<PeerSeriesCache> &cache = nullptr);

} // namespace driftbench
