#include "engine/physics/test_plan.h"

#include "engine/base/text.h"
#include "engine/physics/control_figures.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr double kLongestRunS = 100.0 * 86400.0;
constexpr double kHighestSampleRateHz = 100000.0;
constexpr int kMostCycles = 1000;
constexpr int kMostRuns = 1000;

struct Figure
{
    std::string_view what;
    double value;
    std::string_view unit;
};

Status checkPositive(const Figure &figure)
{
    if (std::isfinite(figure.value) && figure.value > 0.0)
        return {};
    return invalidOption("The " + std::string(figure.what) + " of the plan is " + shortest(figure.value) +
                         " " + std::string(figure.unit) + "; give more than 0.");
}

Status checkCount(std::string_view what, int count, int most)
{
    if (count >= 1 && count <= most)
        return {};
    return invalidOption("The number of " + std::string(what) + " is " + std::to_string(count) +
                         "; give 1 to " + std::to_string(most) + ".");
}

double stepsBetween(const TestPlan &plan)
{
    return rampSteps(plan.highestC - plan.lowestC, plan.stepC);
}

Status checkQuantities(const TestPlan &plan)
{
    for (const Figure &figure : {Figure{"step", plan.stepC, "°C"}, Figure{"period", plan.periodS, "s"},
                                 Figure{"rate", plan.sampleRateHz, "Hz"}}) {
        if (Status ok = checkPositive(figure); !ok)
            return ok;
    }
    if (plan.stepC > plan.highestC - plan.lowestC)
        return invalidOption("The step of the plan is " + shortest(plan.stepC) +
                             " °C, more than its range of " + shortest(plan.highestC - plan.lowestC) +
                             " °C; take a smaller one.");
    if (plan.sampleRateHz > kHighestSampleRateHz)
        return invalidOption("The rate of the plan is " + shortest(plan.sampleRateHz) + " Hz; give at most " +
                             fixed(kHighestSampleRateHz, 0) + " Hz.");
    if (!std::isfinite(plan.holdS) || plan.holdS < 0.0)
        return invalidOption("The hold of the plan is " + shortest(plan.holdS) + " s; give 0 s or more.");
    return {};
}

Status checkCounts(const TestPlan &plan)
{
    if (const Status ok = checkCount("cycles", plan.cycles, kMostCycles); !ok)
        return ok;
    if (plan.cycles > 1 && plan.kind != PlanKind::Cycle)
        return invalidOption("A run that only goes " +
                             std::string(plan.kind == PlanKind::Heating ? "up" : "down") + " can't have " +
                             std::to_string(plan.cycles) + " cycles; choose the kind cycle.");
    return checkCount("runs", plan.runs, kMostRuns);
}

Status checkLength(const TestPlan &plan)
{
    const double stepsUp = stepsBetween(plan);
    const int ramps = plan.kind == PlanKind::Cycle ? 2 * plan.cycles : 1;
    if (stepsUp * ramps + 1.0 > kMostProfileSteps)
        return invalidOption("The plan has more than a million steps in a run; take larger ones than " +
                             shortest(plan.stepC) + " °C.");
    const double durationS = ramps * stepsUp * plan.periodS + (ramps + 1) * plan.holdS;
    if (durationS > kLongestRunS)
        return invalidOption("A run of the plan would last " + fixed(durationS / 86400.0, 0) +
                             " days; give steps, period, hold and cycles that end within 100 days.");
    return {};
}

void appendHold(std::vector<PlanSegment> &segments, double durationS)
{
    if (durationS <= 0.0)
        return;
    const PlanSegment &last = segments.back();
    segments.push_back({last.startS + last.durationS, durationS, last.toC, last.toC});
}

void appendRamp(std::vector<PlanSegment> &segments, double durationS, double toC)
{
    const PlanSegment &last = segments.back();
    segments.push_back({last.startS + last.durationS, durationS, last.toC, toC});
}

} // namespace

