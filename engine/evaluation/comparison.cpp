#include "engine/evaluation/comparison.h"

#include "engine/evaluation/comparison_parts.h"
#include "engine/evaluation/training_jobs.h"

#include <algorithm>

namespace driftbench {

namespace {

ProgressHook partOfWhole(const ProgressHook &hook, double share)
{
    return [&hook, share](const Progress &part) { return report(hook, part.stage, share * part.fraction); };
}

std::vector<Fold> foldsOf(const Splits &splits, const ModelsBySet &models)
{
    std::vector<Fold> folds;
    for (const Split &split : splits.splits)
        folds.push_back({split.name, split.heldOut, splits.trainedOn[split.training],
                         splits.trainings[split.training], models[split.training]});
    return folds;
}

std::vector<ComparisonRow> rowsOfAll(const std::vector<ModelRecipe> &recipes, const Splits &splits,
                                     const Scores &scores)
{
    std::vector<ComparisonRow> rows;
    for (std::size_t s = 0; s < splits.splits.size(); ++s) {
        const Split &split = splits.splits[s];
        std::vector<ComparisonRow> ofRun;
        for (std::size_t m = 0; m < recipes.size(); ++m) {
            for (ComparisonRow &row : rowsOf(split.name, scores.runs[s], recipes[m].name, scores.models[s][m],
                                             splits.trainedOn[split.training]))
                ofRun.push_back(std::move(row));
        }
        std::stable_sort(ofRun.begin(), ofRun.end(),
                         [](const ComparisonRow &a, const ComparisonRow &b) { return a.axis < b.axis; });
        std::move(ofRun.begin(), ofRun.end(), std::back_inserter(rows));
    }
    return rows;
}

std::vector<std::string> warningsOf(const Splits &splits, const std::vector<ModelRecipe> &recipes,
                                    const std::vector<FittedModel> &models)
{
    std::vector<std::string> warnings;
    if (splits.blocks)
        warnings.push_back(
            "There is only one run: models are judged on blocks of temperature held out of it, "
            "which says nothing about the next run; record a second one.");
    else if (splits.leftOutRuns && splits.splits.size() == 2)
        warnings.push_back("Two runs give no 95 % band of the curve; record a third one.");
    for (std::size_t m = 0; m < recipes.size(); ++m) {
        for (const std::string &warning : models[m].warnings) {
            const std::string text = recipes[m].name + ": " + warning;
            if (std::find(warnings.begin(), warnings.end(), text) == warnings.end())
                warnings.push_back(text);
        }
    }
    return warnings;
}

std::optional<RbfSelection> selectionOf(const std::vector<ModelRecipe> &recipes,
                                        const std::vector<FittedModel> &models)
{
    for (std::size_t m = 0; m < recipes.size(); ++m) {
        if (recipes[m].name == "rbf" && models[m].rbf)
            return models[m].rbf->selection;
    }
    return std::nullopt;
}

OnRecipeTrained namedHook(const std::vector<ModelRecipe> &recipes, const ComparisonOptions &options)
{
    if (!options.onModelTrained)
        return {};
    return [&recipes, &options](std::size_t recipe, double seconds) {
        options.onModelTrained(recipes[recipe].name, seconds);
    };
}

Comparison judged(const TrainedRecipes &trained, const TrainingSet &set, const CampaignFacts &facts,
                  const Splits &splits, const ComparisonOptions &options)
{
    const std::vector<ModelRecipe> &recipes = trained.recipes;
    const ModelsBySet &models = trained.models;
    Comparison comparison;
    comparison.options = options;
    comparison.options.onModelTrained = {}; // what it refers to may be gone
    comparison.options.models.clear();
    for (const ModelRecipe &recipe : recipes)
        comparison.options.models.push_back(recipe.name);
    comparison.simulated = facts.simulated;
    comparison.unfinished = trained.unfinished;
    const Scores scores = scoreAll(comparison, set, splits, models);
    comparison.rows = rowsOfAll(recipes, splits, scores);
    comparison.models = assembleModels(comparison, recipes, facts, splits, models, scores);
    recommendModels(comparison, recipes, facts, splits, scores);
    comparison.folds = foldsOf(splits, models);
    comparison.rbfSelection = selectionOf(recipes, models[splits.everything]);
    comparison.warnings = warningsOf(splits, recipes, models[splits.everything]);
    for (const std::string &name : trained.unfinished)
        comparison.warnings.push_back("The training was stopped before '" + name +
                                      "' was finished; it is not compared.");
    return comparison;
}

} // namespace

Result<Comparison> compareRecipes(const std::vector<ModelRecipe> &recipes, const TrainingSet &set,
                                  const CampaignFacts &facts, const ComparisonOptions &options,
                                  const ProgressHook &hook)
{
    if (recipes.empty())
        return Error{Errc::InvalidOption, "No model was named that should be compared; name at least one."};
    const auto splits = makeSplits(set, options.holdOut);
    if (!splits)
        return splits.error();
    auto trained = trainAll(recipes, splits->trainings, options.threads,
                            partOfWhole(hook, kComparisonTrainingShare), namedHook(recipes, options));
    if (!trained)
        return trained.error();
    const bool partly = !trained->unfinished.empty();
    if ((partly && (!options.keepFinished || trained->recipes.empty())) ||
        (!partly && !options.keepFinished &&
         report(hook, "Judging on held-out runs", kComparisonTrainingShare) == Flow::Stop))
        return Error{Errc::Cancelled, "The training was stopped before it was done; nothing was written."};
    Comparison comparison = judged(*trained, set, facts, *splits, options);
    report(hook, "Judging on held-out runs", 1.0);
    return comparison;
}

} // namespace driftbench
