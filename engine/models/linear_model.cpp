#include "engine/models/linear_model.h"

namespace driftbench {

Eigen::MatrixX3d LinearModel::predict(const Eigen::MatrixXd &quantities) const
{
    Eigen::MatrixX3d tde = quantities.col(0) * slopeDpsPerC.transpose();
    tde.rowwise() += biasDps.transpose();
    return tde;
}

LinearModel fitLinear(const TrainingSet &set)
{
    // Weighted least squares over the cells, about the mean dT, so that the two unknowns part.
    double count = 0.0;
    double sumDeltaT = 0.0;
    Eigen::Vector3d sumTde = Eigen::Vector3d::Zero();
    for (const auto &run : set.runs) {
        for (const ThermalCell &cell : run->curve.cells()) {
            count += cell.count;
            sumDeltaT += cell.sumQuantities[0];
            sumTde += cell.sumTdeDps;
        }
    }
    if (count == 0.0)
        return {};
    const double meanDeltaT = sumDeltaT / count;
    double spread = 0.0;
    Eigen::Vector3d product = Eigen::Vector3d::Zero();
    for (const auto &run : set.runs) {
        for (const ThermalCell &cell : run->curve.cells()) {
            if (cell.count == 0.0)
                continue;
            const double d = cell.meanDeltaT() - meanDeltaT;
            spread += cell.count * d * d;
            product += d * cell.sumTdeDps;
        }
    }
    LinearModel model;
    model.slopeDpsPerC = spread > 0.0 ? Eigen::Vector3d(product / spread) : Eigen::Vector3d::Zero();
    model.biasDps = sumTde / count - meanDeltaT * model.slopeDpsPerC;
    return model;
}

} // namespace driftbench
