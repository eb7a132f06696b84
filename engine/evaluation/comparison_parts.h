// The steps of a comparison after the training: scores, verdicts, trained models.
#pragma once

#include "engine/evaluation/comparison.h"
#include "engine/evaluation/splits.h"
#include "engine/evaluation/verdict.h"

#include <vector>

namespace driftbench {

// [set][recipe]
using ModelsBySet = std::vector<std::vector<FittedModel>>;

struct Scores
{
    std::vector<JudgedRun> runs;                 // by split
    std::vector<ModelScore> constants;           // by split: the yardstick, trained as the models were
    std::vector<std::vector<ModelScore>> models; // [split][recipe]
};

// On all cores; also fills the comparison's hysteresis and repeatability.
Scores scoreAll(Comparison &comparison, const TrainingSet &set, const Splits &splits,
                const ModelsBySet &models);

// Model `recipe` on one axis.
AxisEvidence evidenceFor(const Scores &scores, const Splits &splits, const Repeatability &repeatability,
                         std::size_t recipe, int axis);

// The models of splits.everything with verdicts, reasons and, where runs were left out in turn, the band.
std::vector<TrainedModel> assembleModels(const Comparison &comparison,
                                         const std::vector<ModelRecipe> &recipes, const CampaignFacts &facts,
                                         const Splits &splits, const ModelsBySet &models,
                                         const Scores &scores);

// Fills comparison.verdicts and appends "auto" to comparison.models, which holds what assembleModels made.
void recommendModels(Comparison &comparison, const std::vector<ModelRecipe> &recipes,
                     const CampaignFacts &facts, const Splits &splits, const Scores &scores);

} // namespace driftbench
