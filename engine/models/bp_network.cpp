#include "engine/models/bp_network.h"

#include "engine/models/bp_activation.h"

namespace driftbench {

Eigen::MatrixX3d BpNetwork::predict(const Eigen::MatrixXd &quantities) const
{
    const Eigen::MatrixXd z = inputs.transform(quantities);
    Eigen::MatrixX3d tde(z.rows(), 3);
    for (std::size_t a = 0; a < axes.size(); ++a) {
        const Axis &axis = axes[a];
        Eigen::MatrixXd hidden = z * axis.hiddenWeights.transpose();
        hidden.rowwise() += axis.hiddenBias.transpose();
        tanhInPlace(hidden);
        const Eigen::ArrayXd output = (hidden * axis.outputWeights).array() + axis.outputBias;
        tde.col(static_cast<Eigen::Index>(a)) = axis.outputMeanDps + axis.outputScaleDps * output;
    }
    return tde;
}

} // namespace driftbench
