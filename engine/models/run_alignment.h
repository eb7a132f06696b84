// Offsets of runs against their common curve, so that runs over different temperatures meet on one curve.
//
// Two-way model  y_rc = g_c + u_r + noise  over 1 degree cells c and runs r, cell weight w = n / (1 + n /
// median n). Eliminating g leaves L u = b with the Laplacian L = sum_c (diag(w_c) - w_c w_c' / W_c), which is
// solved with minimum norm; its null space holds a constant for each group of runs that share temperatures,
// so sum u = 0.
#pragma once

#include "engine/features/run_features.h"

#include <Eigen/Core>
#include <vector>

namespace driftbench {

struct RunAlignment
{
    Eigen::MatrixX3d offsetDps; // R x 3, each column sums to 0
    int groups = 1;             // of runs that share temperatures; more than one: those can't be aligned
};

RunAlignment alignRuns(const TrainingSet &set);

} // namespace driftbench
