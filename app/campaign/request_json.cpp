#include "app/campaign/campaign_request.h"
#include "app/campaign/json_optional.h"
#include "app/campaign/read_options_json.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace driftbench {

namespace {

using Json = nlohmann::ordered_json;

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
    const auto read = readOptionsFromJson(json.at("read"));
    if (!read)
        throw std::runtime_error("read");
    request.read = *read;
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
        {"read", readOptionsToJson(request.read)},
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
