#include "app/cli/plan_text.h"

#include "app/cli/text_layout.h"
#include "engine/base/text.h"
#include "engine/physics/plan_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

using Json = nlohmann::ordered_json;

// Five digits.
std::string rounded(double value)
{
    constexpr int kDigits = 5;
    std::array<char, 32> buffer{};
    const double size = std::abs(value);
    if (size >= 1e4 && size < 1e15)
        return forReading(value, 0);
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::general, kDigits)
                         .ptr;
    std::string text(buffer.data(), end);
    return text.starts_with('-') ? "−" + text.substr(1) : text;
}

// "3:05": hours and minutes
std::string clock(double durationS)
{
    const auto minutes = static_cast<long long>(std::llround(durationS / 60.0));
    const std::string rest = std::to_string(minutes % 60);
    return std::to_string(minutes / 60) + (rest.size() < 2 ? ":0" : ":") + rest;
}

std::string figuresAsText(const std::vector<PlanFigure> &figures)
{
    std::string text;
    for (const PlanFigure &figure : figures) {
        text += "  " + left(figure.name, 18) + right(figure.value ? rounded(*figure.value) : "none", 9) +
                " " + left(figure.unit, 8) + figure.equation + "\n" +
                wrapped(std::string(38, ' '), figure.remark);
    }
    return text;
}

std::string segmentsAsText(const TestPlan &plan)
{
    std::string text = "  part          start  duration   from °C     to °C   °C/min\n";
    int number = 0;
    for (const PlanSegment &segment : plan.segments()) {
        text += "  " + right(std::to_string(++number), 3) + (segment.isHold() ? " hold" : " ramp") +
                right(clock(segment.startS), 9) + right(clock(segment.durationS), 10) +
                right(rounded(segment.fromC), 10) + right(rounded(segment.toC), 10) +
                right(segment.isHold() ? "" : rounded(segment.rateCPerMin()), 9);
        text += segment.isHold()
                    ? "\n"
                    : "   " + rounded(plan.stepC) + " °C every " + rounded(plan.periodS) + " s\n";
    }
    return text;
}

std::string totalsAsText(const TestPlan &plan)
{
    const double runS = plan.runDurationS();
    const auto line = [](const std::string &what, double durationS, std::int64_t samples) {
        return "  " + left(what, 10) + right(clock(durationS), 8) + " h  " + right(rounded(durationS), 9) +
               " s  " + right(std::to_string(samples), 10) + " samples\n";
    };
    return line("a run", runS, plan.samplesPerRun()) +
           line(std::to_string(plan.runs) + (plan.runs == 1 ? " run" : " runs"), plan.runs * runS,
                plan.samplesInAll()) +
           (plan.kind == PlanKind::Cycle ? "" : "  The way back to the start between runs comes on top.\n");
}

std::string stillAirAsText(const TestPlan &plan, const StillAirOutlook &still)
{
    const auto line = [](const std::string &what, double value, const std::string &unit,
                         const std::string &remark) {
        return "  " + left(what, 18) + right(rounded(value), 9) + " " + left(unit, 8) + remark + "\n";
    };
    return line("slowest mode", std::round(still.slowestModeS), "s", "L²/(3π² k_h/(C ρ))") +
           line("settling", std::round(still.settlingS / 6.0) / 10.0, "min",
                "until the centre is within ±" + rounded(plan.chamber.thermometerAccuracyC) +
                    " °C of a step of " + rounded(plan.stepC) + " °C") +
           line("lag on a ramp", std::round(still.rampLagS), "s",
                "of the centre behind a long ramp, " + rounded(std::round(10.0 * still.rampLagC) / 10.0) +
                    " °C at the rate of this plan") +
           line("after the ramp", std::round(100.0 * still.lagAfterRampC) / 100.0, "°C",
                "that the centre lacks when the first ramp ends") +
           line("at the end", std::round(100.0 * still.lagAtEndC) / 100.0, "°C",
                "that it still lacks when the run ends") +
           "  A fan moves heat far faster than still air: measure the lag of the chamber that is used with\n"
           "  driftbench-cli plan --lag-from LOG, and log the temperature beside the gyro.\n";
}

Json figuresToJson(const std::vector<PlanFigure> &figures)
{
    Json list = Json::array();
    for (const PlanFigure &figure : figures) {
        list.push_back({{"name", figure.name},
                        {"value", figure.value ? Json(*figure.value) : Json()},
                        {"unit", figure.unit},
                        {"equation", figure.equation},
                        {"remark", figure.remark}});
    }
    return list;
}

} // namespace

