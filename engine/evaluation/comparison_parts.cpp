#include "engine/evaluation/comparison_parts.h"

#include "engine/base/axes.h"
#include "engine/base/parallel_for.h"
#include "engine/evaluation/reason.h"
#include "engine/evaluation/recommendation.h"
#include "engine/evaluation/uncertainty_band.h"
#include "engine/models/constant_model.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr std::string_view kConstantName = "constant";

TrainedModel describedModel(const CampaignFacts &facts, const ComparisonOptions &options,
                            const Splits &splits)
{
    const TrainingSet &training = splits.trainings[splits.everything];
    const DeltaTRange range = trainedRange(training);
    TrainedModel model;
    model.referenceTemperatureC = training.referenceTemperatureC;
    model.lowestTemperatureC = range.lowest + training.referenceTemperatureC;
    model.highestTemperatureC = range.highest + training.referenceTemperatureC;
    model.sensor = facts.sensor;
    model.simulated = facts.simulated;
    model.trainedOn = splits.trainedOn[splits.everything];
    model.seed = options.seed;
    model.judging = judgingName(options.judging);
    return model;
}

double heldOutRms(const AxisEvidence &evidence)
{
    double msd = 0.0;
    for (const HeldOutError &run : evidence.heldOut)
        msd += run.modelMsd / static_cast<double>(evidence.heldOut.size());
    return std::sqrt(msd);
}

void addJudgement(TrainedModel &model, const Comparison &comparison, const AxisEvidence &evidence, int axis)
{
    const auto slot = static_cast<std::size_t>(axis);
    const std::string axisName(kAxisNames[slot]);
    model.summary["held_out_rms_" + axisName + "_dps"] = heldOutRms(evidence);
    if (std::holds_alternative<ConstantModel>(model.model))
        return;
    const Judgement judgement = judge(evidence);
    model.summary["held_out_gain_" + axisName] = judgement.gain;
    model.verdicts[slot] = judgement.verdict;
    model.reasons[slot] = reasonFor({axis, model.name, evidence, judgement, comparison.hysteresis,
                                     comparison.repeatability, comparison.options.judging});
}

void addBand(TrainedModel &model, const Splits &splits, const ModelsBySet &models, std::size_t recipe)
{
    if (!splits.leftOutRuns)
        return;
    std::vector<AnyModel> heldOutModels;
    for (const Split &split : splits.splits)
        heldOutModels.push_back(models[split.training][recipe].model);
    model.band = uncertaintyBand(splits.trainings[splits.everything], heldOutModels);
}

// Candidates in the order of comparison.models; the constant is none.
struct AxisCandidates
{
    std::vector<Candidate> candidates;
    std::vector<std::size_t> models;
};

AxisCandidates candidatesFor(const Comparison &comparison, const std::vector<ModelRecipe> &recipes,
                             const Splits &splits, const Scores &scores, int axis)
{
    AxisCandidates result;
    for (std::size_t m = 0; m < recipes.size(); ++m) {
        if (std::holds_alternative<ConstantModel>(comparison.models[m].model))
            continue;
        const AxisEvidence evidence = evidenceFor(scores, splits, comparison.repeatability, m, axis);
        Candidate candidate{recipes[m].name, recipes[m].complexity, judge(evidence), {}};
        for (const HeldOutError &run : evidence.heldOut)
            candidate.loss.push_back(run.modelMsd / run.floor);
        result.candidates.push_back(std::move(candidate));
        result.models.push_back(m);
    }
    return result;
}

TrainedModel constantOf(const Comparison &comparison, const CampaignFacts &facts, const Splits &splits)
{
    for (const TrainedModel &model : comparison.models) {
        if (std::holds_alternative<ConstantModel>(model.model))
            return model;
    }
    TrainedModel model = describedModel(facts, comparison.options, splits);
    model.name = kConstantName;
    model.model = fitConstant(splits.trainings[splits.everything]);
    return model;
}

std::optional<UncertaintyBand> bandPerAxis(const PerAxisModel &model)
{
    std::optional<UncertaintyBand> band;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const auto &part = model.axes[static_cast<std::size_t>(axis)]->band;
        if (!part)
            return std::nullopt;
        if (!band)
            band = part;
        band->curveHalfWidthDps.col(axis) = part->curveHalfWidthDps.col(axis);
        band->sampleHalfWidthDps.col(axis) = part->sampleHalfWidthDps.col(axis);
    }
    return band;
}

} // namespace

