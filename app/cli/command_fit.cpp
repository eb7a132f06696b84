#include "app/campaign/calibration_result.h"
#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/dynamic_experiment_text.h"
#include "app/cli/fit_files.h"
#include "app/cli/log_options.h"
#include "app/cli/output_folder.h"
#include "app/cli/progress_line.h"
#include "app/cli/session_fit.h"
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
    PlanOverrides overrides; // the same for a session: what was said
    std::string out;
    bool dynamic = false;
    bool json = false;
};

// What is compared, from logs or from a session.
struct FitInput
{
    LoadedCampaign loaded;
    ComparisonOptions options;
    std::vector<NamedText> beside; // files in the folder of the results
    std::unique_ptr<Session> session;
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

Result<FitInput> fromLogs(const FitArguments &arguments, const ProgressHook &hook)
{
    auto loaded = loadCampaign(arguments.request, hook);
    if (!loaded)
        return loaded.error();
    FitInput input{
        *std::move(loaded), arguments.comparison, {{"request.json", requestToJson(arguments.request)}}, {}};
    input.options.holdOut = namesOfHeldOut(arguments, input.loaded.campaign);
    return input;
}

// What was said about the calibration stays in the session's plan.
Result<FitInput> fromSession(const FitArguments &arguments, const std::filesystem::path &path,
                             const ProgressHook &hook)
{
    auto session = Session::open(path);
    if (!session)
        return session.error();
    auto plan = overridden(**session, arguments.overrides);
    if (!plan)
        return plan.error();
    if (Status edited = (*session)->editPlan(*std::move(plan), "options of fit"); !edited)
        return edited.error();
    auto prepared = prepareSession(**session, (*session)->plan(), hook);
    if (!prepared)
        return prepared.error();
    auto options = comparisonOptions(*prepared);
    if (!options)
        return options.error();
    LoadedCampaign loaded = prepared->loaded;
    if (!(*session)->setPrepared(std::make_shared<const PreparedCampaign>(*std::move(prepared))))
        return Error{Errc::InvalidOption,
                     "The plan of the session is not the one that was prepared; fit again."};
    return FitInput{std::move(loaded), *std::move(options), {}, *std::move(session)};
}

Result<FitInput> inputOf(const FitArguments &arguments, const ProgressHook &hook)
{
    const auto session = sessionAmong(arguments.request.files);
    if (!session)
        return session.error();
    if (*session)
        return fromSession(arguments, **session, hook);
    if (arguments.out.empty())
        return Error{Errc::InvalidOption, "A fit of logs needs --out: the folder for its results."};
    return fromLogs(arguments, hook);
}

Status keep(const FitArguments &arguments, const FitInput &input, const Comparison &comparison,
            const std::vector<NamedText> &beside)
{
    const CampaignSummary summary = summaryOf(input.loaded);
    if (!arguments.out.empty()) {
        if (Status written = writeFitFiles(arguments.out, comparison, summary, beside); !written)
            return written;
    }
    if (!input.session)
        return {};
    return input.session->setResult(std::make_shared<const CalibrationResult>(resultOf(comparison, summary)));
}

Status fit(const FitArguments &arguments)
{
    // A folder that can't be written to should not cost the user a training.
    OutputFolders folders;
    if (!arguments.out.empty()) {
        if (Status writable = folders.make(arguments.out); !writable)
            return writable;
    }
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    ProgressLine progress;
    const auto input = inputOf(arguments, progress.hook());
    if (!input)
        return input.error();
    const auto read = Clock::now();
    const Campaign &campaign = input->loaded.campaign;
    printFindings(campaign);
    const auto comparison = compareModels(input->loaded.features, {campaign.sensor, input->loaded.simulated},
                                          input->options, progress.hook());
    if (!comparison)
        return comparison.error();
    const auto compared = Clock::now();
    std::vector<NamedText> beside = input->beside;
    std::vector<DynamicOutcome> dynamic;
    if (arguments.dynamic) {
        auto outcomes = dynamicExperiment(*comparison);
        if (!outcomes)
            return outcomes.error();
        dynamic = *std::move(outcomes);
        beside.push_back({kDynamicExperiment, dynamicToJson(dynamic).dump(2) + "\n"});
    }
    if (Status kept = keep(arguments, *input, *comparison, beside); !kept)
        return kept;
    folders.keep();
    // Either way the warnings of the comparison are part of what is printed.
    if (!arguments.json)
        return printResult(recommendationToText(*comparison) +
                           (dynamic.empty() ? "" : dynamicAsText(dynamic)));
    auto json = nlohmann::ordered_json::parse(comparisonToJson(*comparison, summaryOf(input->loaded)));
    if (arguments.dynamic)
        json["dynamic_experiment"] = dynamicToJson(dynamic);
    json["timings_s"] = {{"read", std::chrono::duration<double>(read - start).count()},
                         {"compare", std::chrono::duration<double>(compared - read).count()}};
    return printJson(json);
}

// What of the options was said, as it counts for a session.
PlanOverrides overridesOf(const CLI::App &command, const FitArguments &arguments)
{
    PlanOverrides overrides;
    if (command.count("--reference-rate") > 0)
        overrides.referenceRate = arguments.request.campaign.referenceRate;
    overrides.referenceRateDps = arguments.request.campaign.referenceRateDps;
    overrides.referenceTemperatureC = arguments.request.referenceTemperatureC;
    overrides.quality = arguments.request.quality;
    if (command.count("--models") > 0)
        overrides.models = arguments.comparison.models;
    if (command.count("--hold-out") > 0)
        overrides.holdOut = arguments.comparison.holdOut;
    if (command.count("--judge") > 0)
        overrides.judging = arguments.comparison.judging;
    if (command.count("--seed") > 0)
        overrides.seed = arguments.comparison.seed;
    return overrides;
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
        "says which. A session in place of the runs keeps the models and what was said here in itself.",
        "driftbench-cli fit run1.csv run2.csv run3.csv --out fit");
    addCampaignOptions(*command, arguments->request);
    command
        ->add_option("--out", arguments->out,
                     "Folder for the results; made if it is not there. May be left out for a session")
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
    command->callback([arguments, command, &invocation] {
        arguments->overrides = overridesOf(*command, *arguments);
        invocation.run = [arguments] { return fit(*arguments); };
    });
}

} // namespace driftbench::cli
