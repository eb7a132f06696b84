// A model as a drawn curve: TDE over dT on a grid, and what is left of samples after it.
#pragma once

#include "engine/models/trained_model.h"

#include <Eigen/Core>

#include <string>

namespace driftbench {

struct ModelCurve
{
    std::string name;        // of the model, as in files
    Eigen::VectorXd deltaT;  // P, rising
    Eigen::MatrixX3d tdeDps; // P x 3
};

// dT values that draw smoothly over dT, dT^2 and the signed root alike.
Eigen::VectorXd curveGrid(double lowestDeltaT, double highestDeltaT);

// Over the model's trained range.
ModelCurve modelCurve(const TrainedModel &model);

// Of one axis at dT, with the edge values held outside the grid; NaN for an empty curve or a NaN dT.
double interpolated(const ModelCurve &curve, int axis, double deltaT);

} // namespace driftbench
