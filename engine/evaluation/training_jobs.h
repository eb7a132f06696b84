// Every recipe on every training set, on all cores.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/models/model_recipe.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace driftbench {

struct TrainedRecipes
{
    std::vector<ModelRecipe> recipes; // as many as were trained on every set, in their order
    // One vector a training set, in it one model a recipe.
    std::vector<std::vector<FittedModel>> models;
    std::vector<std::string> unfinished; // names of those that a stop left out
};

// Recipes are trained one after the other, each on all sets, so that a stop leaves some of them whole.
// The hook is called from the calling thread only; where it says stop, what is finished is returned. After a
// recipe is trained on every set, onTrained is called with its place and the seconds that its jobs took
// together, from any of the threads, one call at a time.
// Of several failures the first in the order of sets and recipes is reported. The models do not depend on
// threads (0: one per core).
using OnRecipeTrained = std::function<void(std::size_t recipe, double seconds)>;
Result<TrainedRecipes> trainAll(const std::vector<ModelRecipe> &recipes, const std::vector<TrainingSet> &sets,
                                int threads, const ProgressHook &hook, const OnRecipeTrained &onTrained = {});

} // namespace driftbench
