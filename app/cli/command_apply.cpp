#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/log_options.h"
#include "app/cli/progress_line.h"
#include "engine/base/axes.h"
#include "engine/base/text.h"
#include "engine/formats/compensated_csv.h"
#include "engine/formats/log_reader.h"
#include "engine/models/model_file.h"

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

struct ApplyArguments
{
    std::string model;
    std::string in;
    std::string out;
    ReadOptions read;
    SensorIdentity sensor;
    bool force = false;
    bool json = false;
};

// Who measured the log, as far as the log or the user says; refused if it is not the model's sensor.
Status checkSensor(const ApplyArguments &arguments, const TrainedModel &model)
{
    const auto instances = listInstances(arguments.in, arguments.read);
    if (!instances)
        return instances.error();
    SensorIdentity measured = arguments.sensor;
    for (const LogInstance &instance : *instances) {
        if (!measured.known() && (!arguments.read.instance || instance.instance == *arguments.read.instance))
            measured = instance.sensor;
    }
    if (!measured.contradicts(model.sensor) || arguments.force)
        return {};
    return Error{Errc::ModelOfAnotherSensor, arguments.model + " was trained on " + model.sensor.text() +
                                                 ", but " + arguments.in + " is of " + measured.text() +
                                                 ". Take that sensor's model, or say --force."};
}

struct RangeCount
{
    Eigen::Index outside = 0;
    double lowestC = INFINITY;
    double highestC = -INFINITY;
};

Error outsideRange(const ApplyArguments &arguments, const TrainedModel &model, const RangeCount &count)
{
    return {Errc::OutsideTrainedRange,
            arguments.in + " lies at " + forReading(count.lowestC, 1) + " to " +
                forReading(count.highestC, 1) + " °C, wholly outside the " +
                forReading(model.lowestTemperatureC, 1) + " to " + forReading(model.highestTemperatureC, 1) +
                " °C that " + arguments.model +
                " was trained on. Record a run that covers it, or say --force to hold the edge value."};
}

Status apply(const ApplyArguments &arguments)
{
    const auto model = loadModel(arguments.model);
    if (!model)
        return model.error();
    if (Status right = checkSensor(arguments, *model); !right)
        return right;
    // One pass over the temperatures first: a model that never fits must not leave a file.
    RangeCount range;
    std::int64_t usable = 0;
    const auto look = [&](const SampleBlock &block) {
        for (const double t : block.temperatureC) {
            if (!std::isfinite(t))
                continue;
            ++usable;
            range.lowestC = std::min(range.lowestC, t);
            range.highestC = std::max(range.highestC, t);
            range.outside += t < model->lowestTemperatureC || t > model->highestTemperatureC ? 1 : 0;
        }
        return Flow::Continue;
    };
    ProgressLine progress;
    if (const auto seen = readLogBlocks(arguments.in, arguments.read, look, progress.hook()); !seen)
        return seen.error();
    if (usable > 0 && range.outside == usable && !arguments.force)
        return outsideRange(arguments, *model, range);

    const auto tde = [&](const Eigen::VectorXd &temperatureC) {
        return predictAtTemperature(*model, temperatureC).tdeDps;
    };
    const auto written =
        writeCompensatedCsv(arguments.in, arguments.out, arguments.read, tde, progress.hook());
    if (!written)
        return written.error();
    if (range.outside > 0) {
        printNotice(std::to_string(range.outside) + " of " + std::to_string(usable) +
                    " samples lie outside the trained range of " + forReading(model->lowestTemperatureC, 1) +
                    " to " + forReading(model->highestTemperatureC, 1) +
                    " °C; the edge value is held there.");
    }
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (model->verdicts[axis] && *model->verdicts[axis] != Verdict::Yes) {
            printNotice(std::string(kAxisNames[axis]) + " is compensated although its verdict is " +
                        std::string(verdictName(*model->verdicts[axis])) + ".");
        }
    }
    printWarnings(arguments.in, written->info.warnings);
    if (arguments.json)
        return printJson({{"out", arguments.out},
                          {"samples", written->samples},
                          {"outside_trained_range", range.outside}});
    return printResult(arguments.out + "  " + std::to_string(written->samples) + " samples\n");
}

} // namespace

void addApplyCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<ApplyArguments>();
    CLI::App *command =
        addCommand(program, "apply",
                   "Compensates a log with a saved model: adds the columns comp_x_dps, comp_y_dps, "
                   "comp_z_dps to a copy of it.",
                   "driftbench-cli apply --model fit/models/rbf.json run1.csv compensated.csv");
    command->add_option("--model", arguments->model, "Model file that fit wrote")
        ->required()
        ->type_name("FILE");
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
