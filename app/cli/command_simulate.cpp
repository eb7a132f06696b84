#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/progress_line.h"
#include "app/cli/simulated_campaign_files.h"

#include "engine/base/text.h"
#include "engine/physics/plan_file.h"
#include "engine/physics/sensor_presets.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace driftbench::cli {

namespace {

using Override = std::function<void(SimulationOptions &)>;

// What was not given is left to the plan, if there is one, and to the sensor.
struct SimulateArguments
{
    std::string out;
    std::optional<int> runs;
    std::uint64_t seed = 1;
    std::optional<std::string> sensor;
    std::optional<std::string> profile;
    std::optional<std::string> plan;
    std::string truth{kCombDriftName};
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    std::vector<Override> overrides; // of the sensor's figures, as given
    bool stairs = false;
    bool json = false;
};

constexpr int kUsualRuns = 5;

struct Simulation
{
    SimulationOptions options;
    int runs = kUsualRuns;
};

Status setTruth(SimulationOptions &options, const SimulateArguments &arguments)
{
    options.gyro.referenceRateDps = arguments.referenceRateDps;
    const bool fromCombs = arguments.truth == kCombDriftName;
    auto truth = fromCombs ? combDriftCurves(*options.combs, arguments.referenceRateDps)
                           : namedDriftCurves(arguments.truth);
    if (!truth)
        return truth.error();
    options.truth = *std::move(truth);
    if (!fromCombs)
        options.combs.reset();
    return {};
}

Status takePlan(Simulation &simulation, const TestPlan &plan)
{
    auto profile = plan.profile();
    if (!profile)
        return profile.error();
    simulation.options.profile = *std::move(profile);
    simulation.options.gyro.sampleRateHz = plan.sampleRateHz;
    simulation.runs = plan.runs;
    return {};
}

// The plan of the arguments, or nothing.
Result<std::optional<TestPlan>> planOf(const SimulateArguments &arguments)
{
    if (!arguments.plan)
        return std::optional<TestPlan>();
    auto plan = readPlan(*arguments.plan);
    if (!plan)
        return plan.error();
    return std::optional<TestPlan>(*std::move(plan));
}

Result<Simulation> simulationOf(const SimulateArguments &arguments)
{
    const auto plan = planOf(arguments);
    if (!plan)
        return plan.error();
    const std::string planned = *plan ? (*plan)->sensor.model : std::string(kSensorNames.front());
    auto preset = presetSimulation(arguments.sensor.value_or(planned), Eigen::Vector3d::Zero());
    if (!preset)
        return preset.error();
    Simulation simulation{*std::move(preset)};
    SimulationOptions &options = simulation.options;
    if (*plan) {
        if (const Status ok = takePlan(simulation, **plan); !ok)
            return ok.error();
    }
    if (arguments.profile) {
        auto profile = TemperatureProfile::named(*arguments.profile);
        if (!profile)
            return profile.error();
        options.profile = *std::move(profile);
    }
    if (const Status ok = setTruth(options, arguments); !ok)
        return ok.error();
    options.seed = arguments.seed;
    if (arguments.stairs)
        options.chamber.thermometerCountsPerC = 1.0;
    for (const Override &override : arguments.overrides)
        override(options);
    simulation.runs = arguments.runs.value_or(simulation.runs);
    return simulation;
}

Status printFiles(const SimulationOptions &options, const SimulatedCampaignFiles &files, bool json)
{
    if (json) {
        nlohmann::ordered_json runs = nlohmann::ordered_json::array();
        for (const auto &[path, samples] : files.runs)
            runs.push_back({{"file", path.string()}, {"samples", samples}});
        return printJson(nlohmann::ordered_json{
            {"simulated", true}, {"seed", options.seed}, {"runs", runs}, {"truth", files.truth.string()}});
    }
    std::string text = "Simulated " + options.sensor.text() + ", profile " + options.profile.name() +
                       ", drift " + options.truth.name + ", seed " + std::to_string(options.seed) + ":\n";
    for (const auto &[path, samples] : files.runs)
        text += "  " + path.string() + "  " + std::to_string(samples) + " samples\n";
    text += "  " + files.truth.string() + "  the true curves\n";
    return printResult(text);
}

void noticeOlderRun(const std::filesystem::path &folder, int runs)
{
    const auto older = folder / ("run" + std::to_string(runs + 1) + ".csv");
    std::error_code code;
    if (std::filesystem::exists(older, code))
        printNotice(older.string() + " was there before and does not belong to these runs.");
}

Status simulate(const SimulateArguments &arguments)
{
    const auto simulation = simulationOf(arguments);
    if (!simulation)
        return simulation.error();
    Result<SimulatedCampaignFiles> files = [&] {
        ProgressLine progress;
        return writeSimulatedCampaign(simulation->options, simulation->runs, arguments.out, progress.hook());
    }();
    if (!files)
        return files.error();
    noticeOlderRun(arguments.out, simulation->runs);
    return printFiles(simulation->options, *files, arguments.json);
}

std::string oneOf(std::span<const std::string_view> names)
{
    std::string text;
    for (const std::string_view name : names)
        text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
}

// Adds options that override a figure of the sensor's preset, with the presets' figures in their help.
class OverrideOptions
{
public:
    OverrideOptions(CLI::App &command, std::vector<Override> &overrides)
        : m_command(command), m_overrides(overrides)
    {
        for (const std::string_view model : kSensorNames) {
            if (auto preset = presetSimulation(model, Eigen::Vector3d::Zero()))
                m_presets.push_back(*std::move(preset));
        }
    }

