#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/log_options.h"
#include "app/cli/model_input.h"
#include "app/cli/model_range.h"
#include "app/cli/progress_line.h"
#include "app/cli/session_fit.h"
#include "engine/base/axes.h"
#include "engine/base/text.h"
#include "engine/evaluation/scoring.h"
#include "engine/exports/comparison_files.h"

#include <algorithm>
#include <iomanip>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace driftbench::cli {

namespace {

struct EvaluateArguments
{
    ModelChoice model;
    CampaignRequest request;
    PlanOverrides overrides; // of a session's plan
    Judging judging = Judging::Absolute;
    bool force = false;
    bool json = false;
};

std::string rowsAsText(const std::vector<ComparisonRow> &rows)
{
    std::ostringstream text;
    text << std::left << std::setw(24) << "run" << std::setw(6) << "axis" << std::right << std::setw(14)
         << "MSD before" << std::setw(14) << "MSD after" << std::setw(10) << "Q" << std::setw(14) << "floor"
         << std::setw(12) << "left dps" << std::setw(12) << "10 s dps" << '\n';
    for (const ComparisonRow &row : rows) {
        text << std::left << std::setw(24) << row.run << std::setw(6)
             << kAxisNames[static_cast<std::size_t>(row.axis)] << std::right << std::setw(14)
             << fixed(row.msdBefore, 6) << std::setw(14) << fixed(row.msdAfter, 6) << std::setw(10)
             << fixed(row.q, 4) << std::setw(14) << fixed(row.noiseFloor, 6) << std::setw(12)
             << fixed(row.rmsDps, 4) << std::setw(12) << fixed(row.rms10sDps, 4) << '\n';
    }
    return text.str();
}

// Refused where the model has nothing to say about any of the runs; a notice of each that it covers in part.
Status checkRange(const EvaluateArguments &arguments, const TrainedModel &model, const LoadedCampaign &loaded)
{
    ModelRange all(model);
    std::vector<std::string> notices;
    for (const auto &run : loaded.features.runs) {
        ModelRange range(model);
        const Eigen::VectorXd temperatureC = run->deltaT.array() + loaded.features.referenceTemperatureC;
        range.add(temperatureC);
        all.add(temperatureC);
        if (range.reachesBeyond())
            notices.push_back(range.notice(run->name));
    }
    if (all.wholly() && !arguments.force)
        return all.refusal(arguments.request.files.size() == 1 ? arguments.request.files[0].string()
                                                               : std::string("Each of the runs"),
                           arguments.model.file);
    printWarnings("", notices);
    return {};
}

// session: the one that the runs are of, if it is not that of the model.
Result<LoadedCampaign> runsOf(const EvaluateArguments &arguments, ModelInput &input,
                              std::unique_ptr<Session> &session, const ProgressHook &hook)
{
    // Features must lie on the model's own dT.
    const double referenceTemperatureC = input.model.referenceTemperatureC;
    const auto path = sessionAmong(arguments.request.files);
    if (!path)
        return path.error();
    if (!*path) {
        CampaignRequest request = arguments.request;
        request.referenceTemperatureC = referenceTemperatureC;
        return loadCampaign(request, hook);
    }
    std::error_code code;
    if (input.session && std::filesystem::equivalent(input.session->path(), **path, code)) {
        session = std::move(input.session);
    } else {
        auto opened = Session::open(**path);
        if (!opened)
            return opened.error();
        session = *std::move(opened);
    }
    PlanOverrides overrides = arguments.overrides;
    overrides.referenceTemperatureC = referenceTemperatureC;
    const auto plan = overridden(*session, overrides);
    if (!plan)
        return plan.error();
    auto prepared = prepareSession(*session, *plan, hook);
    if (!prepared)
        return prepared.error();
    return std::move(prepared->loaded);
}

Status evaluate(const EvaluateArguments &arguments)
{
    auto input = openModel(arguments.model);
    if (!input)
        return input.error();
    const TrainedModel *model = &input->model;
    ProgressLine progress;
    std::unique_ptr<Session> session;
    const auto loaded = runsOf(arguments, *input, session, progress.hook());
    if (!loaded)
        return loaded.error();
    if (loaded->campaign.sensor.contradicts(model->sensor) && !arguments.force) {
        return Error{Errc::ModelOfAnotherSensor, arguments.model.file + " was trained on " +
                                                     model->sensor.text() + ", but the runs are of " +
                                                     loaded->campaign.sensor.text() +
                                                     "; take that sensor's model, or say --force."};
    }
    if (Status covered = checkRange(arguments, *model, *loaded); !covered)
        return covered;
    printFindings(loaded->campaign);
    std::vector<ComparisonRow> rows;
    for (const auto &run : loaded->features.runs) {
        if (std::find(model->trainedOn.begin(), model->trainedOn.end(), run->name) != model->trainedOn.end())
            printNotice("The model was trained on a run named " + run->name +
                        "; if it is the same, its figures show the fit, not what to expect of new runs.");
        for (ComparisonRow &row : evaluateModel(*model, run, arguments.judging))
            rows.push_back(std::move(row));
    }
    const nlohmann::ordered_json json{{"model", model->name},
                                      {"file", arguments.model.file},
                                      {"judging", std::string(judgingName(arguments.judging))},
                                      {"simulated", loaded->simulated},
                                      {"rows", nlohmann::ordered_json::parse(rowsToJson(rows))}};
    if (session && !session->isReadOnly()) {
        if (Status kept = session->setEvaluation(json.dump()); !kept)
            return kept;
    }
    return arguments.json ? printJson(json) : printResult(rowsAsText(rows));
}

} // namespace

void addEvaluateCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<EvaluateArguments>();
    CLI::App *command = addCommand(
        program, "evaluate",
        "Judges a saved model on any runs of its sensor, or on those of a session, which keeps the outcome.",
        "driftbench-cli evaluate --model fit/models/rbf.json new_run.csv");
    addModelOptions(*command, arguments->model);
    addCampaignOptions(*command, arguments->request);
    command->remove_option(command->get_option("--reference-temperature"));
    addJudgeOption(*command, arguments->judging);
    command->add_flag("--force", arguments->force,
                      "Also runs of another sensor, or outside the trained range");
    addJsonOption(*command, arguments->json);
    command->callback([arguments, command, &invocation] {
        if (command->count("--reference-rate") > 0)
            arguments->overrides.referenceRate = arguments->request.campaign.referenceRate;
        arguments->overrides.referenceRateDps = arguments->request.campaign.referenceRateDps;
        arguments->overrides.quality = arguments->request.quality;
        invocation.run = [arguments] { return evaluate(*arguments); };
    });
}

} // namespace driftbench::cli
