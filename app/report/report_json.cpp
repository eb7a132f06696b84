#include "app/report/report_json.h"

#include "engine/base/axes.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <limits>

namespace driftbench {

using nlohmann::json;

static double numberOf(const json &object, const char *key)
{
    const json &value = object.at(key);
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

// "x", or 0 for x.
static int axisOf(const json &value)
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

static ComparisonRow rowOf(const json &object)
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
    row.samples = object.at("samples").get<Eigen::Index>();
    return row;
}

static AxisVerdict verdictOf(const json &object)
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

static std::vector<double> lossesOf(const json &values)
{
    std::vector<double> losses;
    for (const json &value : values)
        losses.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>());
    return losses;
}

static RbfSelection selectionOf(const json &object)
{
    RbfSelection selection;
    for (std::size_t axis = 0; axis < selection.chosen.size(); ++axis) {
        const json &ofAxis = object.at(std::string(kAxisNames[axis]));
        selection.heldOutLoss[axis] = lossesOf(ofAxis.at("held_out_loss"));
        selection.trainingLoss[axis] = lossesOf(ofAxis.at("training_loss"));
        selection.chosen[axis] = ofAxis.at("chosen").get<int>();
    }
    selection.leftOutRuns = object.at("left_out_runs").get<bool>();
    return selection;
}

// Throws json::exception where the document is of another shape.
static ComparisonFile comparisonOf(const json &document)
{
    ComparisonFile file;
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
    return file;
}

Result<ComparisonFile> readComparisonFile(const std::filesystem::path &file)
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
    try {
        return comparisonOf(json::parse(text));
    } catch (const json::exception &problem) {
        return Error{Errc::ModelDamaged,
                     file.string() + " is damaged (" + problem.what() + "): run the fit again."};
    }
}

} // namespace driftbench
