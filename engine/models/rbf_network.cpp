#include "engine/models/rbf_network.h"

namespace driftbench {

Eigen::MatrixX3d RbfNetwork::predict(const Eigen::MatrixXd &quantities) const
{
    const Eigen::MatrixXd z = inputs.transform(quantities);
    Eigen::MatrixX3d tde = z * linearDps;
    tde.rowwise() += biasDps.transpose();
    Eigen::ArrayXd basis(z.rows());
    for (Eigen::Index j = 0; j < size(); ++j) {
        const double precision = -0.5 / (widths[j] * widths[j]);
        basis = ((z.rowwise() - centres.row(j)).rowwise().squaredNorm().array() * precision).exp();
        tde.noalias() += basis.matrix() * weightsDps.row(j);
    }
    return tde;
}

} // namespace driftbench
