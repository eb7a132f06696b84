// A model evaluated at many temperatures through a table: every model is a function of dT alone, and a long
// run has far more samples than the curve has detail.
#pragma once

#include "engine/models/trained_model.h"

#include <Eigen/Core>

namespace driftbench {

// predictAtDeltaT to within 1e-5 dps: where there are enough samples to pay for a table, by four-point
// interpolation in the signed root of dT (in which the TCQs are smooth on either side of 0) with nodes at
// most 0.1 degrees apart. The table is checked half way between its nodes; a model with sharper detail is
// evaluated at every sample.
Eigen::MatrixX3d predictThroughTable(const AnyModel &model, const Eigen::VectorXd &deltaT);

} // namespace driftbench
