// All models judged on runs that they were not trained on.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/evaluation/allan.h"
#include "engine/evaluation/hysteresis.h"
#include "engine/evaluation/repeatability.h"
#include "engine/evaluation/scoring.h"
#include "engine/features/run_features.h"
#include "engine/models/model_recipe.h"
#include "engine/models/trained_model.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct ComparisonOptions
{
    std::vector<std::string> models = defaultModelNames();
    std::vector<std::string> holdOut{}; // names of runs; empty: leave one run out
    Judging judging = Judging::Absolute;
    std::uint64_t seed = 1;
    int threads = 0;
    RbfOptions rbf{}; // as in RecipeOptions
    BpOptions bp{};
    // A stop while models are trained gives the comparison of those that are finished, if there are any.
    bool keepFinished = false;
    // A model is trained on every fold; the seconds that its jobs took together. Called from any thread, one
    // call at a time.
    std::function<void(const std::string &model, double seconds)> onModelTrained{};
};

// What was trained without certain samples, and on what it is judged.
struct Fold
{
    std::string name;                           // of the held-out run, or "run, block k" of a single run
    std::shared_ptr<const RunFeatures> heldOut; // what it is judged on
    std::vector<std::string> trainedOn;
    TrainingSet training;
    std::vector<FittedModel> models; // in the order of ComparisonOptions::models
};

struct AxisVerdict
{
    Verdict verdict = Verdict::NotRepeatable;
    // Recommended: which wins on held-out runs, the simpler within a standard error; "constant" where the
    // verdict is neither yes nor with care.
    std::string model;
    double gain = 0.0; // G of the recommended or, where that is the constant, of the best other model
    double gainModelFree = 0.0; // G*; NaN where no two runs (or sweeps of a single run) share a temperature
    std::string reason;         // in words, with the figures
};

struct Comparison
{
    ComparisonOptions options;
    std::vector<ComparisonRow> rows; // by run, then axis, then model
    std::vector<Fold> folds;
    std::vector<TrainedModel> models; // trained on all runs that were not explicitly held out; "auto" last
    std::optional<RbfSelection> rbfSelection; // of "rbf" on all of them
    std::array<AxisVerdict, 3> verdicts;
    Hysteresis hysteresis;
    Repeatability repeatability;
    bool simulated = false;
    std::vector<std::string> unfinished; // models that a stop left out
    std::vector<std::string> warnings;
};

// What of the campaign goes into the models besides its features.
struct CampaignFacts
{
    SensorIdentity sensor{};
    bool simulated = false;
};

// The hook's fraction when all models are trained; the rest is judging.
inline constexpr double kComparisonTrainingShare = 0.85;

Result<Comparison> compareModels(const TrainingSet &set, const CampaignFacts &facts,
                                 const ComparisonOptions &options = {}, const ProgressHook &hook = {});

// The same with given recipes, whose names take the place of options.models. The hook is called from the
// calling thread only. Errc: NothingUsable, InvalidOption, Cancelled and what the recipes' training reports.
Result<Comparison> compareRecipes(const std::vector<ModelRecipe> &recipes, const TrainingSet &set,
                                  const CampaignFacts &facts, const ComparisonOptions &options = {},
                                  const ProgressHook &hook = {});

} // namespace driftbench
