#include "app/session/calibration_plan.h"

#include "app/campaign/json_optional.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace driftbench {

namespace {

using Json = nlohmann::ordered_json;

Json runsToJson(const CalibrationPlan &plan)
{
    Json runs = Json::array();
    for (const RunInPlan &run : plan.runs)
        runs.push_back({{"run", run.run}, {"takes_part", run.takesPart}});
    return runs;
}

Json trainingToJson(const CalibrationPlan &plan)
{
    return {{"models", plan.models},
            {"seed", plan.seed},
            {"rbf_largest_number_of_centres", plan.rbf.largestNumberOfCentres},
            {"rbf_ridge", plan.rbf.ridge},
            {"rbf_levels", plan.rbf.levels},
            {"rbf_centres", plan.rbf.centres},
            {"rbf_inputs", plan.rbf.inputs},
            {"bp_hidden_units", plan.bp.hiddenUnits},
            {"bp_starts", plan.bp.starts},
            {"bp_iterations", plan.bp.iterations}};
}

Json planJson(const CalibrationPlan &plan)
{
    return {{"runs", runsToJson(plan)},
            {"reference_from_hold", plan.referenceFromHold},
            {"reference_temperature_C", orNull(plan.referenceTemperatureC)},
            {"mask_bad_rows", plan.quality.maskBadRows},
            {"allow_small_span", plan.quality.allowSmallSpan},
            {"allow_short", plan.quality.allowShort},
            {"training", trainingToJson(plan)},
            {"hold_out", plan.holdOut},
            {"judging", judgingName(plan.judging)},
            {"limit_rms_dps", orNull(plan.limitRmsDps)}};
}

void readTraining(const Json &json, CalibrationPlan &plan)
{
    plan.models = json.at("models").get<std::vector<std::string>>();
    plan.seed = json.at("seed").get<std::uint64_t>();
    plan.rbf.largestNumberOfCentres = json.at("rbf_largest_number_of_centres").get<int>();
    plan.rbf.ridge = json.at("rbf_ridge").get<double>();
    plan.rbf.levels = json.at("rbf_levels").get<int>();
    plan.rbf.centres = json.at("rbf_centres").get<int>();
    if (json.contains("rbf_inputs"))
        plan.rbf.inputs = json.at("rbf_inputs").get<std::array<bool, 3>>();
    plan.bp.hiddenUnits = json.at("bp_hidden_units").get<int>();
    plan.bp.starts = json.at("bp_starts").get<int>();
    plan.bp.iterations = json.at("bp_iterations").get<int>();
}

// Throws Json::exception where the document is of another shape.
CalibrationPlan planFrom(const Json &json)
{
    CalibrationPlan plan;
    for (const Json &run : json.at("runs"))
        plan.runs.push_back({run.at("run").get<RunId>(), run.at("takes_part").get<bool>()});
    plan.referenceFromHold = json.at("reference_from_hold").get<bool>();
    plan.referenceTemperatureC = optionalAt<double>(json, "reference_temperature_C");
    plan.quality.maskBadRows = json.at("mask_bad_rows").get<bool>();
    plan.quality.allowSmallSpan = json.at("allow_small_span").get<bool>();
    plan.quality.allowShort = json.at("allow_short").get<bool>();
    readTraining(json.at("training"), plan);
    plan.holdOut = json.at("hold_out").get<std::vector<RunId>>();
    plan.judging = judgingFromName(json.at("judging").get<std::string>()).value_or(Judging::Absolute);
    plan.limitRmsDps = optionalAt<double>(json, "limit_rms_dps");
    return plan;
}

// What is kept beside each run.
Json marksJson(const CalibrationPlan &plan)
{
    Json runs = Json::array();
    for (const RunInPlan &run : plan.runs) {
        Json excluded = Json::array();
        for (const Exclusion &each : run.excluded)
            excluded.push_back({each.range.startS, each.range.endS, each.note});
        const Eigen::Vector3d &rate = run.referenceRateDps;
        runs.push_back({{"excluded", excluded}, {"rate", {rate[0], rate[1], rate[2]}}});
    }
    return runs;
}

} // namespace

const RunInPlan *CalibrationPlan::find(RunId run) const
{
    const auto found =
        std::find_if(runs.begin(), runs.end(), [run](const RunInPlan &each) { return each.run == run; });
    return found == runs.end() ? nullptr : &*found;
}

RunInPlan *CalibrationPlan::find(RunId run)
{
    return const_cast<RunInPlan *>(std::as_const(*this).find(run));
}

bool operator==(const CalibrationPlan &a, const CalibrationPlan &b)
{
    return planJson(a) == planJson(b) && marksJson(a) == marksJson(b);
}

bool computesTheSame(const CalibrationPlan &a, const CalibrationPlan &b)
{
    CalibrationPlan other = b;
    other.limitRmsDps = a.limitRmsDps;
    return a == other;
}

std::optional<bool> passes(const CalibrationPlan &plan, const ComparisonRow &row)
{
    if (!plan.limitRmsDps)
        return std::nullopt;
    return row.rmsDps <= *plan.limitRmsDps;
}

CalibrationPlan fittedToRuns(CalibrationPlan plan, const std::vector<RunRecord> &runs)
{
    std::vector<RunInPlan> fitted;
    for (const RunRecord &run : runs) {
        const RunInPlan *known = plan.find(run.id);
        fitted.push_back(known ? *known : RunInPlan{run.id, true, {}, run.description.referenceRateDps});
    }
    plan.runs = std::move(fitted);
    std::erase_if(plan.holdOut, [&plan](RunId run) { return !plan.find(run); });
    return plan;
}

std::string calibrationPlanToJson(const CalibrationPlan &plan)
{
    return planJson(plan).dump(1);
}

Result<CalibrationPlan> calibrationPlanFromJson(const std::string &json)
{
    try {
        return planFrom(Json::parse(json));
    } catch (const Json::exception &problem) {
        return Error{Errc::SessionDamaged, std::string("The calibration plan in the session is damaged (") +
                                               problem.what() + "); set it anew."};
    }
}

} // namespace driftbench
