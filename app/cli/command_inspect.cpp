#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/inspection_text.h"
#include "app/cli/log_options.h"
#include "app/cli/progress_line.h"
#include "engine/formats/log_reader.h"

#include <memory>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

struct InspectArguments
{
    std::string file;
    ReadOptions read;
    QualityOptions quality;
    SensorIdentity sensor;
    bool json = false;
};

// A log of several sensors of which none was chosen: the list is what the user needs.
Status listOnly(const InspectArguments &arguments, const std::vector<LogInstance> &instances)
{
    if (arguments.json)
        return printJson({{"file", arguments.file}, {"instances", instancesToJson(instances)}});
    return printResult(instancesAsText(arguments.file, instances) + "Choose one with --instance N.\n");
}

Status inspect(const InspectArguments &arguments)
{
    ProgressLine progress;
    const auto instances = listInstances(arguments.file, arguments.read, progress.hook());
    if (!instances)
        return instances.error();
    if (instances->size() > 1 && !arguments.read.instance)
        return listOnly(arguments, *instances);
    auto recording = readStatedLog(arguments.file, arguments.read, arguments.sensor, progress.hook());
    if (!recording)
        return recording.error();
    const RecordingInfo info = recording->info;
    const CheckedRun checked = checkRun(*std::move(recording), arguments.quality);
    const Inspection inspection{arguments.file, info, summarise(checked.run), checked.run.findings,
                                checked.refusal};
    if (arguments.json) {
        auto json = inspectionToJson(inspection);
        json["instances"] = instancesToJson(*instances);
        return printJson(json);
    }
    return printResult(inspectionAsText(inspection));
}

} // namespace

void addInspectCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<InspectArguments>();
    CLI::App *command = addCommand(
        program, "inspect", "Says what is in a log, what is wrong with it, and whether it can be calibrated.",
        "driftbench-cli inspect flight.bin --instance 2");
    command->add_option("FILE", arguments->file, "CSV, TSV, PX4 ULog or ArduPilot DataFlash")->required();
    addSensorOption(*command, arguments->sensor);
    addQualityOptions(*command, arguments->quality);
    addReadOptions(*command, arguments->read);
    addJsonOption(*command, arguments->json);
    command->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return inspect(*arguments); }; });
}

} // namespace driftbench::cli