Result<PlanOutline> outlinePlan(const TestPlan &plan)
{
    const auto still = stillAirOutlook(plan);
    if (!still)
        return still.error();
    const auto interval = controlInterval(plan.sensor, plan.lowestC, plan.highestC);
    if (!interval)
        return interval.error();
    const auto period = controlPeriod(plan.chamber, plan.lowestC, plan.highestC);
    if (!period)
        return period.error();
    return PlanOutline{plan, intervalFigures(*interval, plan.sensor, plan.lowestC, plan.highestC),
                       periodFigures(*period, plan.chamber, plan.lowestC, plan.highestC), *still};
}

std::string planAsText(const PlanOutline &outline)
{
    const TestPlan &plan = outline.plan;
    return "Test plan: " + plan.sensor.model + " in " + plan.chamber.model + ", " +
           std::string(planKindName(plan.kind)) + ", " + rounded(plan.lowestC) + " to " +
           rounded(plan.highestC) + " °C\n\nControl interval (Eqs. 13-14, 26-27)\n" +
           figuresAsText(outline.interval) + "\nControl period (Eqs. 25, 28)\n" +
           figuresAsText(outline.period) + "\nA run, times in h:mm\n" + segmentsAsText(plan) +
           "\nIn all, at " + rounded(plan.sampleRateHz) + " Hz\n" + totalsAsText(plan) +
           "\nThe chamber if nothing stirs its air (three-dimensional conduction)\n" +
           stillAirAsText(plan, outline.stillAir);
}

Json planOutlineToJson(const PlanOutline &outline)
{
    const TestPlan &plan = outline.plan;
    Json segments = Json::array();
    for (const PlanSegment &segment : plan.segments()) {
        segments.push_back({{"kind", segment.isHold() ? "hold" : "ramp"},
                            {"start_s", segment.startS},
                            {"duration_s", segment.durationS},
                            {"from_C", segment.fromC},
                            {"to_C", segment.toC},
                            {"rate_C_per_min", segment.rateCPerMin()}});
    }
    const StillAirOutlook &still = outline.stillAir;
    return {{"plan", Json::parse(planToJson(plan))},
            {"control_interval", figuresToJson(outline.interval)},
            {"control_period", figuresToJson(outline.period)},
            {"segments", segments},
            {"run_duration_s", plan.runDurationS()},
            {"samples_per_run", plan.samplesPerRun()},
            {"samples_in_all", plan.samplesInAll()},
            {"still_air",
             {{"slowest_mode_s", still.slowestModeS},
              {"settling_s", still.settlingS},
              {"ramp_lag_s", still.rampLagS},
              {"ramp_lag_C", still.rampLagC},
              {"lag_after_ramp_C", still.lagAfterRampC},
              {"lag_at_end_C", still.lagAtEndC}}}};
}

std::string lagAsText(const std::string &log, const std::string &setpoint, const LagEstimate &lag)
{
    const auto line = [](const std::string &what, double value, double deviation, const std::string &unit) {
        return "  " + left(what, 15) + right(forReading(value, 2), 10) + " ± " + fixed(deviation, 2) + " " +
               unit + "\n";
    };
    return "Lag of the temperature in " + log + " behind " + setpoint + ", first order with dead time\n" +
           line("dead time", lag.deadTimeS, lag.deadTimeSdS, "s") +
           line("time constant", lag.timeConstantS, lag.timeConstantSdS, "s") + "  " + left("offset", 15) +
           right(forReading(lag.offsetC, 3), 10) + " °C\n  " + left("residual", 15) +
           right(fixed(lag.residualRmsC, 3), 10) + " °C rms of " + std::to_string(lag.samples) +
           " samples\n  ± is one standard deviation; on a long ramp the chamber is " +
           fixed(lag.deadTimeS + lag.timeConstantS, 1) + " s late.\n";
}

Json lagToJson(const std::string &log, const std::string &setpoint, const LagEstimate &lag)
{
    return {{"log", log},
            {"setpoint", setpoint},
            {"dead_time_s", lag.deadTimeS},
            {"dead_time_sd_s", lag.deadTimeSdS},
            {"time_constant_s", lag.timeConstantS},
            {"time_constant_sd_s", lag.timeConstantSdS},
            {"offset_C", lag.offsetC},
            {"residual_rms_C", lag.residualRmsC},
            {"samples", lag.samples}};
}

} // namespace driftbench::cli
