// What can be said of a campaign before anything is trained for use: how far its TDE is a curve of
// temperature at all, and where the temperature has been.
//
//   swing    highest less lowest mean TDE over cells of 1 degree, sweep by sweep (dps)
//   noise    root of the noise floor (noise_floor.h), mean over the runs by their samples (dps)
//   left     rms of what a curve leaves of all samples (dps)
//   spread   highest less lowest passage where most sweeps meet (hysteresis.h); NaN where none do (dps)
//
// Coverage: seconds in each cell of 1 degree, heating and cooling (sweeps.h); a sample counts for the median
// interval of its run.
#pragma once

#include "engine/evaluation/hysteresis.h"
#include "engine/features/run_features.h"
#include "engine/models/trained_model.h"

#include <Eigen/Core>
#include <array>

namespace driftbench {

enum class CurveKind
{
    Curve,  // the curve leaves little more than the noise: less than 1.2 times
    Nearly, // it leaves more than that, but less than a twentieth of the swing or three times the noise
    Not     // neither
};

struct AxisInspection
{
    double swingDps = 0.0;
    double noiseDps = 0.0;
    double leftDps = 0.0;
    double spreadDps = 0.0;
    CurveKind kind = CurveKind::Curve;
};

struct TemperatureCoverage
{
    double firstC = 0.0;      // lower edge of the first cell, a whole degree
    Eigen::VectorXd heatingS; // C cells of 1 degree
    Eigen::VectorXd coolingS; // C
    double lowestC = 0.0;     // of all samples
    double highestC = 0.0;
    double bothShare = 0.0; // of the cells that were reached, those that were heated and cooled through
};

// Local rms of what the curve leaves, over +-2.5 degrees.
struct ResidualSpread
{
    Eigen::VectorXd deltaT;  // C
    Eigen::MatrixX3d rmsDps; // C x 3
};

struct CampaignInspection
{
    std::array<AxisInspection, 3> axes;
    Hysteresis hysteresis;
    TemperatureCoverage coverage;
    ResidualSpread spread;
};

TemperatureCoverage coverageOf(const TrainingSet &set);

// curve: a model of temperature alone, fitted to the set.
CampaignInspection inspectCampaign(const TrainingSet &set, const AnyModel &curve);

} // namespace driftbench
