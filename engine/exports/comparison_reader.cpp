#include "engine/exports/comparison_reader.h"

#include "engine/base/axes.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <limits>

namespace driftbench {

namespace {

using nlohmann::json;

double numberOf(const json &object, const char *key)
{
    const json &value = object.at(key);
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

// "x", or 0 for x.
int axisOf(const json &value)
{
    if (value.is_number_integer())
        return value.get<int>();
    const auto name = value.get<std::string>();
    for (int axis = 0; axis < kAxisCount; ++axis) {
        if (kAxisNames[static_cast<std::size_t>(axis)] == name)
            return axis;
    }
    return -1;
}

ComparisonRow rowOf(const json &object)
{
    ComparisonRow row;
    row.run = object.at("run").get<std::string>();
    row.axis = axisOf(object.at("axis"));
    row.model = object.at("model").get<std::string>();
    row.msdBefore = numberOf(object, "msd_before");
    row.msdAfter = numberOf(object, "msd_after");
    row.q = numberOf(object, "q");
    row.noiseFloor = numberOf(object, "noise_floor");
    row.excessOverFloor = numberOf(object, "excess_over_floor");
    row.rms10sDps = numberOf(object, "rms10s_dps");
    if (object.contains("rms_dps")) {
        row.rmsDps = numberOf(object, "rms_dps");
        row.biasInstabilityDps = numberOf(object, "bias_instability_dps");
        row.trainedOn = object.at("trained_on").get<std::vector<std::string>>();
    }
    row.samples = object.at("samples").get<Eigen::Index>();
    return row;
}

AxisVerdict verdictOf(const json &object)
{
    AxisVerdict verdict;
    const auto name = object.at("verdict").get<std::string>();
    verdict.verdict = verdictFromName(name).value_or(Verdict::NotRepeatable);
    verdict.model = object.at("model").get<std::string>();
    verdict.gain = numberOf(object, "gain");
    verdict.gainModelFree = numberOf(object, "gain_model_free");
    verdict.reason = object.at("reason").get<std::string>();
    return verdict;
}

std::vector<double> lossesOf(const json &values)
{
    std::vector<double> losses;
    for (const json &value : values)
        losses.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>());
    return losses;
}

RbfSelection selectionOf(const json &object)
{
    RbfSelection selection;
    for (std::size_t axis = 0; axis < selection.chosen.size(); ++axis) {
        const json &ofAxis = object.at(std::string(kAxisNames[axis]));
        selection.heldOutLoss[axis] = lossesOf(ofAxis.at("held_out_loss"));
        selection.trainingLoss[axis] = lossesOf(ofAxis.at("training_loss"));
        if (ofAxis.contains("held_out_lowest")) {
            selection.heldOutLowest[axis] = lossesOf(ofAxis.at("held_out_lowest"));
            selection.heldOutHighest[axis] = lossesOf(ofAxis.at("held_out_highest"));
        }
        selection.chosen[axis] = ofAxis.at("chosen").get<int>();
    }
    selection.leftOutRuns = object.at("left_out_runs").get<bool>();
    return selection;
}

Eigen::Vector3d tripleOf(const json &values)
{
    Eigen::Vector3d triple;
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
        const json &value = values.at(axis);
        triple[static_cast<Eigen::Index>(axis)] =
            value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
    }
    return triple;
}

void readHysteresis(const json &object, ReadComparison &comparison)
{
    Hysteresis &hysteresis = comparison.hysteresis;
    hysteresis.heatingAndCooling = object.at("heating_and_cooling").get<bool>();
    hysteresis.rmsDps = tripleOf(object.at("rms_dps"));
    hysteresis.meetingTemperatureC = numberOf(object, "meeting_temperature_C");
    for (const json &passage : object.at("passages"))
        hysteresis.passages.push_back({passage.at("run").get<std::string>(),
                                       passage.at("direction").get<std::string>() == "heating",
                                       tripleOf(passage.at("tde_dps"))});
    comparison.repeatRmsDps = tripleOf(object.at("repeat_rms_dps"));
    comparison.curveRmsDps = tripleOf(object.at("curve_rms_dps"));
}

// Throws json::exception where the document is of another shape.
ReadComparison comparisonOf(const json &document)
{
    ReadComparison file;
    file.simulated = document.at("simulated").get<bool>();
    file.judging = document.at("judging").get<std::string>();
    file.referenceTemperatureC = document.at("reference_temperature_C").get<double>();
    for (const json &row : document.at("rows"))
        file.rows.push_back(rowOf(row));
    for (const json &verdict : document.at("verdicts")) {
        const int axis = axisOf(verdict.at("axis"));
        if (axis >= 0 && axis < kAxisCount)
            file.verdicts[static_cast<std::size_t>(axis)] = verdictOf(verdict);
    }
    if (document.contains("rbf_selection") && !document.at("rbf_selection").is_null())
        file.rbfSelection = selectionOf(document.at("rbf_selection"));
    if (document.contains("seed"))
        file.seed = document.at("seed").get<std::uint64_t>();
    if (document.contains("hold_out"))
        file.holdOut = document.at("hold_out").get<std::vector<std::string>>();
    if (document.contains("hysteresis"))
        readHysteresis(document.at("hysteresis"), file);
    if (document.contains("warnings"))
        file.warnings = document.at("warnings").get<std::vector<std::string>>();
    return file;
}

} // namespace

Result<ReadComparison> comparisonFromJson(std::string_view text, const std::string &name)
{
    try {
        return comparisonOf(json::parse(text));
    } catch (const json::exception &problem) {
        return Error{Errc::ModelDamaged, name + " is damaged (" + problem.what() + "): run the fit again."};
    }
}

Result<ReadComparison> readComparisonFile(const std::filesystem::path &file)
{
    std::error_code code;
    if (!std::filesystem::exists(file, code))
        return Error{Errc::FileNotFound, file.string() +
                                             " is missing: name the folder that `driftbench-cli fit "
                                             "--out` wrote."};
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream.good() && !stream.eof())
        return Error{Errc::FileUnreadable, file.string() + " can't be read: check its permissions."};
    return comparisonFromJson(text, file.string());
}

} // namespace driftbench
