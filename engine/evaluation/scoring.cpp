#include "engine/evaluation/scoring.h"

#include "engine/base/axes.h"
#include "engine/evaluation/allan.h"
#include "engine/evaluation/tabulated_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

namespace {

constexpr double kStartS = 60.0;
constexpr Eigen::Index kFewestStartSamples = 30;
// Enough to find the lowest point of the deviation within a few percent at a tenth of the cost of a curve.
constexpr int kAllanPointsPerDecade = 3;

Eigen::Index samplesOfStart(const RunFeatures &run)
{
    const Eigen::Index samples = run.timeS.size();
    Eigen::Index start = std::min(kFewestStartSamples, samples);
    while (start < samples && run.timeS[start] - run.timeS[0] < kStartS)
        ++start;
    return start;
}

} // namespace

std::string_view judgingName(Judging judging)
{
    return judging == Judging::Anchored ? "anchored" : "absolute";
}

std::optional<Judging> judgingFromName(std::string_view name)
{
    for (const Judging judging : {Judging::Absolute, Judging::Anchored}) {
        if (name == judgingName(judging))
            return judging;
    }
    return std::nullopt;
}

Eigen::Vector3d JudgedRun::anchorNoise() const
{
    if (startSamples == 0)
        return Eigen::Vector3d::Zero();
    double samples = 0.0;
    for (Eigen::Index row = 0; row < startSamples; ++row)
        samples += anchor->points.countAt(row);
    return floor / samples;
}

JudgedRun prepareForJudging(std::shared_ptr<const RunFeatures> heldOut,
                            std::shared_ptr<const RunFeatures> anchor, Judging judging)
{
    JudgedRun run;
    run.judging = judging;
    run.windows = averagingWindows(heldOut->timeS);
    run.floor = noiseFloor(*heldOut);
    if (judging == Judging::Anchored) {
        run.startSamples = samplesOfStart(*anchor);
        const Eigen::RowVector3d startBias = anchor->tdeDps.topRows(run.startSamples).colwise().mean();
        run.msdBefore = heldOut->meanSquare(heldOut->tdeDps.rowwise() - startBias);
    } else {
        run.msdBefore = heldOut->meanSquare(heldOut->tdeDps);
    }
    run.heldOut = std::move(heldOut);
    run.anchor = std::move(anchor);
    return run;
}

DeltaTRange trainedRange(const TrainingSet &set)
{
    DeltaTRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const auto &run : set.runs) {
        range.lowest = std::min(range.lowest, run->curve.lowestDeltaT());
        range.highest = std::max(range.highest, run->curve.highestDeltaT());
    }
    return range;
}

Eigen::MatrixX3d predictHeld(const AnyModel &model, const Eigen::VectorXd &deltaT, DeltaTRange range)
{
    return predictThroughTable(model, deltaT.cwiseMax(range.lowest).cwiseMin(range.highest));
}

ModelScore scoreModel(const JudgedRun &run, const AnyModel &model, DeltaTRange range)
{
    Eigen::MatrixX3d residual = run.heldOut->tdeDps - predictHeld(model, run.heldOut->deltaT, range);
    if (run.startSamples > 0) {
        const Eigen::MatrixX3d start = run.anchor->tdeDps.topRows(run.startSamples) -
                                       predictHeld(model, run.anchor->deltaT.head(run.startSamples), range);
        residual.rowwise() -= Eigen::RowVector3d(start.colwise().mean());
    }
    ModelScore score;
    score.msd = run.heldOut->meanSquare(residual);
    score.rms10sDps = rmsAfterAveraging(run.windows, residual);
    score.biasInstabilityDps =
        allanDeviation(run.heldOut->timeS, residual, kAllanPointsPerDecade).biasInstabilityDps;
    return score;
}

std::vector<ComparisonRow> rowsOf(const std::string &name, const JudgedRun &run, const std::string &model,
                                  const ModelScore &score, const std::vector<std::string> &trainedOn)
{
    std::vector<ComparisonRow> rows;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        ComparisonRow row;
        row.run = name;
        row.axis = axis;
        row.model = model;
        row.msdBefore = run.msdBefore[axis];
        row.msdAfter = score.msd[axis];
        row.q = row.msdAfter / row.msdBefore;
        row.noiseFloor = run.floor[axis];
        row.excessOverFloor = (row.msdAfter - row.noiseFloor) / row.noiseFloor;
        row.rms10sDps = score.rms10sDps[axis];
        row.rmsDps = std::sqrt(row.msdAfter);
        row.biasInstabilityDps = score.biasInstabilityDps[axis];
        row.samples = static_cast<Eigen::Index>(run.heldOut->samples());
        row.trainedOn = trainedOn;
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<ComparisonRow> evaluateModel(const TrainedModel &model, std::shared_ptr<const RunFeatures> run,
                                         Judging judging)
{
    const JudgedRun judged = prepareForJudging(run, run, judging);
    const DeltaTRange range{model.lowestTemperatureC - model.referenceTemperatureC,
                            model.highestTemperatureC - model.referenceTemperatureC};
    return rowsOf(run->name, judged, model.name, scoreModel(judged, model.model, range), model.trainedOn);
}

} // namespace driftbench
