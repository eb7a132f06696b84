#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/log_options.h"
#include "app/cli/model_input.h"
#include "engine/base/atomic_file.h"
#include "engine/base/axes.h"
#include "engine/base/checksum.h"
#include "engine/exports/export_model.h"

#include <memory>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

struct ExportArguments
{
    ModelChoice model;
    std::string format;
    std::string out;
    std::string axes;
    std::optional<double> boundDps;
    ExportOptions options;
    bool json = false;
};

Status noteExport(const ExportArguments &arguments, const ModelInput &input, const std::string &text)
{
    if (!isNotedIn(input, "export"))
        return {};
    ExportRecord made;
    made.model = input.session->modelId(input.model.name);
    made.format = arguments.format;
    made.path = std::filesystem::absolute(arguments.out).lexically_normal().string();
    made.bytes = static_cast<std::int64_t>(text.size());
    made.crc32 = crc32(text);
    return input.session->addExport(made);
}

Status exportIt(ExportArguments arguments)
{
    const auto format = exportFormatFromName(arguments.format);
    if (!format)
        return Error{Errc::InvalidOption,
                     "There is no format \"" + arguments.format + "\". Say csv, json, c, px4 or ardupilot."};
    if (!arguments.axes.empty()) {
        const auto axes = axesNamed(arguments.axes);
        if (!axes)
            return axes.error();
        arguments.options.axes = *axes;
    }
    if (arguments.boundDps)
        arguments.options.table.maxInterpolationErrorDps = *arguments.boundDps;
    const auto input = openModel(arguments.model);
    if (!input)
        return input.error();
    const auto exported = exportModel(input->model, *format, arguments.options);
    if (!exported)
        return exported.error();
    if (Status written = writeFileAtomically(arguments.out, exported->text); !written)
        return written;
    const std::vector<std::string> &notes = exported->notes;
    printWarnings("", notes);
    if (Status noted = noteExport(arguments, *input, exported->text); !noted)
        return noted;
    if (arguments.json)
        return printJson({{"out", arguments.out}, {"format", arguments.format}, {"notes", notes}});
    return printResult(arguments.out + "\n");
}

} // namespace

void addExportCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<ExportArguments>();
    CLI::App *command =
        addCommand(program, "export",
                   "Writes a model in the form in which it is used: a table as CSV, JSON or C header, or the "
                   "parameters of PX4 or ArduPilot. Axes without the verdict yes need --force.",
                   "driftbench-cli export --model fit/models/auto.json --format c --out gyro_tde.h");
    addModelOptions(*command, arguments->model);
    command->add_option("--format", arguments->format, "csv, json, c, px4, ardupilot")
        ->required()
        ->type_name("NAME");
    command->add_option("--out", arguments->out, "File to write")->required()->type_name("FILE");
    command
        ->add_option("--axes", arguments->axes,
                     "Only these axes, like x,y (default: all whose verdict is yes)")
        ->type_name("AXES");
    command->add_flag("--force", arguments->options.force, "Also axes whose verdict is not yes");
    command
        ->add_option("--bound", arguments->boundDps,
                     "Largest interpolation error of a table in dps (default 0.001)")
        ->type_name("DPS");
    command->add_option("--symbol", arguments->options.symbol, "c: prefix of the names in the header")
        ->capture_default_str()
        ->type_name("NAME");
    command
        ->add_option("--gyro", arguments->options.gyro, "px4: 0 to 3, ardupilot: 1 to 3 (default: the first)")
        ->type_name("N");
    command
        ->add_option("--device-id", arguments->options.deviceId,
                     "px4: id of the gyro (default: the sensor's serial number, if that is a number)")
        ->type_name("ID");
    addJsonOption(*command, arguments->json);
    command->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return exportIt(*arguments); }; });
}

} // namespace driftbench::cli
