#include "engine/evaluation/dynamic_experiment.h"

#include "engine/base/parallel_for.h"
#include "engine/evaluation/noise_floor.h"
#include "engine/features/dynamic_quantities.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <limits>

namespace driftbench {

namespace {

using Terms = Eigen::Matrix<double, Eigen::Dynamic, 2>; // dT/dt, lag
using Weights = Eigen::Matrix<double, 2, 3>;            // row: term, column: axis

struct RunResidual
{
    Terms terms;
    Eigen::MatrixX3d residualDps;
    Eigen::Vector3d withinDps2; // of the samples of a row, where it is a mean
};

// Sums that merge over runs: the least-squares solution needs no more.
struct NormalSums
{
    Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
    Weights product = Weights::Zero();

    void add(const RunResidual &run)
    {
        square += run.terms.transpose() * run.terms;
        product += run.terms.transpose() * run.residualDps;
    }
    Weights solve() const { return square.fullPivLu().solve(product); }
};

RunResidual residualOf(const RunFeatures &run, const AnyModel &model, DeltaTRange range,
                       const DynamicExperimentOptions &options, double lagS)
{
    RunResidual result;
    result.residualDps = run.tdeDps - predictHeld(model, run.deltaT, range);
    result.withinDps2 = run.meanSquare(Eigen::MatrixX3d::Zero(run.tdeDps.rows(), 3));
    result.terms.resize(run.deltaT.size(), 2);
    result.terms.col(0) = temperatureRate(run.timeS, run.deltaT, options.rateWindowS);
    result.terms.col(1) = temperatureLag(run.timeS, run.deltaT, lagS);
    return result;
}

double leftWith(const RunResidual &run, const Weights &weights, int axis)
{
    return run.withinDps2[axis] + (run.residualDps.col(axis) - run.terms * weights.col(axis)).squaredNorm() /
                                      static_cast<double>(run.terms.rows());
}

// What is left on each axis, summed over training runs that take no part in the fit of the weights.
Eigen::Vector3d leftOnRunsLeftOut(const std::vector<RunResidual> &training)
{
    Eigen::Vector3d left = Eigen::Vector3d::Zero();
    for (std::size_t out = 0; out < training.size(); ++out) {
        NormalSums others;
        for (std::size_t run = 0; run < training.size(); ++run) {
            if (run != out)
                others.add(training[run]);
        }
        const Weights weights = others.solve();
        for (int axis = 0; axis < 3; ++axis)
            left[axis] += leftWith(training[out], weights, axis);
    }
    return left;
}

std::array<DynamicOutcome, 3> tryFold(const Fold &fold, const AnyModel &model,
                                      const DynamicExperimentOptions &options)
{
    const DeltaTRange range = trainedRange(fold.training);
    const Eigen::Vector3d floor = noiseFloor(*fold.heldOut);
    std::array<DynamicOutcome, 3> outcomes;
    Eigen::Vector3d least = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    for (const double lagS : options.lagTimeConstantsS) {
        std::vector<RunResidual> training;
        NormalSums all;
        for (const auto &run : fold.training.runs) {
            training.push_back(residualOf(*run, model, range, options, lagS));
            all.add(training.back());
        }
        const Eigen::Vector3d left = leftOnRunsLeftOut(training);
        const Weights weights = all.solve();
        const RunResidual heldOut = residualOf(*fold.heldOut, model, range, options, lagS);
        for (int axis = 0; axis < 3; ++axis) {
            if (left[axis] >= least[axis])
                continue;
            least[axis] = left[axis];
            outcomes[static_cast<std::size_t>(axis)] = {fold.name,
                                                        axis,
                                                        leftWith(heldOut, Weights::Zero(), axis),
                                                        leftWith(heldOut, weights, axis),
                                                        floor[axis],
                                                        lagS,
                                                        weights(0, axis),
                                                        weights(1, axis)};
        }
    }
    return outcomes;
}

} // namespace

Result<std::vector<DynamicOutcome>> dynamicExperiment(const Comparison &comparison,
                                                      const DynamicExperimentOptions &options)
{
    const auto &names = comparison.options.models;
    const auto place = std::find(names.begin(), names.end(), options.model);
    if (place == names.end()) {
        return Error{Errc::InvalidOption, "The experiment with dynamic quantities needs the model " +
                                              options.model + "; train it as well."};
    }
    const auto index = static_cast<std::size_t>(place - names.begin());
    for (const Fold &fold : comparison.folds) {
        if (fold.training.runs.size() < 2) {
            return Error{Errc::InvalidOption,
                         "The experiment with dynamic quantities needs three runs or more. "
                         "Record more runs, or leave it out."};
        }
    }
    std::vector<std::array<DynamicOutcome, 3>> outcomes(comparison.folds.size());
    parallelFor(outcomes.size(), comparison.options.threads, [&](std::size_t i) {
        outcomes[i] = tryFold(comparison.folds[i], comparison.folds[i].models[index].model, options);
    });
    std::vector<DynamicOutcome> all;
    for (const auto &fold : outcomes)
        all.insert(all.end(), fold.begin(), fold.end());
    return all;
}

} // namespace driftbench
