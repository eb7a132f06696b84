#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/log_options.h"
#include "app/cli/model_range.h"
#include "app/cli/progress_line.h"
#include "engine/base/axes.h"
#include "engine/base/text.h"
#include "engine/evaluation/scoring.h"
#include "engine/exports/comparison_files.h"
#include "engine/models/model_file.h"

#include <algorithm>
#include <iomanip>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace driftbench::cli {

namespace {

struct EvaluateArguments
{
    std::string model;
    CampaignRequest request;
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
                           arguments.model);
    printWarnings("", notices);
    return {};
}

Status evaluate(const EvaluateArguments &arguments)
{
    const auto model = loadModel(arguments.model);
    if (!model)
        return model.error();
    ProgressLine progress;
    CampaignRequest request = arguments.request;
    // Features must lie on the model's own dT.
    request.referenceTemperatureC = model->referenceTemperatureC;
    const auto loaded = loadCampaign(request, progress.hook());
    if (!loaded)
        return loaded.error();
    if (loaded->campaign.sensor.contradicts(model->sensor) && !arguments.force) {
        return Error{Errc::ModelOfAnotherSensor,
                     arguments.model + " was trained on " + model->sensor.text() + ", but the runs are of " +
                         loaded->campaign.sensor.text() + "; take that sensor's model, or say --force."};
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
    if (!arguments.json)
        return printResult(rowsAsText(rows));
    return printJson({{"model", model->name},
                      {"file", arguments.model},
                      {"judging", std::string(judgingName(arguments.judging))},
                      {"simulated", loaded->simulated},
                      {"rows", nlohmann::ordered_json::parse(rowsToJson(rows))}});
}

} // namespace

void addEvaluateCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<EvaluateArguments>();
    CLI::App *command = addCommand(program, "evaluate", "Judges a saved model on any runs of its sensor.",
                                   "driftbench-cli evaluate --model fit/models/rbf.json new_run.csv");
    command->add_option("--model", arguments->model, "Model file that fit wrote")
        ->required()
        ->type_name("FILE");
    addCampaignOptions(*command, arguments->request);
    command->remove_option(command->get_option("--reference-temperature"));
    addJudgeOption(*command, arguments->judging);
    command->add_flag("--force", arguments->force,
                      "Also runs of another sensor, or outside the trained range");
    addJsonOption(*command, arguments->json);
    command->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return evaluate(*arguments); }; });
}

} // namespace driftbench::cli
