#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/log_options.h"
#include "app/cli/progress_line.h"
#include "engine/base/atomic_file.h"
#include "engine/base/axes.h"
#include "engine/base/text.h"
#include "engine/evaluation/comparison.h"
#include "engine/evaluation/dynamic_experiment.h"
#include "engine/exports/comparison_files.h"
#include "engine/models/model_file.h"

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

struct FitArguments
{
    CampaignRequest request;
    ComparisonOptions comparison;
    std::string out;
    bool dynamic = false;
    bool json = false;
};

CampaignSummary summaryOf(const LoadedCampaign &loaded)
{
    CampaignSummary summary;
    summary.sensor = loaded.campaign.sensor;
    summary.referenceTemperatureC = loaded.features.referenceTemperatureC;
    for (const Run &run : loaded.campaign.runs)
        summary.runs.push_back(factsOf(run));
    return summary;
}

// What the fold's model has besides its parameters is the same as for the model of all runs, but for the
// runs.
TrainedModel heldOutModel(const Comparison &comparison, const Fold &fold, std::size_t index)
{
    TrainedModel model = comparison.models[index];
    model.model = fold.models[index].model;
    model.summary = fold.models[index].summary;
    model.trainedOn = fold.trainedOn;
    const DeltaTRange range = trainedRange(fold.training);
    model.lowestTemperatureC = model.referenceTemperatureC + range.lowest;
    model.highestTemperatureC = model.referenceTemperatureC + range.highest;
    model.band.reset();
    return model;
}

Status writeModels(const Comparison &comparison, const std::filesystem::path &folder)
{
    if (Status made = ensureWritableFolder(folder / "models"); !made)
        return made;
    for (const TrainedModel &model : comparison.models) {
        if (Status saved = saveModel(model, folder / "models" / (model.name + ".json")); !saved)
            return saved;
    }
    for (const Fold &fold : comparison.folds) {
        const auto place = folder / "held-out" / fold.name;
        if (Status made = ensureWritableFolder(place); !made)
            return made;
        for (std::size_t i = 0; i < fold.models.size(); ++i) {
            const TrainedModel model = heldOutModel(comparison, fold, i);
            if (Status saved = saveModel(model, place / (model.name + ".json")); !saved)
                return saved;
        }
    }
    return {};
}

Status writeAll(const FitArguments &arguments, const LoadedCampaign &loaded, const Comparison &comparison)
{
    const std::filesystem::path folder = arguments.out;
    if (Status written = writeModels(comparison, folder); !written)
        return written;
    if (Status written = writeFileAtomically(folder / "request.json", requestToJson(arguments.request));
        !written)
        return written;
    return writeComparisonFiles(comparison, summaryOf(loaded), folder);
}

nlohmann::ordered_json dynamicToJson(const std::vector<DynamicOutcome> &outcomes)
{
    auto list = nlohmann::ordered_json::array();
    for (const DynamicOutcome &outcome : outcomes) {
        list.push_back({{"run", outcome.run},
                        {"axis", std::string(kAxisNames[static_cast<std::size_t>(outcome.axis)])},
                        {"msd_static", outcome.msdStatic},
                        {"msd_dynamic", outcome.msdDynamic},
                        {"noise_floor", outcome.noiseFloor},
                        {"lag_time_constant_s", outcome.lagTimeConstantS},
                        {"dps_per_C_per_s", outcome.dpsPerCPerS},
                        {"dps_per_lag_C", outcome.dpsPerLagC}});
    }
    return list;
}

std::string dynamicToText(const std::vector<DynamicOutcome> &outcomes)
{
    std::string text =
        "\nExperiment: rbf with dT/dt and a lag added, MSD on held-out runs in dps^2. Not exported.\n";
    for (const DynamicOutcome &outcome : outcomes) {
        text += "  " + outcome.run + " " + std::string(kAxisNames[static_cast<std::size_t>(outcome.axis)]) +
                "  " + fixed(outcome.msdStatic, 6) + " -> " + fixed(outcome.msdDynamic, 6) + "  (lag " +
                fixed(outcome.lagTimeConstantS, 0) + " s)\n";
    }
    return text;
}

Status fit(const FitArguments &arguments)
{
    // A folder that can't be written to should not cost the user a training.
    if (Status writable = ensureWritableFolder(arguments.out); !writable)
        return writable;
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    ProgressLine progress;
    auto loaded = loadCampaign(arguments.request, progress.hook());
    if (!loaded)
        return loaded.error();
    const auto read = Clock::now();
    printFindings(loaded->campaign);
    const auto comparison = compareModels(loaded->features, {loaded->campaign.sensor, loaded->simulated},
                                          arguments.comparison, progress.hook());
    if (!comparison)
        return comparison.error();
    const auto compared = Clock::now();
    printWarnings("", comparison->warnings);
    if (Status written = writeAll(arguments, *loaded, *comparison); !written)
        return written;
    std::vector<DynamicOutcome> dynamic;
    if (arguments.dynamic) {
        auto outcomes = dynamicExperiment(*comparison);
        if (!outcomes)
            return outcomes.error();
        dynamic = *std::move(outcomes);
        if (Status written =
                writeFileAtomically(std::filesystem::path(arguments.out) / "dynamic_experiment.json",
                                    dynamicToJson(dynamic).dump(2) + "\n");
            !written)
            return written;
    }
    if (!arguments.json)
        return printResult(recommendationToText(*comparison) +
                           (dynamic.empty() ? "" : dynamicToText(dynamic)));
    auto json = nlohmann::ordered_json::parse(comparisonToJson(*comparison, summaryOf(*loaded)));
    if (arguments.dynamic)
        json["dynamic_experiment"] = dynamicToJson(dynamic);
    json["timings_s"] = {{"read", std::chrono::duration<double>(read - start).count()},
                         {"compare", std::chrono::duration<double>(compared - read).count()}};
    return printJson(json);
}

std::string knownModels()
{
    std::string text;
    for (const std::string &name : knownModelNames())
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

} // namespace

void addFitCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<FitArguments>();
    CLI::App *command = addCommand(
        program, "fit",
        "Trains the models and judges them on runs that they have not seen: comparison.json, .csv, .md, "
        "models/<name>.json, recommendation.txt and .json. Leaves one run out at a time, unless --hold-out "
        "says which.",
        "driftbench-cli fit run1.csv run2.csv run3.csv --out fit");
    addCampaignOptions(*command, arguments->request);
    command->add_option("--out", arguments->out, "Folder for the results; made if it is not there")
        ->required()
        ->type_name("DIR");
    command->add_option("--models", arguments->comparison.models, "Of " + knownModels())
        ->delimiter(',')
        ->type_name("NAME,...")
        ->allow_extra_args(false);
    command
        ->add_option("--hold-out", arguments->comparison.holdOut,
                     "Run to judge on and not to train on, by its name or file; may be repeated")
        ->type_name("RUN")
        ->allow_extra_args(false);
    addJudgeOption(*command, arguments->comparison.judging);
    addSeedOption(*command, arguments->comparison.seed);
    command->add_flag(
        "--dynamic", arguments->dynamic,
        "Experiment: would dT/dt and a lag help rbf on held-out runs? Reported, never exported");
    addJsonOption(*command, arguments->json);
    command->callback([arguments, &invocation] { invocation.run = [arguments] { return fit(*arguments); }; });
}

} // namespace driftbench::cli
