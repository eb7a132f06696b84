#include "engine/exports/table_json.h"

#include "engine/base/axes.h"
#include "engine/base/text.h"
#include "engine/compensation/fixed_point_table.h"
#include "engine/exports/table_csv.h"

#include <nlohmann/json.hpp>

namespace driftbench {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kFormat = "driftbench compensation table";

Json provenanceToJson(const TableProvenance &from, const std::array<bool, 3> &compensated)
{
    Json json;
    json["model"] = from.modelName;
    json["sensor"] = {{"model", from.sensor.model}, {"serial", from.sensor.serial}};
    json["simulated"] = from.simulated;
    json["reference_temperature_C"] = from.referenceTemperatureC;
    json["trained_range_C"] = {from.lowestTemperatureC, from.highestTemperatureC};
    json["trained_on"] = from.trainedOn;
    json["judging"] = from.judging;
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
        Json verdict;
        if (from.verdicts[axis])
            verdict = std::string(verdictName(*from.verdicts[axis]));
        json["axes"].push_back({{"axis", std::string(kAxisNames[axis])},
                                {"compensated", compensated[axis]},
                                {"verdict", verdict},
                                {"reason", from.reasons[axis]}});
    }
    return json;
}

Json fixedPointToJson(const FixedPointTable &fixed)
{
    return {{"fraction_bits", fixed.fractionBits},
            {"reciprocal", fixed.reciprocal},
            {"shift", fixed.shift},
            {"error_bound_dps", fixed.errorBoundDps},
            {"temperature_rounding_dps", fixed.temperatureRoundingDps},
            {"values", fixed.values}};
}

void provenanceFromJson(const Json &json, TableProvenance &from, std::array<bool, 3> &compensated)
{
    from.modelName = json.at("model").get<std::string>();
    from.sensor.model = json.at("sensor").at("model").get<std::string>();
    from.sensor.serial = json.at("sensor").at("serial").get<std::string>();
    from.simulated = json.at("simulated").get<bool>();
    from.referenceTemperatureC = json.at("reference_temperature_C").get<double>();
    from.lowestTemperatureC = json.at("trained_range_C").at(0).get<double>();
    from.highestTemperatureC = json.at("trained_range_C").at(1).get<double>();
    from.trainedOn = json.at("trained_on").get<std::vector<std::string>>();
    from.judging = json.at("judging").get<std::string>();
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
        const Json &entry = json.at("axes").at(axis);
        compensated[axis] = entry.at("compensated").get<bool>();
        if (!entry.at("verdict").is_null())
            from.verdicts[axis] = verdictFromName(entry.at("verdict").get<std::string>());
        from.reasons[axis] = entry.at("reason").get<std::string>();
    }
}

CompensationTable tableFields(const Json &json)
{
    CompensationTable table;
    provenanceFromJson(json.at("provenance"), table.provenance, table.compensated);
    table.firstMilliC = json.at("first_millidegree").get<std::int32_t>();
    table.lastMilliC = json.at("last_millidegree").get<std::int32_t>();
    table.measuredErrorDps = json.at("measured_interpolation_error_dps").get<double>();
    table.interpolationErrorBoundDps = json.at("interpolation_error_bound_dps").get<double>();
    const auto rows = json.at("tde_dps").get<std::vector<std::array<double, 3>>>();
    table.tdeDps.resize(static_cast<Eigen::Index>(rows.size()), 3);
    for (std::size_t i = 0; i < rows.size(); ++i)
        table.tdeDps.row(static_cast<Eigen::Index>(i)) << rows[i][0], rows[i][1], rows[i][2];
    return table;
}

Result<CompensationTable> tableFromParsed(const Json &json, const std::string &name)
{
    if (json.at("format") != kFormat)
        return Error{Errc::ModelDamaged, name + " is no compensation table; choose an exported table."};
    if (json.at("version").get<int>() > kTableFormatVersion) {
        return Error{Errc::ModelTooNew,
                     name + " was written by a newer version of Driftbench; update this one to read it."};
    }
    CompensationTable table = tableFields(json);
    if (const Status status = checkReadTable(table, name); !status)
        return status.error();
    if (json.at("fixed_point") != fixedPointToJson(makeFixedPointTable(table))) {
        return Error{Errc::ModelEdited,
                     name + " was changed by hand: its fixed-point values are not those of its table; "
                            "export the table again."};
    }
    return table;
}

} // namespace

std::string tableToJson(const CompensationTable &table)
{
    Json json;
    json["format"] = std::string(kFormat);
    json["version"] = kTableFormatVersion;
    json["units"] = {{"temperature", "C"}, {"tde", "dps"}};
    json["use"] = "compensated rate = rate - tde; linear between knots, outside the end value is held";
    json["provenance"] = provenanceToJson(table.provenance, table.compensated);
    json["first_millidegree"] = table.firstMilliC;
    json["last_millidegree"] = table.lastMilliC;
    json["knots"] = table.size();
    json["step_C"] = table.stepC();
    json["measured_interpolation_error_dps"] = table.measuredErrorDps;
    json["interpolation_error_bound_dps"] = table.interpolationErrorBoundDps;
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < table.size(); ++i)
        rows.push_back({table.tdeDps(i, 0), table.tdeDps(i, 1), table.tdeDps(i, 2)});
    json["tde_dps"] = std::move(rows);
    json["fixed_point"] = fixedPointToJson(makeFixedPointTable(table));
    // Names that are not UTF-8 get replacement characters instead of an exception.
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<CompensationTable> tableFromJson(std::string_view text, const std::string &name)
{
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded())
        return Error{Errc::ModelDamaged, name + " is cut or no JSON file; export the table again."};
    try {
        return tableFromParsed(json, name);
    } catch (const Json::exception &exception) {
        return Error{Errc::ModelDamaged, name + " misses a field or has one of the wrong shape (" +
                                             exception.what() + "); export the table again."};
    }
}

Result<CompensationTable> readTable(std::string_view text, const std::string &name)
{
    return trimmed(text).starts_with('{') ? tableFromJson(text, name) : tableFromCsv(text, name);
}

} // namespace driftbench
