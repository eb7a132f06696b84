#include "engine/evaluation/comparison.h"

namespace driftbench {

Result<Comparison> compareModels(const TrainingSet &set, const CampaignFacts &facts,
                                 const ComparisonOptions &options, const ProgressHook &hook)
{
    // With folds there are jobs enough for every core; a single training must use them by itself.
    const int threads = options.holdOut.empty() ? 1 : options.threads;
    const auto recipes = modelRecipes(options.models, {options.seed, threads, options.rbf, options.bp});
    if (!recipes)
        return recipes.error();
    return compareRecipes(*recipes, set, facts, options, hook);
}

} // namespace driftbench
