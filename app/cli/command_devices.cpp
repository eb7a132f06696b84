#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/device_choice.h"
#include "app/cli/text_table.h"
#include "device/discovery/device_scan.h"

#include <memory>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

using Json = nlohmann::ordered_json;

struct DevicesArguments
{
    std::vector<std::string> usbIds;
    bool json = false;
};

std::string asText(const DeviceList &list)
{
    TextTable table;
    for (const char *title : {"source", "what", "identity", "status"})
        table.addColumn(title, Align::Left);
    std::string problems;
    for (const DeviceEntry &entry : list) {
        table.addRow({entry.source, entry.name, entry.identityText(), std::string(deviceStatusText(entry))});
        if (!entry.status)
            problems += entry.sentence() + '\n';
    }
    if (const Status any = somethingPluggedIn(list); !any)
        problems += any.error().message + '\n';
    return table.text() + problems;
}

Json asJson(const DeviceEntry &entry)
{
    Json json{{"source", entry.source},
              {"what", entry.name},
              {"usb_id", usbIdText({entry.identity.vendorId, entry.identity.productId})},
              {"usb_serial", entry.identity.serial},
              {"path", entry.identity.path}};
    if (entry.details) {
        json["sensor"] = {{"model", entry.details->sensor.model}, {"serial", entry.details->sensor.serial}};
        json["thermometer"] = entry.details->thermometer;
        if (entry.kind == DeviceKind::NativeBridge) {
            json["firmware"] = entry.details->firmware;
            json["protocol"] = entry.details->protocol;
        }
    }
    json["status"] = deviceStatusText(entry);
    json["usable"] = entry.usable();
    json["code"] = entry.status ? 0 : static_cast<int>(entry.status.error().code);
    json["sentence"] = entry.sentence();
    return json;
}

Status showDevices(const DevicesArguments &arguments)
{
    const auto ids = usbIdsOf(arguments.usbIds);
    if (!ids)
        return ids.error();
    const DeviceList list = DeviceScanner(hidDevicesOfThisComputer(), *ids).scan();
    if (arguments.json) {
        Json devices = Json::array();
        for (const DeviceEntry &entry : list)
            devices.push_back(asJson(entry));
        return printJson(Json{{"devices", devices}});
    }
    return printResult(asText(list));
}

} // namespace

void addDevicesCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<DevicesArguments>();
    CLI::App *command = addCommand(
        program, "devices",
        "Lists what can be recorded from: the simulated bridge, native gyro bridges, MCP2221A, CP2112 and "
        "FT260 with the gyro behind them; and what keeps a device from being used, with what to do.",
        "driftbench-cli devices");
    addUsbIdOption(*command, arguments->usbIds);
    addJsonOption(*command, arguments->json);
    command->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return showDevices(*arguments); }; });
}

} // namespace driftbench::cli
