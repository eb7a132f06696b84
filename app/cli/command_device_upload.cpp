#include "app/cli/cli_io.h"
#include "app/cli/device_part.h"
#include "app/cli/device_text.h"
#include "app/cli/model_input.h"
#include "app/cli/progress_line.h"
#include "app/session/upload_job.h"
#include "device/table_upload.h"
#include "engine/compensation/axis_selection.h"
#include "engine/exports/device_image.h"

#include <memory>
#include <optional>

namespace driftbench::cli {

namespace {

struct UploadArguments
{
    DeviceArguments device;
    ModelChoice model;
    std::string axes;
    std::string kind = "fixed";
    std::string thermometer;
    std::optional<double> boundDps;
    bool force = false;
    bool commitOnly = false;
};

Result<DeviceTableKind> kindNamed(const std::string &name)
{
    if (name == "fixed")
        return DeviceTableKind::FixedPoint;
    if (name == "float")
        return DeviceTableKind::Float;
    return Error{Errc::InvalidOption, "There is no kind of table \"" + name + "\"; say fixed or float."};
}

// Unless named: the external one, with which a log's temperature was measured, where the device has it.
Result<DeviceThermometer> thermometerNamed(const std::string &name, const BridgeInfo &info)
{
    if (name.empty())
        return info.can(BRIDGE_CAN_EXTERNAL) ? DeviceThermometer::External : DeviceThermometer::Die;
    if (name == "die")
        return DeviceThermometer::Die;
    if (name == "external")
        return DeviceThermometer::External;
    return Error{Errc::InvalidOption, "There is no thermometer \"" + name + "\"; say die or external."};
}

Result<CompensationTable> tableOf(const UploadArguments &arguments, const TrainedModel &model)
{
    std::optional<std::array<bool, 3>> wanted;
    if (!arguments.axes.empty()) {
        const auto axes = axesNamed(arguments.axes);
        if (!axes)
            return axes.error();
        wanted = *axes;
    }
    const auto selection = selectAxes(model, wanted, arguments.force);
    if (!selection)
        return selection.error();
    for (const std::string &note : selection->notes)
        printNotice(note);
    TableOptions options;
    options.maxInterpolationErrorDps = arguments.boundDps;
    return makeCompensationTable(model, selection->compensated, options);
}

Status noteUpload(const UploadArguments &arguments, const ModelInput &input, DeviceTableKind kind,
                  const UploadOutcome &done)
{
    if (!isNotedIn(input, "upload"))
        return {};
    UploadRecord made = uploadRecord(done, kind, checkText(done.report));
    made.model = input.session->modelId(input.model.name);
    made.device = arguments.device.choice.device;
    return input.session->addUpload(std::move(made));
}

Status upload(const UploadArguments &arguments)
{
    const auto kind = kindNamed(arguments.kind);
    if (!kind)
        return kind.error();
    const auto input = openModel(arguments.model);
    if (!input)
        return input.error();
    const auto table = tableOf(arguments, input->model);
    if (!table)
        return table.error();
    auto device = connectDevice(arguments.device.choice);
    if (!device)
        return device.error();
    const auto thermometer = thermometerNamed(arguments.thermometer, device->client->info());
    if (!thermometer)
        return thermometer.error();
    const auto image = encodeDeviceImage(*table, *kind, *thermometer);
    if (!image)
        return image.error();
    TableUploadOptions options;
    options.activate = !arguments.commitOnly;
    const auto done = [&] {
        ProgressLine progress;
        return uploadTable(*device->client, *image, options, progress.hook());
    }();
    if (!done)
        return done.error();
    const Status noted = noteUpload(arguments, *input, *kind, {*done, device->client->info()});
    const Status printed =
        arguments.device.json ? printJson(uploadAsJson(*done)) : printResult(uploadAsText(*done));
    if (!noted)
        return noted;
    if (!printed || !done->rolledBack)
        return printed;
    return Error{Errc::TableMismatch,
                 "The new table was rolled back, because the device's compensation could not "
                 "be confirmed; see the comparison above and upload it again."};
}

} // namespace

void addDeviceUpload(CLI::App &device, Invocation &invocation)
{
    const auto arguments = std::make_shared<UploadArguments>();
    CLI::App *part = addDevicePart(
        device, "upload",
        "Writes a model's table into the device, reads it back, compares, puts it into use, and "
        "compares what the device then sends with the host's own compensation. The table that "
        "was there stays until then, comes back if they differ, and can be had back by rollback.",
        "upload --model fit/models/rbf.json --flash bridge.bin", arguments->device);
    addModelOptions(*part, arguments->model);
    part->add_option("--kind", arguments->kind, "fixed (default) or float: how the device computes")
        ->type_name("NAME");
    part->add_option("--thermometer", arguments->thermometer,
                     "die or external: the one that the model's temperature is of (default: external, if the "
                     "device has one)")
        ->type_name("NAME");
    part->add_option("--axes", arguments->axes,
                     "Only these axes, like x,y (default: all whose verdict is yes)")
        ->type_name("AXES");
    part->add_flag("--force", arguments->force, "Also axes whose verdict is not yes");
    part->add_option("--bound", arguments->boundDps, "Largest interpolation error in dps (default 0.001)")
        ->type_name("DPS");
    part->add_flag("--no-activate", arguments->commitOnly, "Leave the table that is in use in use");
    addJsonOption(*part, arguments->device.json);
    part->callback([arguments, &invocation] { invocation.run = [arguments] { return upload(*arguments); }; });
}

} // namespace driftbench::cli