    template <class Part, class Value>
    void add(const std::string &name, const char *unit, Part SimulationOptions::*part, Value Part::*figure,
             const std::string &description)
    {
        const auto take = [overrides = &m_overrides, part, figure](const Value &value) {
            overrides->push_back(
                [part, figure, value](SimulationOptions &options) { options.*part.*figure = value; });
        };
        m_command
            .add_option_function<Value>(name, take,
                                        description + " (default: " + defaults(part, figure) + ")")
            ->type_name(unit);
    }

private:
    // The figure that all have in common, or each sensor's.
    template <class Part, class Value>
    std::string defaults(Part SimulationOptions::*part, Value Part::*figure) const
    {
        const auto value = [&](const SimulationOptions &preset) { return preset.*part.*figure; };
        const bool common = std::all_of(m_presets.begin(), m_presets.end(), [&](const auto &preset) {
            return value(preset) == value(m_presets.front());
        });
        std::string text;
        for (const SimulationOptions &preset : m_presets) {
            if (common)
                return asText(value(preset));
            text += (text.empty() ? "" : ", ") + preset.sensor.model + " " + asText(value(preset));
        }
        return text;
    }
    static std::string asText(double value) { return shortest(value); }
    static std::string asText(const std::string &value) { return value; }

    CLI::App &m_command;
    std::vector<Override> &m_overrides;
    std::vector<SimulationOptions> m_presets;
};

void addCampaignOptions(CLI::App &command, SimulateArguments &arguments, OverrideOptions &overrides)
{
    command.option_defaults()->group("Campaign");
    command.add_option("--out", arguments.out, "Folder for the files; made if it is not there")
        ->required()
        ->type_name("DIR");
    command
        .add_option("--runs", arguments.runs,
                    "Number of runs (default: the plan's, else " + std::to_string(kUsualRuns) + ")")
        ->type_name("N");
    addSeedOption(command, arguments.seed);
    command
        .add_option("--sensor", arguments.sensor,
                    "Gyro whose figures are the defaults below: " + oneOf(kSensorNames) +
                        " (default: the plan's, else " + std::string(kSensorNames.front()) + ")")
        ->type_name("NAME");
    overrides.add("--serial", "NAME", &SimulationOptions::sensor, &SensorIdentity::serial,
                  "Serial number written into the files");
}

void addChamberOptions(CLI::App &command, SimulateArguments &arguments, OverrideOptions &overrides)
{
    command.option_defaults()->group("Temperature");
    CLI::Option *plan =
        command.add_option("--plan", arguments.plan, "Plan to follow, as driftbench-cli plan writes it")
            ->type_name("FILE");
    command
        .add_option("--profile", arguments.profile,
                    "Temperature profile: " + oneOf(kProfileNames) + " (default: paper)")
        ->type_name("NAME")
        ->excludes(plan);
    const auto chamber = &SimulationOptions::chamber;
    overrides.add("--chamber-lag", "S", chamber, &ChamberOptions::lagS,
                  "Lag of the air behind the set-point in s");
    overrides.add("--chamber-dead-time", "S", chamber, &ChamberOptions::deadTimeS,
                  "Time in s until a new set-point reaches the air");
    overrides.add("--thermometer-noise", "C", chamber, &ChamberOptions::thermometerNoiseC,
                  "Standard deviation of the thermometer in C");
    command.add_flag("--stairs", arguments.stairs, "Log the temperature in whole degrees");
}

void addDriftOptions(CLI::App &command, SimulateArguments &arguments, OverrideOptions &overrides)
{
    command.option_defaults()->group("Drift");
    command
        .add_option("--truth", arguments.truth,
                    "Drift curve: " + std::string(kCombDriftName) + " (that of the sensor's combs), " +
                        oneOf(kDriftCurveNames))
        ->type_name("NAME")
        ->capture_default_str();
    addReferenceRateOption(command, arguments.referenceRateDps);
    const auto gyro = &SimulationOptions::gyro;
    overrides.add("--spread", "FRACTION", gyro, &GyroOptions::spread,
                  "Relative standard deviation of the curve between runs");
    overrides.add("--turn-on", "DPS", gyro, &GyroOptions::turnOnBiasDps,
                  "Standard deviation of the turn-on bias in dps");
    overrides.add("--lag", "S", gyro, &GyroOptions::packageLagS,
                  "Lag of the die behind the thermometer in s");
    overrides.add("--hysteresis", "DPS", gyro, &GyroOptions::hysteresisDps, "Heating minus cooling in dps");
    overrides.add("--hysteresis-play", "C", gyro, &GyroOptions::hysteresisPlayC,
                  "Half the way back in C after which the other branch is reached");
}

void addOutputOptions(CLI::App &command, OverrideOptions &overrides)
{
    command.option_defaults()->group("Noise and output");
    const auto gyro = &SimulationOptions::gyro;
    overrides.add("--rate", "HZ", gyro, &GyroOptions::sampleRateHz, "Samples per second");
    overrides.add("--noise", "DPS", gyro, &GyroOptions::noiseDps,
                  "Standard deviation of the white noise in dps");
    overrides.add("--bias-instability", "DPS", gyro, &GyroOptions::biasInstabilityDps,
                  "Coefficient of the flicker noise in dps; 0: none");
    overrides.add("--random-walk", "DPS", gyro, &GyroOptions::rateRandomWalkDpsPerRootS,
                  "Coefficient of the rate random walk in dps/sqrt(s); 0: none");
    overrides.add("--sensitivity", "MDPS", gyro, &GyroOptions::sensitivityMdps,
                  "mdps of one count; 0: not rounded to counts");
    overrides.add("--range", "DPS", gyro, &GyroOptions::rangeDps, "Rate at which the gyro saturates in dps");
}

void addFaultOptions(CLI::App &command, OverrideOptions &overrides)
{
    command.option_defaults()->group("Faults");
    const auto faults = &SimulationOptions::faults;
    overrides.add("--steps", "N", faults, &FaultOptions::biasSteps, "Number of bias steps in a run");
    overrides.add("--step-size", "DPS", faults, &FaultOptions::biasStepDps, "Size of a bias step in dps");
    overrides.add("--motion", "N", faults, &FaultOptions::motionBursts,
                  "Number of times the gyro is moved in a run");
    overrides.add("--gaps", "N", faults, &FaultOptions::gaps, "Number of gaps in a run");
    overrides.add("--outliers", "FRACTION", faults, &FaultOptions::outlierFraction,
                  "Fraction of samples that are off by 3 dps");
    overrides.add("--nan", "FRACTION", faults, &FaultOptions::nonFiniteFraction,
                  "Fraction of samples whose rates are NaN");
}

} // namespace

void addSimulateCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<SimulateArguments>();
    CLI::App *command =
        addCommand(program, "simulate",
                   "Simulates runs of a gyro in a temperature chamber: run1.csv ... and truth.json with the "
                   "true curves. "
                   "Files of the same name are replaced, all together or none.",
                   "driftbench-cli simulate --out campaign --runs 5 --reference-rate 25,5,53");
    OverrideOptions overrides(*command, arguments->overrides);
    addCampaignOptions(*command, *arguments, overrides);
    addJsonOption(*command, arguments->json);
    addChamberOptions(*command, *arguments, overrides);
    addDriftOptions(*command, *arguments, overrides);
    addOutputOptions(*command, overrides);
    addFaultOptions(*command, overrides);
    command->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return simulate(*arguments); }; });
}

} // namespace driftbench::cli
