// Small campaigns made in the test itself, from a curve that the test chooses: faster and plainer than the
// simulator, for tests that need to know the truth exactly.
#pragma once

#include "engine/base/random.h"
#include "engine/features/run_features.h"

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>

namespace driftbench::test {

using TrueCurve = std::function<Eigen::Vector3d(double deltaT)>;

struct SimpleRunOptions
{
    double lowestDeltaT = 0.0;
    double highestDeltaT = 60.0;
    int samples = 6000;
    double sampleRateHz = 10.0;
    double noiseDps = 0.05;
    Eigen::Vector3d offsetDps = Eigen::Vector3d::Zero();
    Eigen::Vector3d scale = Eigen::Vector3d::Ones(); // run-to-run spread: multiplies the curve
};

// One sweep from the lowest to the highest dT at a constant rate.
inline std::shared_ptr<const RunFeatures> simpleRun(const std::string &name, const TrueCurve &curve,
                                                    const SimpleRunOptions &options, Random random)
{
    auto run = std::make_shared<RunFeatures>();
    run->name = name;
    run->timeS.resize(options.samples);
    run->deltaT.resize(options.samples);
    run->tdeDps.resize(options.samples, 3);
    run->usableForTraining.assign(static_cast<std::size_t>(options.samples), 1);
    for (Eigen::Index i = 0; i < options.samples; ++i) {
        const double part = static_cast<double>(i) / (options.samples - 1);
        const double deltaT = options.lowestDeltaT + part * (options.highestDeltaT - options.lowestDeltaT);
        run->timeS[i] = static_cast<double>(i) / options.sampleRateHz;
        run->deltaT[i] = deltaT;
        const Eigen::Vector3d truth = options.scale.cwiseProduct(curve(deltaT)) + options.offsetDps;
        for (int axis = 0; axis < 3; ++axis)
            run->tdeDps(i, axis) = truth[axis] + options.noiseDps * random.normal();
    }
    run->curve.add(run->deltaT, run->tdeDps);
    return run;
}

// Runs run1, run2, ... with the same options, a multiplicative spread and independent noise.
inline TrainingSet simpleCampaign(int runs, const TrueCurve &curve, const SimpleRunOptions &options = {},
                                  double spread = 0.0, std::uint64_t seed = 1)
{
    TrainingSet set;
    set.referenceTemperatureC = -20.0;
    Random random(seed);
    for (int i = 0; i < runs; ++i) {
        SimpleRunOptions mine = options;
        for (int axis = 0; axis < 3; ++axis)
            mine.scale[axis] += spread * random.normal();
        set.runs.push_back(simpleRun("run" + std::to_string(i + 1), curve, mine,
                                     random.fork(static_cast<std::uint64_t>(i))));
    }
    return set;
}

} // namespace driftbench::test
