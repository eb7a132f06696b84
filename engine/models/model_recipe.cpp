#include "engine/models/model_recipe.h"

#include "engine/base/axes.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace driftbench {

namespace {

using Summary = std::map<std::string, double>;

// Networks whose weights are found by least squares stand before the one that is found by descent from random
// starts: that one has more parameters and may end elsewhere next time.
constexpr std::array<std::string_view, 7> kSimplestFirst{"constant", "linear",    "cubic", "cubic-ardupilot",
                                                         "rbf",      "rbf-paper", "bpnn"};

// "slope", "dps_per_c" -> slope_x_dps_per_c, slope_y_dps_per_c, ...
template <class Values>
void perAxis(Summary &summary, const std::string &what, const std::string &unit, const Values &values)
{
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
        std::string key = what + "_" + std::string(kAxisNames[axis]);
        if (!unit.empty())
            key += "_" + unit;
        summary[key] = static_cast<double>(values(static_cast<Eigen::Index>(axis)));
    }
}

bool hasSamples(const TrainingSet &set)
{
    return std::any_of(set.runs.begin(), set.runs.end(), [](const auto &run) { return !run->curve.empty(); });
}

FittedModel constantModel(const TrainingSet &set)
{
    const ConstantModel model = fitConstant(set);
    FittedModel fitted{model, {}, {}, {}};
    perAxis(fitted.summary, "bias", "dps", model.biasDps);
    return fitted;
}

FittedModel linearModel(const TrainingSet &set)
{
    const LinearModel model = fitLinear(set);
    FittedModel fitted{model, {}, {}, {}};
    perAxis(fitted.summary, "bias", "dps", model.biasDps);
    perAxis(fitted.summary, "slope", "dps_per_c", model.slopeDpsPerC);
    return fitted;
}

FittedModel cubicModel(const PolynomialModel &model, const TrainingSet &set)
{
    FittedModel fitted{model, {}, {}, {}};
    fitted.summary["centre_temperature_c"] = model.centreDeltaT + set.referenceTemperatureC;
    perAxis(fitted.summary, "c0", "dps", model.coefficients.row(0));
    perAxis(fitted.summary, "c1", "dps_per_c", model.coefficients.row(1));
    perAxis(fitted.summary, "c2", "dps_per_c2", model.coefficients.row(2));
    perAxis(fitted.summary, "c3", "dps_per_c3", model.coefficients.row(3));
    return fitted;
}

Result<FittedModel> bpModel(const TrainingSet &set, const BpOptions &options, const ProgressHook &hook)
{
    auto fit = fitBpNetwork(set, options, hook);
    if (!fit)
        return fit.error();
    const auto bestOf = [&fit](Eigen::Index axis) {
        const auto &starts = fit->summary.starts[static_cast<std::size_t>(axis)];
        return *std::min_element(starts.begin(), starts.end(), [](const auto &left, const auto &right) {
            return left.lossDps2 < right.lossDps2;
        });
    };
    FittedModel fitted{fit->network, {}, {}, {}};
    fitted.summary["hidden_units"] = options.hiddenUnits;
    fitted.summary["starts"] = options.starts;
    perAxis(fitted.summary, "loss", "dps2", [&](Eigen::Index axis) { return bestOf(axis).lossDps2; });
    perAxis(fitted.summary, "iterations", "", [&](Eigen::Index axis) { return bestOf(axis).iterations; });
    return fitted;
}

Result<FittedModel> rbfModel(const TrainingSet &set, const RbfOptions &options, const ProgressHook &hook,
                             const std::shared_ptr<RbfPathCache> &cache)
{
    auto fit = fitRbfNetwork(set, options, hook, cache);
    if (!fit)
        return fit.error();
    FittedModel fitted{fit->network, {}, {}, fit->warnings};
    fitted.summary["shared_centres"] = static_cast<double>(fit->network.size());
    perAxis(fitted.summary, "centres", "",
            [&](Eigen::Index axis) { return fit->network.centreCount[static_cast<std::size_t>(axis)]; });
    fitted.rbf = *std::move(fit);
    return fitted;
}

