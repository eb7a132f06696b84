#include "app/session/export_choice.h"

#include "app/campaign/json_optional.h"

#include <nlohmann/json.hpp>

namespace driftbench {

namespace {

using Json = nlohmann::ordered_json;

// Throws Json::exception where the document is of another shape.
ExportChoice choiceFrom(const Json &json)
{
    ExportChoice choice;
    choice.model = json.at("model").get<std::string>();
    choice.options.axes = optionalAt<std::array<bool, 3>>(json, "axes");
    choice.options.force = json.at("force").get<bool>();
    choice.options.table.maxInterpolationErrorDps = optionalAt<double>(json, "bound_dps");
    choice.options.symbol = json.at("symbol").get<std::string>();
    choice.options.gyro = optionalAt<int>(json, "gyro");
    choice.options.deviceId = optionalAt<std::uint32_t>(json, "device_id");
    choice.formats.clear();
    for (const Json &name : json.at("formats")) {
        if (const auto format = exportFormatFromName(name.get<std::string>()))
            choice.formats.push_back(*format);
    }
    choice.deviceTable =
        json.at("device_float").get<bool>() ? DeviceTableKind::Float : DeviceTableKind::FixedPoint;
    choice.deviceThermometer =
        json.at("device_external").get<bool>() ? DeviceThermometer::External : DeviceThermometer::Die;
    return choice;
}

} // namespace

std::string exportChoiceToJson(const ExportChoice &choice)
{
    Json formats = Json::array();
    for (const ExportFormat format : choice.formats)
        formats.push_back(exportFormatName(format));
    const Json json{{"model", choice.model},
                    {"axes", orNull(choice.options.axes)},
                    {"force", choice.options.force},
                    {"bound_dps", orNull(choice.options.table.maxInterpolationErrorDps)},
                    {"symbol", choice.options.symbol},
                    {"gyro", orNull(choice.options.gyro)},
                    {"device_id", orNull(choice.options.deviceId)},
                    {"formats", formats},
                    {"device_float", choice.deviceTable == DeviceTableKind::Float},
                    {"device_external", choice.deviceThermometer == DeviceThermometer::External}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

Result<ExportChoice> exportChoiceFromJson(const std::string &json)
{
    try {
        return choiceFrom(Json::parse(json));
    } catch (const Json::exception &problem) {
        return Error{Errc::SessionDamaged, std::string("The choice of exports in the session is damaged (") +
                                               problem.what() + "); set it anew."};
    }
}

} // namespace driftbench
