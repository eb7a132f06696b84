#include "app/campaign/campaign_request.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace driftbench {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json orNull(const std::optional<T> &value)
{
    return value ? Json(*value) : Json();
}

template <class Unit>
Json unitOrNull(const std::optional<Unit> &unit)
{
    return unit ? Json(std::string(unitName(*unit))) : Json();
}

Json readToJson(const ReadOptions &read)
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

Json qualityToJson(const QualityOptions &quality)
{
    Json excluded = Json::array();
    for (const TimeRange &range : quality.excluded)
        excluded.push_back({range.startS, range.endS});
    return {{"excluded_s", excluded},
            {"mask_bad_rows", quality.maskBadRows},
            {"allow_small_span", quality.allowSmallSpan},
            {"allow_short", quality.allowShort}};
}

template <class T>
std::optional<T> optionalAt(const Json &json, const char *key)
{
    const Json &value = json.at(key);
    return value.is_null() ? std::nullopt : std::optional<T>(value.get<T>());
}

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

QualityOptions qualityFromJson(const Json &json)
{
    QualityOptions quality;
    for (const Json &range : json.at("excluded_s"))
        quality.excluded.push_back({range.at(0).get<double>(), range.at(1).get<double>()});
    quality.maskBadRows = json.at("mask_bad_rows").get<bool>();
    quality.allowSmallSpan = json.at("allow_small_span").get<bool>();
    quality.allowShort = json.at("allow_short").get<bool>();
    return quality;
}

CampaignRequest requestFromJson(const Json &json)
{
    CampaignRequest request;
    for (const Json &file : json.at("files"))
        request.files.emplace_back(file.get<std::string>());
    request.read = readFromJson(json.at("read"));
    request.quality = qualityFromJson(json.at("quality"));
    if (json.at("reference_rate_dps").is_string()) {
        request.campaign.referenceRate = ReferenceRateKind::InitialHold;
    } else {
        const auto rate = json.at("reference_rate_dps").get<std::array<double, 3>>();
        request.campaign.referenceRateDps = {rate[0], rate[1], rate[2]};
    }
    request.referenceTemperatureC = optionalAt<double>(json, "reference_temperature_C");
    request.sensor = {json.at("sensor").at("model").get<std::string>(),
                      json.at("sensor").at("serial").get<std::string>()};
    return request;
}

} // namespace

std::string requestToJson(const CampaignRequest &request)
{
    Json files = Json::array();
    for (const auto &file : request.files)
        files.push_back(std::filesystem::absolute(file).lexically_normal().string());
    const Eigen::Vector3d &rate = request.campaign.referenceRateDps;
    const bool hold = request.campaign.referenceRate == ReferenceRateKind::InitialHold;
    const Json json{
        {"files", files},
        {"read", readToJson(request.read)},
        {"quality", qualityToJson(request.quality)},
        {"reference_rate_dps", hold ? Json("initial hold") : Json({rate[0], rate[1], rate[2]})},
        {"reference_temperature_C", orNull(request.referenceTemperatureC)},
        {"sensor", {{"model", request.sensor.model}, {"serial", request.sensor.serial}}},
    };
    // File names need not be valid UTF-8; JSON must be.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<CampaignRequest> loadRequest(const std::filesystem::path &file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return Error{Errc::FileNotFound, file.string() +
                                             " is not there or can't be read, so the runs of this fit "
                                             "are not known. Name a folder that `driftbench-cli fit` "
                                             "wrote."};
    }
    std::stringstream text;
    text << stream.rdbuf();
    try {
        return requestFromJson(Json::parse(text.str()));
    } catch (const std::exception &) {
        return Error{Errc::ModelDamaged,
                     file.string() +
                         " is damaged, so the runs of this fit are not known. Run the fit again."};
    }
}

} // namespace driftbench
