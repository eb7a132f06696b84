#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/device_choice.h"
#include "app/cli/device_text.h"
#include "app/cli/progress_line.h"
#include "device/table_upload.h"
#include "engine/base/atomic_file.h"
#include "engine/base/text.h"
#include "engine/compensation/axis_selection.h"
#include "engine/exports/device_image.h"
#include "engine/models/model_file.h"

#include <cmath>
#include <memory>
#include <optional>

namespace driftbench::cli {

namespace {

using Json = nlohmann::ordered_json;

struct DeviceArguments
{
    DeviceChoice choice;
    bool json = false;
};

// info ---------------------------------------------------------------------------------------------------

Status showFacts(BridgeClient &client, bool json)
{
    const auto config = client.config();
    if (!config)
        return config.error();
    const auto status = client.status();
    if (!status)
        return status.error();
    const DeviceFacts facts{client.identity(), client.info(), *config, *status};
    return json ? printJson(factsAsJson(facts)) : printResult(factsAsText(facts));
}

// configure ----------------------------------------------------------------------------------------------

struct ConfigureArguments
{
    DeviceArguments device;
    std::optional<double> rateHz;
    std::optional<double> rangeDps;
    std::optional<bool> compensate;
};

Result<std::uint8_t> rangeNamed(const BridgeInfo &info, double fullScaleDps)
{
    std::string known;
    for (std::size_t range = 0; range < info.ranges.size(); ++range) {
        if (info.ranges[range].fullScaleDps == fullScaleDps)
            return static_cast<std::uint8_t>(range);
        known += (known.empty() ? "" : ", ") + std::to_string(info.ranges[range].fullScaleDps);
    }
    return Error{Errc::InvalidOption, "The device has no range of " + shortest(fullScaleDps) +
                                          " dps; choose one of " + known + "."};
}

Status configure(const ConfigureArguments &arguments)
{
    auto device = connectDevice(arguments.device.choice);
    if (!device)
        return device.error();
    BridgeClient &client = *device->client;
    auto config = client.config();
    if (!config)
        return config.error();
    if (arguments.rateHz) {
        const double milliHz = std::round(*arguments.rateHz * 1000.0);
        if (!(milliHz >= client.info().lowestRateMilliHz && milliHz <= client.info().highestRateMilliHz))
            return Error{Errc::InvalidOption,
                         "The sampling rate is " + shortest(*arguments.rateHz) + " Hz; the device takes " +
                             shortest(client.info().lowestRateMilliHz / 1000.0) + " to " +
                             shortest(client.info().highestRateMilliHz / 1000.0) + " Hz."};
        config->rateMilliHz = static_cast<std::uint32_t>(milliHz);
    }
    if (arguments.rangeDps) {
        const auto range = rangeNamed(client.info(), *arguments.rangeDps);
        if (!range)
            return range.error();
        config->range = *range;
    }
    if (arguments.compensate)
        config->compensate = *arguments.compensate;
    if (const Status done = client.configure(*config); !done)
        return done;
    return showFacts(client, arguments.device.json);
}

// upload -------------------------------------------------------------------------------------------------

struct UploadArguments
{
    DeviceArguments device;
    std::string model;
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

Result<CompensationTable> tableOf(const UploadArguments &arguments)
{
    const auto model = loadModel(arguments.model);
    if (!model)
        return model.error();
    std::optional<std::array<bool, 3>> wanted;
    if (!arguments.axes.empty()) {
        const auto axes = axesNamed(arguments.axes);
        if (!axes)
            return axes.error();
        wanted = *axes;
    }
    const auto selection = selectAxes(*model, wanted, arguments.force);
    if (!selection)
        return selection.error();
    for (const std::string &note : selection->notes)
        printNotice(note);
    TableOptions options;
    options.maxInterpolationErrorDps = arguments.boundDps;
    return makeCompensationTable(*model, selection->compensated, options);
}

Status upload(const UploadArguments &arguments)
{
    const auto kind = kindNamed(arguments.kind);
    if (!kind)
        return kind.error();
    const auto table = tableOf(arguments);
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
    const auto done = [&] {
        ProgressLine progress;
        return uploadTable(*device->client, *image, {!arguments.commitOnly}, progress.hook());
    }();
    if (!done)
        return done.error();
    return arguments.device.json ? printJson(uploadAsJson(*done)) : printResult(uploadAsText(*done));
}

// read-table, rollback -----------------------------------------------------------------------------------

struct ReadArguments
{
    DeviceArguments device;
    std::optional<int> bank;
    std::string out;
};

Status readIt(const ReadArguments &arguments)
{
    auto device = connectDevice(arguments.device.choice);
    if (!device)
        return device.error();
    if (arguments.bank && (*arguments.bank < 0 || *arguments.bank >= static_cast<int>(BRIDGE_BANKS)))
        return Error{Errc::InvalidOption,
                     "There is no bank " + std::to_string(*arguments.bank) + "; choose 0 or 1."};
    const auto bank =
        arguments.bank ? std::optional(static_cast<std::uint8_t>(*arguments.bank)) : std::nullopt;
    const auto bytes = [&] {
        ProgressLine progress;
        return readTable(*device->client, bank, progress.hook());
    }();
    if (!bytes)
        return bytes.error();
    if (!*bytes)
        return Error{Errc::DeviceRefused, bank ? "Bank " + std::to_string(*bank) + " of the device is empty."
                                               : "No table is in use on the device; upload one first."};
    const auto image = decodeDeviceImage(**bytes, "the device's table");
    if (!image)
        return image.error();
    if (!arguments.out.empty()) {
        const std::string_view raw(reinterpret_cast<const char *>((*bytes)->data()), (*bytes)->size());
        if (const Status written = writeFileAtomically(arguments.out, raw); !written)
            return written;
    }
    return printResult(imageAsText(*image));
}

Status rollBack(const DeviceArguments &arguments)
{
    auto device = connectDevice(arguments.choice);
    if (!device)
        return device.error();
    const auto done = rollBackTable(*device->client);
    if (!done)
        return done.error();
    if (arguments.json)
        return printJson(Json{{"before", banksAsJson(done->before)}, {"after", banksAsJson(done->after)}});
    const std::string outcome = done->after.activeBank
                                    ? "The table before it is in use again.\n"
                                    : "No table is in use now; the rates come as measured.\n";
    return printResult("Before\n" + banksAsText(done->before) + "After\n" + banksAsText(done->after) +
                       outcome);
}

// The commands -------------------------------------------------------------------------------------------

CLI::App *addPart(CLI::App &device, const std::string &name, const std::string &description,
                  const std::string &example, DeviceArguments &arguments)
{
    CLI::App *part = addCommand(device, name, description, "driftbench-cli device " + example);
    addDeviceOptions(*part, arguments.choice);
    return part;
}

void addInfo(CLI::App &device, Invocation &invocation)
{
    const auto arguments = std::make_shared<DeviceArguments>();
    CLI::App *part =
        addPart(device, "info", "Prints what the device is, how it is set and which tables it holds.",
                "info --flash bridge.bin", *arguments);
    addJsonOption(*part, arguments->json);
    part->callback([arguments, &invocation] {
        invocation.run = [arguments]() -> Status {
            auto connected = connectDevice(arguments->choice);
            return connected ? showFacts(*connected->client, arguments->json) : Status(connected.error());
        };
    });
}

void addConfigure(CLI::App &device, Invocation &invocation)
{
    const auto arguments = std::make_shared<ConfigureArguments>();
    CLI::App *part =
        addPart(device, "configure", "Sets sampling rate, range and compensation; prints the result.",
                "configure --rate 1000 --range 245", arguments->device);
    part->add_option("--rate", arguments->rateHz, "Samples per second")->type_name("HZ");
    part->add_option("--range", arguments->rangeDps, "Full scale in dps")->type_name("DPS");
    part->add_option("--compensate", arguments->compensate,
                     "Take the table in use off the rates: true, false")
        ->type_name("BOOL");
    addJsonOption(*part, arguments->device.json);
    part->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return configure(*arguments); }; });
}

