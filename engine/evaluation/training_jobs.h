// Every recipe on every training set, on all cores.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/models/model_recipe.h"

#include <vector>

namespace driftbench {

// One vector a training set, in it one model a recipe. The hook is called from the calling thread only; where
// it says stop, Errc::Cancelled. Of several failures the first in the order of sets and recipes is reported.
// The result does not depend on threads (0: one per core).
Result<std::vector<std::vector<FittedModel>>> trainAll(const std::vector<ModelRecipe> &recipes,
                                                       const std::vector<TrainingSet> &sets, int threads,
                                                       const ProgressHook &hook);

} // namespace driftbench
