#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/pending_files.h"
#include "app/cli/plan_text.h"
#include "app/cli/progress_line.h"
#include "app/cli/setpoint_log.h"
#include "engine/physics/plan_file.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace driftbench::cli {

namespace {

// What is not stated is recommended or stands in the datasheet.
struct PlanArguments
{
    std::string sensor = "L3GD20H";
    std::string chamber = "SET-Z-021";
    std::optional<double> sensitivityMdps, rangeDps, zeroRateMdpsPerC, zeroRateRangeDps, sensitivityPercent;
    std::optional<double> edgeM, specificHeatJPerKgK, densityKgPerM3, conductivityWPerMK, accuracyC;
    std::optional<double> lowestC, highestC, stepC, periodS, holdS, sampleRateHz;
    std::optional<int> cycles, runs;
    PlanKind kind = PlanKind::Heating;
    std::string out;
    std::string steps;
    std::string segments;
    std::string log;
    std::string logPlan;
    SetpointColumns columns;
    bool json = false;
};

template <class T>
void replace(T &value, const std::optional<T> &stated)
{
    value = stated.value_or(value);
}

Result<SensorDatasheet> statedSensorSheet(const PlanArguments &arguments)
{
    auto sensor = namedSensor(arguments.sensor);
    if (!sensor)
        return sensor;
    replace(sensor->sensitivityMdps, arguments.sensitivityMdps);
    replace(sensor->rangeDps, arguments.rangeDps);
    replace(sensor->zeroRateChangeMdpsPerC, arguments.zeroRateMdpsPerC);
    replace(sensor->zeroRateChangeRangeDps, arguments.zeroRateRangeDps);
    replace(sensor->sensitivityChangePercent, arguments.sensitivityPercent);
    replace(sensor->lowestC, arguments.lowestC);
    replace(sensor->highestC, arguments.highestC);
    return sensor;
}

Result<ChamberDatasheet> statedChamberSheet(const PlanArguments &arguments)
{
    auto chamber = namedChamber(arguments.chamber);
    if (!chamber)
        return chamber;
    replace(chamber->edgeM, arguments.edgeM);
    replace(chamber->specificHeatJPerKgK, arguments.specificHeatJPerKgK);
    replace(chamber->densityKgPerM3, arguments.densityKgPerM3);
    replace(chamber->conductivityWPerMK, arguments.conductivityWPerMK);
    replace(chamber->thermometerAccuracyC, arguments.accuracyC);
    return chamber;
}

Result<TestPlan> statedPlan(const PlanArguments &arguments)
{
    const auto sensor = statedSensorSheet(arguments);
    if (!sensor)
        return sensor.error();
    const auto chamber = statedChamberSheet(arguments);
    if (!chamber)
        return chamber.error();
    auto plan = makeTestPlan(*sensor, *chamber);
    if (!plan)
        return plan;
    plan->kind = arguments.kind;
    replace(plan->stepC, arguments.stepC);
    replace(plan->periodS, arguments.periodS);
    replace(plan->holdS, arguments.holdS);
    replace(plan->sampleRateHz, arguments.sampleRateHz);
    replace(plan->cycles, arguments.cycles);
    replace(plan->runs, arguments.runs);
    if (const Status ok = checkTestPlan(*plan); !ok)
        return ok.error();
    return plan;
}

Status writeFiles(const PlanArguments &arguments, const TestPlan &plan)
{
    PendingFiles files;
    if (!arguments.out.empty()) {
        if (Status added = files.add(arguments.out, planToJson(plan)); !added)
            return added;
    }
    if (!arguments.steps.empty()) {
        if (Status added = files.add(arguments.steps, planStepsToCsv(plan)); !added)
            return added;
    }
    if (!arguments.segments.empty()) {
        if (Status added = files.add(arguments.segments, planSegmentsToCsv(plan)); !added)
            return added;
    }
    return files.commit();
}

Status printLag(const PlanArguments &arguments, const TestPlan &plan)
{
    const Result<SetpointLog> log = [&] {
        ProgressLine progress;
        return readSetpointLog(arguments.log, arguments.columns, plan, progress.hook());
    }();
    if (!log)
        return log.error();
    const auto lag = estimateLag(log->setpoint, log->timeS, log->temperatureC);
    if (!lag)
        return lag.error();
    const std::string setpoint =
        !arguments.columns.setpoint.empty()
            ? "its column " + arguments.columns.setpoint
            : "the plan " + (arguments.logPlan.empty() ? "of the options" : arguments.logPlan);
    return arguments.json ? printJson(lagToJson(arguments.log, setpoint, *lag))
                          : printResult(lagAsText(arguments.log, setpoint, *lag));
}

Status plan(const PlanArguments &arguments)
{
    const auto stated = arguments.logPlan.empty() ? statedPlan(arguments) : readPlan(arguments.logPlan);
    if (!stated)
        return stated.error();
    const auto outline = outlinePlan(*stated);
    if (!outline)
        return outline.error();
    if (Status written = writeFiles(arguments, *stated); !written)
        return written;
    if (!arguments.log.empty())
        return printLag(arguments, *stated);
    return arguments.json ? printJson(planOutlineToJson(*outline)) : printResult(planAsText(*outline));
}

void addRunOptions(CLI::App &command, PlanArguments &arguments)
{
    const auto kind = [&arguments](const std::string &text) {
        const auto named = planKindNamed(text);
        if (!named)
            throw CLI::ValidationError("--kind", "\"" + text + "\" is none of heating, cooling, cycle");
        arguments.kind = *named;
    };
    command
        .add_option_function<std::string>("--kind", kind,
                                          "heating (default, the paper's), cooling, or cycle: up and down")
        ->type_name("KIND");
    command.add_option("--low", arguments.lowestC, "Lowest temperature (default: datasheet)")->type_name("C");
    command.add_option("--high", arguments.highestC, "Highest temperature (default: datasheet)")
        ->type_name("C");
    command.add_option("--step", arguments.stepC, "Step of a ramp (default: recommended)")->type_name("C");
    command.add_option("--period", arguments.periodS, "Time for a step (default: recommended)")
        ->type_name("S");
    command.add_option("--hold", arguments.holdS, "Hold before and after a ramp (default 1800)")
        ->type_name("S");
    command.add_option("--rate", arguments.sampleRateHz, "Samples per second (default 10)")->type_name("HZ");
    command.add_option("--cycles", arguments.cycles, "Of a run of the kind cycle (default 1)")
        ->type_name("N");
    command.add_option("--runs", arguments.runs, "Number of runs (default 5)")->type_name("N");
}

void addSensorSheetOptions(CLI::App &command, PlanArguments &arguments)
{
    command.add_option("--sensor", arguments.sensor, "Datasheet of the gyro: L3GD20H (default), I3G4250D")
        ->type_name("NAME");
    command.add_option("--sensitivity", arguments.sensitivityMdps, "Of one count in mdps")->type_name("MDPS");
    command.add_option("--range", arguments.rangeDps, "Full scale in use in dps")->type_name("DPS");
    command
        .add_option("--zero-rate", arguments.zeroRateMdpsPerC, "Zero-rate change with temperature in mdps/C")
        ->type_name("MDPS/C");
    command
        .add_option("--zero-rate-range", arguments.zeroRateRangeDps,
                    "Full scale at which the zero-rate change is stated, in dps")
        ->type_name("DPS");
    command
        .add_option("--sensitivity-change", arguments.sensitivityPercent,
                    "Sensitivity change with temperature in %")
        ->type_name("PERCENT");
}

void addChamberSheetOptions(CLI::App &command, PlanArguments &arguments)
{
    command.add_option("--chamber", arguments.chamber, "Datasheet of the chamber: SET-Z-021 (default)")
        ->type_name("NAME");
    command.add_option("--edge", arguments.edgeM, "Inner edge in m")->type_name("M");
    command.add_option("--specific-heat", arguments.specificHeatJPerKgK, "Of the air in J/(kg K)")
        ->type_name("J/KG/K");
    command.add_option("--density", arguments.densityKgPerM3, "Of the air in kg/m3")->type_name("KG/M3");
    command.add_option("--conductivity", arguments.conductivityWPerMK, "Of the air in W/(m K)")
        ->type_name("W/M/K");
    command.add_option("--accuracy", arguments.accuracyC, "Of the thermometer, +-, in C")->type_name("C");
}

void addFileOptions(CLI::App &command, PlanArguments &arguments)
{
    command.add_option("--out", arguments.out, "Write the plan as JSON, to be used again")->type_name("FILE");
    command.add_option("--csv", arguments.steps, "Write a run's set-points, for a controller that jumps")
        ->type_name("FILE");
    command
        .add_option("--segments", arguments.segments,
                    "Write a run's holds and ramps in C/min, for a controller that ramps")
        ->type_name("FILE");
    command
        .add_option("--plan", arguments.logPlan,
                    "Use this plan instead of making one, without the options above")
        ->type_name("FILE");
    command
        .add_option(
            "--lag-from", arguments.log,
            "Estimate how the temperature in a log follows the set-point, which is a column of the log "
            "or else the plan, started with the log")
        ->type_name("LOG");
    command.add_option("--setpoint-column", arguments.columns.setpoint, "By name or by number from 1")
        ->type_name("COLUMN");
    command
        .add_option("--temperature-column", arguments.columns.temperature, "(default: by its usual names)")
        ->type_name("COLUMN");
    command.add_option("--time-column", arguments.columns.time, "(default: by its usual names)")
        ->type_name("COLUMN");
}

} // namespace

void addPlanCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<PlanArguments>();
    CLI::App *command = addCommand(
        program, "plan",
        "Plans a temperature test from the datasheets of gyro and chamber: steps, period, duration, samples. "
        "Also says how late a chamber follows its set-point.",
        "driftbench-cli plan --sensor I3G4250D --kind cycle --out plan.json");
    addRunOptions(*command, *arguments);
    addSensorSheetOptions(*command, *arguments);
    addChamberSheetOptions(*command, *arguments);
    const std::vector<CLI::Option *> making = command->get_options();
    addFileOptions(*command, *arguments);
    for (CLI::Option *option : making) {
        if (option != command->get_help_ptr())
            command->get_option("--plan")->excludes(option);
    }
    addJsonOption(*command, arguments->json);
    command->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return plan(*arguments); }; });
}

} // namespace driftbench::cli