std::string_view planKindName(PlanKind kind)
{
    return kPlanKindNames[static_cast<std::size_t>(kind)];
}

std::optional<PlanKind> planKindNamed(std::string_view name)
{
    const auto found = std::find(kPlanKindNames.begin(), kPlanKindNames.end(), name);
    if (found == kPlanKindNames.end())
        return std::nullopt;
    return static_cast<PlanKind>(found - kPlanKindNames.begin());
}

Result<TestPlan> makeTestPlan(const SensorDatasheet &sensor, const ChamberDatasheet &chamber)
{
    const auto interval = controlInterval(sensor, sensor.lowestC, sensor.highestC);
    if (!interval)
        return interval.error();
    const auto period = controlPeriod(chamber, sensor.lowestC, sensor.highestC);
    if (!period)
        return period.error();
    TestPlan plan{sensor, chamber};
    plan.lowestC = sensor.lowestC;
    plan.highestC = sensor.highestC;
    plan.stepC = interval->recommendedC;
    plan.periodS = period->recommendedS;
    return plan;
}

Status checkTestPlan(const TestPlan &plan)
{
    if (const Status ok = checkDatasheet(plan.sensor); !ok)
        return ok;
    if (const Status ok = checkDatasheet(plan.chamber); !ok)
        return ok;
    if (const Status ok = checkTemperatureRange(plan.lowestC, plan.highestC); !ok)
        return ok;
    if (const Status ok = checkQuantities(plan); !ok)
        return ok;
    if (const Status ok = checkCounts(plan); !ok)
        return ok;
    if (Status ok = checkLength(plan); !ok)
        return ok;
    if (plan.runDurationS() * plan.sampleRateHz < 1.0)
        return invalidOption("A run of the plan lasts " + shortest(plan.runDurationS()) +
                             " s, less than a sample at " + shortest(plan.sampleRateHz) +
                             " Hz; give a longer period or a higher rate.");
    return {};
}

Result<TemperatureProfile> TestPlan::profile() const
{
    if (const Status ok = checkTestPlan(*this); !ok)
        return ok.error();
    const HoldSegment hold{holdS};
    const RampSegment up{highestC, stepC, periodS};
    const RampSegment down{lowestC, stepC, periodS};
    std::vector<ProfileSegment> segments{hold};
    for (int cycle = 0; cycle < cycles; ++cycle) {
        if (kind != PlanKind::Cooling)
            segments.insert(segments.end(), {up, hold});
        if (kind != PlanKind::Heating)
            segments.insert(segments.end(), {down, hold});
    }
    return TemperatureProfile::build("plan", kind == PlanKind::Cooling ? highestC : lowestC, segments);
}

std::vector<PlanSegment> TestPlan::segments() const
{
    const double startC = kind == PlanKind::Cooling ? highestC : lowestC;
    const double rampS = stepsBetween(*this) * periodS;
    // Only where it ends is used: the first segment goes on from there.
    std::vector<PlanSegment> list{{0.0, 0.0, startC, startC}};
    appendHold(list, holdS);
    for (int cycle = 0; cycle < cycles; ++cycle) {
        if (kind != PlanKind::Cooling) {
            appendRamp(list, rampS, highestC);
            appendHold(list, holdS);
        }
        if (kind != PlanKind::Heating) {
            appendRamp(list, rampS, lowestC);
            appendHold(list, holdS);
        }
    }
    list.erase(list.begin());
    return list;
}

double TestPlan::runDurationS() const
{
    const std::vector<PlanSegment> list = segments();
    return list.back().startS + list.back().durationS;
}

std::int64_t TestPlan::samplesPerRun() const
{
    constexpr double kSampleSlack = 1e-6;
    return static_cast<std::int64_t>(std::ceil(runDurationS() * sampleRateHz - kSampleSlack));
}

} // namespace driftbench
