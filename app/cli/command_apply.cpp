#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/log_options.h"
#include "app/cli/model_input.h"
#include "app/cli/model_range.h"
#include "app/cli/progress_line.h"
#include "engine/base/axes.h"
#include "engine/formats/compensated_csv.h"
#include "engine/formats/log_reader.h"

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

struct ApplyArguments
{
    ModelChoice model;
    std::string in;
    std::string out;
    ReadOptions read;
    SensorIdentity sensor;
    bool force = false;
    bool json = false;
};

Error wrongSensor(const ApplyArguments &arguments, const TrainedModel &model, const SensorIdentity &measured)
{
    return {Errc::ModelOfAnotherSensor, arguments.model.file + " was trained on " + model.sensor.text() +
                                            ", but " + arguments.in + " is of " + measured.text() +
                                            "; take that sensor's model, or say --force."};
}

// The log and the model must still be there when the result is.
Status checkTarget(const ApplyArguments &arguments)
{
    for (const std::string &input : {arguments.in, arguments.model.file}) {
        std::error_code code;
        if (std::filesystem::equivalent(input, arguments.out, code))
            return Error{Errc::InvalidOption,
                         "The result would replace " + input + "; give it another name."};
    }
    return {};
}

// One pass over the log before anything is written: a model that does not fit must not leave a file.
Result<ModelRange> lookThrough(const ApplyArguments &arguments, const TrainedModel &model,
                               const ProgressHook &hook)
{
    ModelRange range(model);
    const auto look = [&range](const SampleBlock &block) {
        range.add(block.temperatureC);
        return Flow::Continue;
    };
    const auto info = readLogBlocks(arguments.in, arguments.read, look, hook);
    if (!info)
        return info.error();
    const auto measured = statedSensor(arguments.in, info->sensor, arguments.sensor);
    if (!measured)
        return measured.error();
    if (measured->contradicts(model.sensor) && !arguments.force)
        return wrongSensor(arguments, model, *measured);
    if (range.wholly() && !arguments.force)
        return range.refusal(arguments.in, arguments.model.file);
    return range;
}

void printNotices(const ApplyArguments &arguments, const TrainedModel &model, const ModelRange &range)
{
    if (range.reachesBeyond())
        printNotice(range.notice(arguments.in));
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (model.verdicts[axis] && *model.verdicts[axis] != Verdict::Yes) {
            printNotice(std::string(kAxisNames[axis]) + " is compensated although its verdict is " +
                        std::string(verdictName(*model.verdicts[axis])) + ".");
        }
    }
}

Status apply(const ApplyArguments &arguments)
{
    if (Status safe = checkTarget(arguments); !safe)
        return safe;
    const auto input = openModel(arguments.model);
    if (!input)
        return input.error();
    const TrainedModel &model = input->model;
    ProgressLine progress;
    const auto range = lookThrough(arguments, model, progress.hook());
    if (!range)
        return range.error();
    const auto tde = [&](const Eigen::VectorXd &temperatureC) {
        return predictAtTemperature(model, temperatureC).tdeDps;
    };
    const auto written =
        writeCompensatedCsv(arguments.in, arguments.out, arguments.read, tde, progress.hook());
    if (!written)
        return written.error();
    printNotices(arguments, model, *range);
    printWarnings(arguments.in, written->info.warnings);
    if (arguments.json)
        return printJson({{"out", arguments.out},
                          {"samples", written->samples},
                          {"outside_trained_range", range->outside()}});
    return printResult(arguments.out + "  " + std::to_string(written->samples) + " samples\n");
}

} // namespace

void addApplyCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<ApplyArguments>();
    CLI::App *command =
        addCommand(program, "apply",
                   "Compensates a log with a saved model: a copy of it with the columns comp_x_dps, "
                   "comp_y_dps, comp_z_dps, the measured rate less the model's, in dps.",
                   "driftbench-cli apply --model fit/models/rbf.json run1.csv compensated.csv");
    addModelOptions(*command, arguments->model);
    command->add_option("IN", arguments->in, "Log to compensate")->required();
    command->add_option("OUT", arguments->out, "CSV to write")->required();
    addSensorOption(*command, arguments->sensor);
    command->add_flag("--force", arguments->force,
                      "Also another sensor's log, or one outside the trained range");
    addReadOptions(*command, arguments->read);
    addJsonOption(*command, arguments->json);
    command->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return apply(*arguments); }; });
}

} // namespace driftbench::cli