// Guards the trainers that have no error of their own against a training set without samples.
ModelRecipe recipeOf(std::string name, int complexity,
                     std::function<Result<FittedModel>(const TrainingSet &, const ProgressHook &)> fit)
{
    auto guarded = [name, fit = std::move(fit)](const TrainingSet &set,
                                                const ProgressHook &hook) -> Result<FittedModel> {
        if (!hasSamples(set))
            return Error{Errc::NothingUsable, "There are no usable samples to train the model '" + name +
                                                  "' on; give it runs that are not masked as a whole."};
        if (report(hook, "training", 0.0) == Flow::Stop)
            return Error{Errc::Cancelled, "Training the model '" + name + "' was cancelled."};
        return fit(set, hook);
    };
    return {std::move(name), complexity, std::move(guarded)};
}

ModelRecipe rbfRecipe(const std::string &name, int complexity, RbfPreset preset, const RecipeOptions &options)
{
    RbfOptions rbf = options.rbf;
    rbf.preset = preset;
    rbf.threads = options.threads;
    return recipeOf(name, complexity,
                    [rbf, cache = makeRbfPathCache()](const TrainingSet &set, const ProgressHook &hook) {
                        return rbfModel(set, rbf, hook, cache);
                    });
}

ModelRecipe bpRecipe(const std::string &name, int complexity, const RecipeOptions &options)
{
    BpOptions bp = options.bp;
    bp.seed = options.seed;
    bp.threads = options.threads;
    return recipeOf(name, complexity, [bp](const TrainingSet &set, const ProgressHook &hook) {
        return bpModel(set, bp, hook);
    });
}

ModelRecipe cubicRecipe(const std::string &name, int complexity,
                        const std::shared_ptr<PeerSeriesCache> &cache)
{
    const bool asPx4 = name == "cubic";
    return recipeOf(name, complexity, [asPx4, cache](const TrainingSet &set, const ProgressHook &) {
        return cubicModel(asPx4 ? fitCubicAsPx4(set, cache) : fitCubicAsArduPilot(set, cache), set);
    });
}

ModelRecipe makeRecipe(const std::string &name, int complexity, const RecipeOptions &options,
                       const std::shared_ptr<PeerSeriesCache> &peers)
{
    if (name == "constant")
        return recipeOf(name, complexity,
                        [](const TrainingSet &set, const ProgressHook &) { return constantModel(set); });
    if (name == "linear")
        return recipeOf(name, complexity,
                        [](const TrainingSet &set, const ProgressHook &) { return linearModel(set); });
    if (name == "bpnn")
        return bpRecipe(name, complexity, options);
    if (name == "rbf-paper")
        return rbfRecipe(name, complexity, RbfPreset::Paper, options);
    if (name == "rbf")
        return rbfRecipe(name, complexity, RbfPreset::Best, options);
    return cubicRecipe(name, complexity, peers);
}

Error unknownModel(const std::string &name)
{
    std::string known;
    for (const std::string &each : knownModelNames())
        known += (known.empty() ? "" : ", ") + each;
    return {Errc::InvalidOption, "There is no model '" + name + "'; the known ones are " + known + "."};
}

} // namespace

const std::vector<std::string> &knownModelNames()
{
    static const std::vector<std::string> names{"constant", "linear",    "cubic", "cubic-ardupilot",
                                                "bpnn",     "rbf-paper", "rbf"};
    return names;
}

const std::vector<std::string> &defaultModelNames()
{
    static const std::vector<std::string> names{"constant", "linear", "cubic", "bpnn", "rbf-paper", "rbf"};
    return names;
}

Result<std::vector<ModelRecipe>> modelRecipes(const std::vector<std::string> &names,
                                              const RecipeOptions &options)
{
    const auto peers = makePeerSeriesCache();
    std::vector<ModelRecipe> recipes;
    for (const std::string &name : names) {
        const auto place = std::find(kSimplestFirst.begin(), kSimplestFirst.end(), name);
        if (place == kSimplestFirst.end())
            return unknownModel(name);
        if (std::count(names.begin(), names.end(), name) > 1)
            return Error{Errc::InvalidOption, "Model '" + name + "' is named more than once; name it once."};
        recipes.push_back(makeRecipe(name, static_cast<int>(place - kSimplestFirst.begin()), options, peers));
    }
    return recipes;
}

} // namespace driftbench
