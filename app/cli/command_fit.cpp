#include "app/campaign/calibration_result.h"
#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/dynamic_experiment_text.h"
#include "app/cli/fit_files.h"
#include "app/cli/log_options.h"
#include "app/cli/output_folder.h"
#include "app/cli/progress_line.h"
#include "engine/evaluation/comparison.h"
#include "engine/exports/comparison_files.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
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

// A run may be named by its file: the campaign's runs are in the order of the files.
std::vector<std::string> namesOfHeldOut(const FitArguments &arguments, const Campaign &campaign)
{
    std::vector<std::string> names = arguments.comparison.holdOut;
    for (std::string &wanted : names) {
        const auto isWanted = [&](const Run &run) { return run.name == wanted; };
        if (std::any_of(campaign.runs.begin(), campaign.runs.end(), isWanted))
            continue;
        for (std::size_t i = 0; i < campaign.runs.size(); ++i) {
            std::error_code code;
            if (std::filesystem::equivalent(arguments.request.files[i], wanted, code)) {
                wanted = campaign.runs[i].name;
                break;
            }
        }
    }
    return names;
}

Status fit(const FitArguments &arguments)
{
    // A folder that can't be written to should not cost the user a training.
    OutputFolders folders;
    if (Status writable = folders.make(arguments.out); !writable)
        return writable;
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    ProgressLine progress;
    const auto loaded = loadCampaign(arguments.request, progress.hook());
    if (!loaded)
        return loaded.error();
    const auto read = Clock::now();
    printFindings(loaded->campaign);
    ComparisonOptions options = arguments.comparison;
    options.holdOut = namesOfHeldOut(arguments, loaded->campaign);
    const auto comparison = compareModels(loaded->features, {loaded->campaign.sensor, loaded->simulated},
                                          options, progress.hook());
    if (!comparison)
        return comparison.error();
    const auto compared = Clock::now();
    const CampaignSummary summary = summaryOf(*loaded);
    std::vector<NamedText> beside{{"request.json", requestToJson(arguments.request)}};
    std::vector<DynamicOutcome> dynamic;
    if (arguments.dynamic) {
        auto outcomes = dynamicExperiment(*comparison);
        if (!outcomes)
            return outcomes.error();
        dynamic = *std::move(outcomes);
        beside.push_back({kDynamicExperiment, dynamicToJson(dynamic).dump(2) + "\n"});
    }
    if (Status written = writeFitFiles(arguments.out, *comparison, summary, beside); !written)
        return written;
    folders.keep();
    // Either way the warnings of the comparison are part of what is printed.
    if (!arguments.json)
        return printResult(recommendationToText(*comparison) +
                           (dynamic.empty() ? "" : dynamicAsText(dynamic)));
    auto json = nlohmann::ordered_json::parse(comparisonToJson(*comparison, summary));
    if (arguments.dynamic)
        json["dynamic_experiment"] = dynamicToJson(dynamic);
    json["timings_s"] = {{"read", std::chrono::duration<double>(read - start).count()},
                         {"compare", std::chrono::duration<double>(compared - read).count()}};
    return printJson(json);
}

std::string listed(const std::vector<std::string> &names)
{
    std::string text;
    for (const std::string &name : names)
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
    command
        ->add_option("--models", arguments->comparison.models,
                     "Of " + listed(knownModelNames()) + " (default: " + listed(defaultModelNames()) + ")")
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
