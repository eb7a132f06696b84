#include "engine/evaluation/sweeps.h"

#include <algorithm>

namespace driftbench {

std::vector<Sweep> sweepsOf(const RunFeatures &run)
{
    const Eigen::VectorXd &deltaT = run.deltaT;
    std::vector<Sweep> sweeps;
    if (deltaT.size() == 0)
        return sweeps;
    const double turn = std::max(2.0, 0.1 * (deltaT.maxCoeff() - deltaT.minCoeff()));
    Eigen::Index start = 0;
    Eigen::Index lowest = 0;
    Eigen::Index highest = 0;
    int direction = 0; // not known before the first move of `turn`
    const auto turnAt = [&](Eigen::Index extreme, int newDirection) {
        if (direction != 0) {
            sweeps.push_back({start, extreme, direction > 0});
            start = extreme;
        }
        direction = newDirection;
    };
    for (Eigen::Index i = 1; i < deltaT.size(); ++i) {
        if (deltaT[i] > deltaT[highest])
            highest = i;
        if (deltaT[i] < deltaT[lowest])
            lowest = i;
        if (direction <= 0 && deltaT[i] - deltaT[lowest] > turn) {
            turnAt(lowest, 1);
            highest = i;
        } else if (direction >= 0 && deltaT[highest] - deltaT[i] > turn) {
            turnAt(highest, -1);
            lowest = i;
        }
    }
    const bool heating = direction != 0 ? direction > 0 : deltaT[deltaT.size() - 1] >= deltaT[0];
    sweeps.push_back({start, deltaT.size(), heating});
    return sweeps;
}

ThermalCurve curveOf(const RunFeatures &run, const Sweep &sweep)
{
    if (sweep.first == 0 && sweep.last == run.deltaT.size())
        return run.curve;
    ThermalCurve curve;
    for (Eigen::Index i = sweep.first; i < sweep.last; ++i) {
        if (run.usableForTraining[static_cast<std::size_t>(i)] != 0)
            run.addTo(curve, i);
    }
    return curve;
}

} // namespace driftbench
