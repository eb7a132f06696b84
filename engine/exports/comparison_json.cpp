#include "engine/exports/comparison_files.h"

#include "engine/base/axes.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace driftbench {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

template <class Vector>
Json numbers(const Vector &values)
{
    Json array = Json::array();
    for (const double value : values)
        array.push_back(number(value));
    return array;
}

Json perAxis(const Eigen::MatrixX3d &columns)
{
    Json object;
    for (int axis = 0; axis < kAxisCount; ++axis)
        object[kAxisNames[static_cast<std::size_t>(axis)]] = numbers(columns.col(axis));
    return object;
}

std::string dumped(const Json &json)
{
    // File names need not be UTF-8, and dump throws at what is not unless told to replace it.
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

Json rowsJson(const std::vector<ComparisonRow> &rows)
{
    Json array = Json::array();
    for (const ComparisonRow &row : rows) {
        array.push_back({{"run", row.run},
                         {"axis", kAxisNames[static_cast<std::size_t>(row.axis)]},
                         {"model", row.model},
                         {"msd_before", number(row.msdBefore)},
                         {"msd_after", number(row.msdAfter)},
                         {"q", number(row.q)},
                         {"noise_floor", number(row.noiseFloor)},
                         {"excess_over_floor", number(row.excessOverFloor)},
                         {"rms10s_dps", number(row.rms10sDps)},
                         {"rms_dps", number(row.rmsDps)},
                         {"bias_instability_dps", number(row.biasInstabilityDps)},
                         {"samples", row.samples},
                         {"trained_on", row.trainedOn}});
    }
    return array;
}

Json runsJson(const std::vector<RunFacts> &runs)
{
    Json array = Json::array();
    for (const RunFacts &run : runs) {
        Json masked = Json::object();
        for (const auto &[reason, count] : run.masked)
            masked[reason] = count;
        array.push_back({{"name", run.name},
                         {"file", run.file},
                         {"format", run.format},
                         {"instance", run.instance},
                         {"reference_rate_dps", numbers(run.referenceRateDps)},
                         {"samples", run.samples},
                         {"usable", run.usable},
                         {"masked", masked}});
    }
    return array;
}

Json verdictsJson(const Comparison &comparison)
{
    Json array = Json::array();
    for (std::size_t axis = 0; axis < comparison.verdicts.size(); ++axis) {
        const AxisVerdict &verdict = comparison.verdicts[axis];
        array.push_back({{"axis", kAxisNames[axis]},
                         {"verdict", verdictName(verdict.verdict)},
                         {"model", verdict.model},
                         {"gain", number(verdict.gain)},
                         {"gain_model_free", number(verdict.gainModelFree)},
                         {"reason", verdict.reason}});
    }
    return array;
}

Json hysteresisJson(const Comparison &comparison)
{
    const Hysteresis &hysteresis = comparison.hysteresis;
    Json passages = Json::array();
    for (const Passage &passage : hysteresis.passages)
        passages.push_back({{"run", passage.run},
                            {"direction", passage.heating ? "heating" : "cooling"},
                            {"tde_dps", numbers(passage.tdeDps)}});
    return {{"heating_and_cooling", hysteresis.heatingAndCooling},
            {"rms_dps", numbers(hysteresis.rmsDps)},
            {"meeting_temperature_C", number(hysteresis.meetingTemperatureC)},
            {"passages", passages},
            {"repeat_rms_dps", numbers(comparison.repeatability.repeatRmsDps)},
            {"curve_rms_dps", numbers(comparison.repeatability.curveRmsDps)}};
}

Json selectionJson(const std::optional<RbfSelection> &selection)
{
    if (!selection)
        return nullptr;
    Json object;
    object["left_out_runs"] = selection->leftOutRuns;
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
        object[kAxisNames[axis]] = {{"chosen", selection->chosen[axis]},
                                    {"held_out_loss", numbers(selection->heldOutLoss[axis])},
                                    {"training_loss", numbers(selection->trainingLoss[axis])},
                                    {"held_out_lowest", numbers(selection->heldOutLowest[axis])},
                                    {"held_out_highest", numbers(selection->heldOutHighest[axis])}};
    }
    return object;
}

Json bandJson(const std::vector<TrainedModel> &models)
{
    if (models.empty() || !models.back().band)
        return nullptr;
    const UncertaintyBand &band = *models.back().band;
    return {{"model", models.back().name},
            {"runs", band.runs},
            {"temperature_C", numbers(band.temperatureC)},
            {"curve_half_width_dps", perAxis(band.curveHalfWidthDps)},
            {"sample_half_width_dps", perAxis(band.sampleHalfWidthDps)}};
}

} // namespace

std::string comparisonToJson(const Comparison &comparison, const CampaignSummary &campaign)
{
    Json json;
    json["simulated"] = comparison.simulated;
    json["sensor"] = {{"model", campaign.sensor.model}, {"serial", campaign.sensor.serial}};
    json["judging"] = judgingName(comparison.options.judging);
    json["seed"] = comparison.options.seed;
    json["hold_out"] = comparison.options.holdOut;
    json["reference_temperature_C"] = number(campaign.referenceTemperatureC);
    json["runs"] = runsJson(campaign.runs);
    json["rows"] = rowsJson(comparison.rows);
    json["verdicts"] = verdictsJson(comparison);
    json["hysteresis"] = hysteresisJson(comparison);
    json["rbf_selection"] = selectionJson(comparison.rbfSelection);
    json["band"] = bandJson(comparison.models);
    json["warnings"] = comparison.warnings;
    return dumped(json);
}

std::string rowsToJson(const std::vector<ComparisonRow> &rows)
{
    return dumped(rowsJson(rows));
}

std::string recommendationToJson(const Comparison &comparison)
{
    return dumped(verdictsJson(comparison));
}

} // namespace driftbench
