#include "widgets/views/model_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

static constexpr int kEvenPoints = 700;
static constexpr int kRootPoints = 200;

Eigen::VectorXd curveGrid(double lowestDeltaT, double highestDeltaT)
{
    std::vector<double> points;
    for (int i = 0; i <= kEvenPoints; ++i)
        points.push_back(lowestDeltaT + (highestDeltaT - lowestDeltaT) * i / kEvenPoints);
    const double lowestRoot = signedRoot(lowestDeltaT);
    const double highestRoot = signedRoot(highestDeltaT);
    for (int i = 1; i < kRootPoints; ++i) {
        const double root = lowestRoot + (highestRoot - lowestRoot) * i / kRootPoints;
        points.push_back(root * std::abs(root));
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return Eigen::Map<const Eigen::VectorXd>(points.data(), static_cast<Eigen::Index>(points.size()));
}

ModelCurve modelCurve(const TrainedModel &model)
{
    ModelCurve curve;
    curve.name = model.name;
    curve.deltaT = curveGrid(model.lowestTemperatureC - model.referenceTemperatureC,
                             model.highestTemperatureC - model.referenceTemperatureC);
    curve.tdeDps = predictAtDeltaT(model.model, curve.deltaT);
    return curve;
}

double interpolated(const ModelCurve &curve, int axis, double deltaT)
{
    const Eigen::Index count = curve.deltaT.size();
    if (count == 0 || std::isnan(deltaT))
        return std::numeric_limits<double>::quiet_NaN();
    const double *const begin = curve.deltaT.data();
    const Eigen::Index upper = std::upper_bound(begin, begin + count, deltaT) - begin;
    if (upper == 0)
        return curve.tdeDps(0, axis);
    if (upper == count)
        return curve.tdeDps(count - 1, axis);
    const double share = (deltaT - curve.deltaT[upper - 1]) / (curve.deltaT[upper] - curve.deltaT[upper - 1]);
    return (1.0 - share) * curve.tdeDps(upper - 1, axis) + share * curve.tdeDps(upper, axis);
}

} // namespace driftbench
