// A recipe is a model's name with the way to train it: what a comparison needs to treat all models alike.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/features/run_features.h"
#include "engine/models/bp_network.h"
#include "engine/models/rbf_trainer.h"
#include "engine/models/trained_model.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct FittedModel
{
    AnyModel model;
    std::map<std::string, double> summary; // figures of the training, into the model file
    std::optional<RbfFit> rbf;             // of the RBF recipes: selection, centres, offsets of the runs
    std::vector<std::string> warnings;
};

struct ModelRecipe
{
    std::string name;
    int complexity = 0; // the simpler of two models that do equally well is recommended
    std::function<Result<FittedModel>(const TrainingSet &, const ProgressHook &)> fit;
};

struct RecipeOptions
{
    std::uint64_t seed = 1;
    int threads = 0;
    // Of "rbf" and "rbf-paper" (their preset follows from the name) and of "bpnn"; seed and threads are those
    // above.
    RbfOptions rbf{};
    BpOptions bp{};
};

// "constant", "linear", "cubic" (as PX4), "cubic-ardupilot", "bpnn", "rbf-paper", "rbf".
const std::vector<std::string> &knownModelNames();
// What `fit` trains unless told otherwise: all but "cubic-ardupilot".
const std::vector<std::string> &defaultModelNames();

// Errc::InvalidOption names the unknown model and lists the known ones. Recipes share what they can (the RBF
// paths of one campaign): make them once for each campaign.
Result<std::vector<ModelRecipe>> modelRecipes(const std::vector<std::string> &names,
                                              const RecipeOptions &options);

} // namespace driftbench
