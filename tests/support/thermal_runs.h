// Runs made from a formula, small enough to judge hundreds of them in a test.
#pragma once

#include "engine/base/random.h"
#include "engine/features/run_features.h"

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

namespace driftbench::test {

using TdeOfDeltaT = std::function<Eigen::Vector3d(double deltaT)>;

struct RunPlan
{
    int samples = 2000;
    double intervalS = 0.5;
    double fromDeltaT = 0.0;
    double toDeltaT = 80.0;
    double noiseDps = 0.1;
};

inline std::shared_ptr<RunFeatures> emptyRun(const std::string &name, int samples)
{
    auto run = std::make_shared<RunFeatures>();
    run->name = name;
    run->timeS.resize(samples);
    run->deltaT.resize(samples);
    run->tdeDps.resize(samples, 3);
    run->usableForTraining.assign(static_cast<std::size_t>(samples), 1);
    return run;
}

// A straight ramp of temperature.
inline std::shared_ptr<RunFeatures> makeRun(const std::string &name, const RunPlan &plan,
                                            const TdeOfDeltaT &tde, Random &random)
{
    auto run = emptyRun(name, plan.samples);
    for (int i = 0; i < plan.samples; ++i) {
        const double along = (i + 0.5) / plan.samples;
        run->timeS[i] = i * plan.intervalS;
        run->deltaT[i] = plan.fromDeltaT + along * (plan.toDeltaT - plan.fromDeltaT);
        const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
        run->tdeDps.row(i) = (tde(run->deltaT[i]) + plan.noiseDps * noise).transpose();
    }
    run->curve.add(run->deltaT, run->tdeDps);
    return run;
}

// A smooth curve of some tenths of a dps that each run bends a little in its own way: a random combination
// of slow cosines, so that no run can be predicted exactly from the others.
inline TdeOfDeltaT bentCurve(Random &random, double spreadDps)
{
    Eigen::Matrix<double, 4, 3> bend;
    for (int k = 0; k < 4; ++k) {
        for (int axis = 0; axis < 3; ++axis)
            bend(k, axis) = spreadDps * random.normal();
    }
    return [bend](double deltaT) {
        const double u = deltaT / 80.0;
        Eigen::Vector3d tde(1.5 * u - 2.0 * u * u, 0.8 * std::sin(4.0 * u), 0.5 * std::tanh(6.0 * (u - 0.5)));
        for (int k = 0; k < 4; ++k)
            tde += bend.row(k).transpose() * std::cos(std::numbers::pi * k * u);
        return tde;
    };
}

} // namespace driftbench::test