void addUpload(CLI::App &device, Invocation &invocation)
{
    const auto arguments = std::make_shared<UploadArguments>();
    CLI::App *part =
        addPart(device, "upload",
                "Writes a model's table into the device, reads it back, compares, and puts it into "
                "use. The table that was there stays until then, and can be had back by rollback.",
                "upload --model fit/models/rbf.json --flash bridge.bin", arguments->device);
    part->add_option("--model", arguments->model, "Model file that fit wrote")->required()->type_name("FILE");
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

void addReadTable(CLI::App &device, Invocation &invocation)
{
    const auto arguments = std::make_shared<ReadArguments>();
    CLI::App *part = addPart(device, "read-table", "Reads a table out of the device and says what it is.",
                             "read-table --flash bridge.bin --out table.bin", arguments->device);
    part->add_option("--bank", arguments->bank, "0 or 1 (default: the one in use)")->type_name("N");
    part->add_option("--out", arguments->out, "Keep the bytes in this file")->type_name("FILE");
    part->callback([arguments, &invocation] { invocation.run = [arguments] { return readIt(*arguments); }; });
}

void addRollback(CLI::App &device, Invocation &invocation)
{
    const auto arguments = std::make_shared<DeviceArguments>();
    CLI::App *part = addPart(device, "rollback", "Revokes the table in use; the one before it takes over.",
                             "rollback --flash bridge.bin", *arguments);
    addJsonOption(*part, arguments->json);
    part->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return rollBack(*arguments); }; });
}

} // namespace

void addDeviceCommand(CLI::App &program, Invocation &invocation)
{
    CLI::App *device =
        addCommand(program, "device",
                   "Talks to a native gyro bridge: what it is, its settings, its compensation tables.",
                   "driftbench-cli device upload --model fit/models/rbf.json");
    device->require_subcommand(1);
    addInfo(*device, invocation);
    addConfigure(*device, invocation);
    addUpload(*device, invocation);
    addReadTable(*device, invocation);
    addRollback(*device, invocation);
}

} // namespace driftbench::cli
