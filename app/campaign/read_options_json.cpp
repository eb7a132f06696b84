#include "app/campaign/read_options_json.h"

#include "app/campaign/json_optional.h"

#include <nlohmann/json.hpp>

#include <exception>
#include <string>

namespace driftbench {

namespace {

using Json = nlohmann::ordered_json;

template <class Unit>
Json unitOrNull(const std::optional<Unit> &unit)
{
    return unit ? Json(std::string(unitName(*unit))) : Json();
}

// Throws where the object is of another shape.
ReadOptions readFromJson(const Json &json)
{
    ReadOptions read;
    read.instance = optionalAt<int>(json, "instance");
    read.csv.columns = json.at("columns").get<std::array<std::string, kCsvQuantityCount>>();
    if (const auto separator = optionalAt<std::string>(json, "separator"))
        read.csv.separator = separator->at(0);
    if (const auto unit = optionalAt<std::string>(json, "time_unit"))
        read.csv.timeUnit = timeUnitNamed(*unit);
    if (const auto unit = optionalAt<std::string>(json, "rate_unit"))
        read.csv.rateUnit = rateUnitNamed(*unit);
    if (const auto unit = optionalAt<std::string>(json, "temperature_unit"))
        read.csv.temperatureUnit = temperatureUnitNamed(*unit);
    read.csv.sensitivityMdpsPerCount = optionalAt<double>(json, "sensitivity_mdps_per_count");
    return read;
}

} // namespace

nlohmann::ordered_json readOptionsToJson(const ReadOptions &read)
{
    const CsvOptions &csv = read.csv;
    return {{"instance", orNull(read.instance)},
            {"columns", csv.columns},
            {"separator", csv.separator ? Json(std::string(1, *csv.separator)) : Json()},
            {"time_unit", unitOrNull(csv.timeUnit)},
            {"rate_unit", unitOrNull(csv.rateUnit)},
            {"temperature_unit", unitOrNull(csv.temperatureUnit)},
            {"sensitivity_mdps_per_count", orNull(csv.sensitivityMdpsPerCount)}};
}

std::optional<ReadOptions> readOptionsFromJson(const nlohmann::ordered_json &json)
{
    try {
        return readFromJson(json);
    } catch (const std::exception &) {
        return std::nullopt;
    }
}

} // namespace driftbench
