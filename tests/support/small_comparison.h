// A comparison of four models on three small runs whose curve is known, and rows by hand.
#pragma once

#include "engine/evaluation/comparison.h"
#include "support/simple_campaign.h"

#include <QtGlobal>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace driftbench::test {

inline Eigen::Vector3d knownCurve(double d)
{
    return {0.02 * d + 0.3 * std::sin(d / 6.0), 0.01 * d, 0.2 * std::tanh((d - 30.0) / 5.0)};
}

inline ComparisonOptions fourModels()
{
    ComparisonOptions options;
    options.models = {"constant", "linear", "cubic", "rbf"};
    return options;
}

struct SmallComparison
{
    TrainingSet set;
    Comparison comparison;
};

inline SmallComparison smallComparison()
{
    SimpleRunOptions run;
    run.samples = 2500;
    run.noiseDps = 0.03;
    SmallComparison small;
    small.set = simpleCampaign(3, knownCurve, run, 0.01, 7);
    auto compared = compareModels(small.set, {{"L3GD20H", "T1"}, true}, fourModels());
    if (!compared)
        qFatal("%s", compared.error().message.c_str());
    small.comparison = std::move(*compared);
    return small;
}

inline const ComparisonRow &rowOf(const Comparison &comparison, const std::string &run, int axis,
                                  const std::string &model)
{
    for (const ComparisonRow &row : comparison.rows) {
        if (row.run == run && row.axis == axis && row.model == model)
            return row;
    }
    qFatal("no such row");
}

// The model of a fold as it would stand in a file.
inline TrainedModel heldOut(const Comparison &comparison, const Fold &fold, std::size_t model,
                            const TrainingSet &set)
{
    TrainedModel trained = comparison.models[model];
    trained.model = fold.models[model].model;
    trained.trainedOn = fold.trainedOn;
    const DeltaTRange range = trainedRange(fold.training);
    trained.lowestTemperatureC = set.referenceTemperatureC + range.lowest;
    trained.highestTemperatureC = set.referenceTemperatureC + range.highest;
    return trained;
}

// One run and axis a row, by hand.
inline std::vector<ComparisonRow> rowsBy(const std::vector<std::pair<double, double>> &leftAndConstant)
{
    std::vector<ComparisonRow> rows;
    for (std::size_t i = 0; i < leftAndConstant.size(); ++i) {
        ComparisonRow row;
        row.run = "run" + std::to_string(i + 1);
        row.noiseFloor = 1e-4;
        row.model = "rbf";
        row.msdAfter = leftAndConstant[i].first * leftAndConstant[i].first;
        rows.push_back(row);
        row.model = "constant";
        row.msdAfter = leftAndConstant[i].second * leftAndConstant[i].second;
        rows.push_back(row);
    }
    return rows;
}

} // namespace driftbench::test
