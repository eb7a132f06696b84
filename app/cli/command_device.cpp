#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/device_part.h"
#include "app/cli/device_text.h"
#include "app/cli/progress_line.h"
#include "device/table_upload.h"
#include "engine/base/atomic_file.h"
#include "engine/base/text.h"
#include "engine/exports/device_image.h"

#include <cmath>
#include <memory>
#include <optional>

namespace driftbench::cli {

namespace {

using Json = nlohmann::ordered_json;

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

void addInfo(CLI::App &device, Invocation &invocation)
{
    const auto arguments = std::make_shared<DeviceArguments>();
    CLI::App *part =
        addDevicePart(device, "info", "Prints what the device is, how it is set and which tables it holds.",
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
        addDevicePart(device, "configure", "Sets sampling rate, range and compensation; prints the result.",
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

void addReadTable(CLI::App &device, Invocation &invocation)
{
    const auto arguments = std::make_shared<ReadArguments>();
    CLI::App *part =
        addDevicePart(device, "read-table", "Reads a table out of the device and says what it is.",
                      "read-table --flash bridge.bin --out table.bin", arguments->device);
    part->add_option("--bank", arguments->bank, "0 or 1 (default: the one in use)")->type_name("N");
    part->add_option("--out", arguments->out, "Keep the bytes in this file")->type_name("FILE");
    part->callback([arguments, &invocation] { invocation.run = [arguments] { return readIt(*arguments); }; });
}

void addRollback(CLI::App &device, Invocation &invocation)
{
    const auto arguments = std::make_shared<DeviceArguments>();
    CLI::App *part =
        addDevicePart(device, "rollback", "Revokes the table in use; the one before it takes over.",
                      "rollback --flash bridge.bin", *arguments);
    addJsonOption(*part, arguments->json);
    part->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return rollBack(*arguments); }; });
}

} // namespace

CLI::App *addDevicePart(CLI::App &device, const std::string &name, const std::string &description,
                        const std::string &example, DeviceArguments &arguments)
{
    CLI::App *part = addCommand(device, name, description, "driftbench-cli device " + example);
    addDeviceOptions(*part, arguments.choice);
    return part;
}

void addDeviceCommand(CLI::App &program, Invocation &invocation)
{
    CLI::App *device =
        addCommand(program, "device",
                   "Talks to a native gyro bridge: what it is, its settings, its compensation tables.",
                   "driftbench-cli device upload --model fit/models/rbf.json");
    device->require_subcommand(1);
    addInfo(*device, invocation);
    addConfigure(*device, invocation);
    addDeviceUpload(*device, invocation);
    addReadTable(*device, invocation);
    addRollback(*device, invocation);
}

} // namespace driftbench::cli