Scores scoreAll(Comparison &comparison, const TrainingSet &set, const Splits &splits,
                const ModelsBySet &models)
{
    const std::size_t count = splits.splits.size();
    const int threads = comparison.options.threads;
    Scores scores;
    scores.runs.resize(count);
    scores.constants.resize(count);
    scores.models.assign(count, std::vector<ModelScore>(models.front().size()));
    parallelFor(count + 2, threads, [&](std::size_t job) {
        if (job == count)
            comparison.hysteresis = analyseHysteresis(set);
        else if (job == count + 1)
            comparison.repeatability = analyseRepeatability(set);
        else
            scores.runs[job] = prepareForJudging(splits.splits[job].heldOut, splits.splits[job].anchor,
                                                 comparison.options.judging);
    });
    const std::size_t perSplit = models.front().size() + 1;
    parallelFor(count * perSplit, threads, [&](std::size_t job) {
        const std::size_t split = job / perSplit;
        const std::size_t model = job % perSplit;
        const std::size_t trained = splits.splits[split].training;
        const TrainingSet &training = splits.trainings[trained];
        const DeltaTRange range = trainedRange(training);
        if (model + 1 == perSplit)
            scores.constants[split] = scoreModel(scores.runs[split], fitConstant(training), range);
        else
            scores.models[split][model] = scoreModel(scores.runs[split], models[trained][model].model, range);
    });
    return scores;
}

AxisEvidence evidenceFor(const Scores &scores, const Splits &splits, const Repeatability &repeatability,
                         std::size_t recipe, int axis)
{
    AxisEvidence evidence;
    evidence.inRunVariance = repeatability.inRunVariance[axis];
    evidence.singleRun = splits.blocks;
    for (std::size_t split = 0; split < scores.runs.size(); ++split) {
        HeldOutError error;
        error.run = splits.splits[split].name;
        error.constantMsd = scores.constants[split].msd[axis];
        error.modelMsd = scores.models[split][recipe].msd[axis];
        error.floor = scores.runs[split].floor[axis];
        error.anchorNoise = scores.runs[split].anchorNoise()[axis];
        evidence.heldOut.push_back(std::move(error));
    }
    return evidence;
}

std::vector<TrainedModel> assembleModels(const Comparison &comparison,
                                         const std::vector<ModelRecipe> &recipes, const CampaignFacts &facts,
                                         const Splits &splits, const ModelsBySet &models,
                                         const Scores &scores)
{
    std::vector<TrainedModel> assembled(recipes.size());
    parallelFor(recipes.size(), comparison.options.threads, [&](std::size_t m) {
        TrainedModel model = describedModel(facts, comparison.options, splits);
        model.name = recipes[m].name;
        model.model = models[splits.everything][m].model;
        model.summary = models[splits.everything][m].summary;
        for (int axis = 0; axis < kAxisCount; ++axis)
            addJudgement(model, comparison, evidenceFor(scores, splits, comparison.repeatability, m, axis),
                         axis);
        addBand(model, splits, models, m);
        assembled[m] = std::move(model);
    });
    return assembled;
}

void recommendModels(Comparison &comparison, const std::vector<ModelRecipe> &recipes,
                     const CampaignFacts &facts, const Splits &splits, const Scores &scores)
{
    const auto constant = std::make_shared<const TrainedModel>(constantOf(comparison, facts, splits));
    TrainedModel chosen = describedModel(facts, comparison.options, splits);
    chosen.name = "auto";
    PerAxisModel perAxis;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const auto slot = static_cast<std::size_t>(axis);
        AxisVerdict &verdict = comparison.verdicts[slot];
        verdict.model = kConstantName;
        verdict.gainModelFree = comparison.repeatability.gainModelFree[axis];
        verdict.reason = reasonWithoutModel(axis);
        perAxis.axes[slot] = constant;
        const AxisCandidates axisCandidates = candidatesFor(comparison, recipes, splits, scores, axis);
        if (const auto best = recommended(axisCandidates.candidates)) {
            const TrainedModel &model = comparison.models[axisCandidates.models[*best]];
            const Judgement &judgement = axisCandidates.candidates[*best].judgement;
            verdict.verdict = judgement.verdict;
            verdict.gain = judgement.gain;
            verdict.reason = model.reasons[slot];
            if (judgement.verdict == Verdict::Yes || judgement.verdict == Verdict::WithCare) {
                verdict.model = model.name;
                perAxis.axes[slot] = std::make_shared<const TrainedModel>(model);
            }
        }
        chosen.verdicts[slot] = verdict.verdict;
        chosen.reasons[slot] = verdict.reason;
    }
    chosen.band = bandPerAxis(perAxis);
    chosen.model = std::move(perAxis);
    comparison.models.push_back(std::move(chosen));
}

} // namespace driftbench
