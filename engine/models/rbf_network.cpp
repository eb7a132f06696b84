#include "engine/models/rbf_network.h"

#include <algorithm>

namespace driftbench {

namespace {

constexpr Eigen::Index kBlockRows = 1024;

} // namespace

Eigen::MatrixX3d RbfNetwork::predict(const Eigen::MatrixXd &quantities) const
{
    Eigen::MatrixX3d tde(quantities.rows(), 3);
    // In blocks that stay in the cache while every centre passes over them.
    for (Eigen::Index start = 0; start < quantities.rows(); start += kBlockRows) {
        const Eigen::Index rows = std::min(kBlockRows, quantities.rows() - start);
        const Eigen::MatrixX3d z = inputs.transform(quantities.middleRows(start, rows));
        Eigen::MatrixX3d sum = z * linearDps;
        sum.rowwise() += biasDps.transpose();
        Eigen::ArrayXd basis(rows);
        for (Eigen::Index j = 0; j < size(); ++j) {
            const double precision = -0.5 / (widths[j] * widths[j]);
            basis =
                (((z.col(0).array() - centres(j, 0)).square() + (z.col(1).array() - centres(j, 1)).square() +
                  (z.col(2).array() - centres(j, 2)).square()) *
                 precision)
                    .exp();
            for (int axis = 0; axis < 3; ++axis)
                sum.col(axis).array() += weightsDps(j, axis) * basis;
        }
        tde.middleRows(start, rows) = sum;
    }
    return tde;
}

} // namespace driftbench
