#include "engine/models/constant_model.h"

namespace driftbench {

ConstantModel fitConstant(const TrainingSet &set)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0.0;
    for (const auto &run : set.runs) {
        for (const ThermalCell &cell : run->curve.cells()) {
            sum += cell.sumTdeDps;
            count += cell.count;
        }
    }
    return {count > 0.0 ? Eigen::Vector3d(sum / count) : Eigen::Vector3d::Zero()};
}

} // namespace driftbench
