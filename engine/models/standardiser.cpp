#include "engine/models/standardiser.h"

#include <cmath>

namespace driftbench {

Standardiser Standardiser::fit(const Eigen::MatrixXd &rows, const Eigen::VectorXd &weights)
{
    const double total = weights.sum();
    Standardiser result;
    result.mean = (weights.transpose() * rows) / total;
    const Eigen::MatrixXd centred = rows.rowwise() - result.mean;
    result.scale = ((weights.transpose() * centred.cwiseAbs2()) / total).cwiseSqrt();
    for (Eigen::Index column = 0; column < result.scale.size(); ++column) {
        if (!(result.scale[column] > 1e-12 * (1.0 + std::abs(result.mean[column]))))
            result.scale[column] = 1.0;
    }
    return result;
}

} // namespace driftbench
