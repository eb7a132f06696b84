// Small training sets for tests of models.
#pragma once

#include "engine/features/run_features.h"

#include <Eigen/Core>
#include <functional>
#include <string>

namespace driftbench::test {

// A run with all samples usable, as the features room makes it.
inline std::shared_ptr<const RunFeatures> makeRun(const std::string &name, const Eigen::VectorXd &timeS,
                                                  const Eigen::VectorXd &deltaT,
                                                  const Eigen::MatrixX3d &tdeDps)
{
    auto run = std::make_shared<RunFeatures>();
    run->name = name;
    run->timeS = timeS;
    run->deltaT = deltaT;
    run->tdeDps = tdeDps;
    run->usableForTraining.assign(static_cast<std::size_t>(deltaT.size()), 1);
    run->curve.add(deltaT, tdeDps);
    return run;
}

// count samples at 10 Hz rising evenly from low to high.
inline std::shared_ptr<const RunFeatures>
makeRamp(const std::string &name, Eigen::Index count, double low, double high,
         const std::function<Eigen::Vector3d(double deltaT)> &tdeDps)
{
    const Eigen::VectorXd deltaT = Eigen::VectorXd::LinSpaced(count, low, high);
    Eigen::MatrixX3d tde(count, 3);
    for (Eigen::Index i = 0; i < count; ++i)
        tde.row(i) = tdeDps(deltaT[i]).transpose();
    return makeRun(name, Eigen::VectorXd::LinSpaced(count, 0.0, 0.1 * static_cast<double>(count - 1)), deltaT,
                   tde);
}

} // namespace driftbench::test
