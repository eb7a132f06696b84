#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/progress_line.h"
#include "app/cli/simulated_campaign_files.h"

#include <memory>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

struct SimulateArguments
{
    std::string out;
    int runs = 5;
    std::uint64_t seed = 1;
    std::string profile = "paper";
    std::string truth = "curved";
    ChamberOptions chamber;
    GyroOptions gyro;
    FaultOptions faults;
    SensorIdentity sensor{"I3G4250D", "SIM-0001"};
    bool stairs = false;
    bool json = false;
};

Result<SimulationOptions> simulationOptions(const SimulateArguments &arguments)
{
    auto profile = TemperatureProfile::named(arguments.profile);
    if (!profile)
        return profile.error();
    auto truth = namedDriftCurves(arguments.truth);
    if (!truth)
        return truth.error();
    SimulationOptions options{*std::move(profile), *std::move(truth), arguments.chamber, arguments.gyro,
                              arguments.faults,    arguments.sensor,  arguments.seed};
    if (arguments.stairs)
        options.chamber.thermometerCountsPerC = 1.0;
    return options;
}

Status printFiles(const SimulateArguments &arguments, const SimulatedCampaignFiles &files)
{
    if (arguments.json) {
        nlohmann::ordered_json runs = nlohmann::ordered_json::array();
        for (const auto &[path, samples] : files.runs)
            runs.push_back({{"file", path.string()}, {"samples", samples}});
        return printJson(nlohmann::ordered_json{
            {"simulated", true}, {"seed", arguments.seed}, {"runs", runs}, {"truth", files.truth.string()}});
    }
    std::string text = "Simulated " + arguments.sensor.text() + ", profile " + arguments.profile +
                       ", drift " + arguments.truth + ", seed " + std::to_string(arguments.seed) + ":\n";
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
    const auto options = simulationOptions(arguments);
    if (!options)
        return options.error();
    Result<SimulatedCampaignFiles> files = [&] {
        ProgressLine progress;
        return writeSimulatedCampaign(*options, arguments.runs, arguments.out, progress.hook());
    }();
    if (!files)
        return files.error();
    noticeOlderRun(arguments.out, arguments.runs);
    return printFiles(arguments, *files);
}

std::string oneOf(std::span<const std::string_view> names)
{
    std::string text;
    for (const std::string_view name : names)
        text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
}

void addGyroOptions(CLI::App &command, SimulateArguments &arguments)
{
    GyroOptions &gyro = arguments.gyro;
    command.add_option("--truth", arguments.truth, "Drift curve: " + oneOf(kDriftCurveNames))
        ->type_name("NAME");
    command.add_option("--spread", gyro.spread, "Relative standard deviation of the curve between runs")
        ->type_name("FRACTION");
    command.add_option("--turn-on", gyro.turnOnBiasDps, "Standard deviation of the turn-on bias in dps")
        ->type_name("DPS");
    command.add_option("--noise", gyro.noiseDps, "Standard deviation of the white noise in dps")
        ->type_name("DPS");
    addReferenceRateOption(command, gyro.referenceRateDps);
    command.add_option("--rate", gyro.sampleRateHz, "Samples per second")->type_name("HZ");
    command.add_option("--lag", gyro.packageLagS, "Lag of the die behind the thermometer in s")
        ->type_name("S");
    command.add_option("--hysteresis", gyro.hysteresisDps, "Heating minus cooling in dps")->type_name("DPS");
    command.add_option("--sensor", arguments.sensor.model, "Model written into the files")->type_name("NAME");
    command.add_option("--serial", arguments.sensor.serial, "Serial number written into the files")
        ->type_name("NAME");
}

void addChamberOptions(CLI::App &command, SimulateArguments &arguments)
{
    command.add_option("--profile", arguments.profile, "Temperature profile: " + oneOf(kProfileNames))
        ->type_name("NAME");
    command.add_option("--chamber-lag", arguments.chamber.lagS, "Lag of the air behind the set-point in s")
        ->type_name("S");
    command.add_flag("--stairs", arguments.stairs, "Log the temperature in whole degrees");
}

void addFaultOptions(CLI::App &command, FaultOptions &faults)
{
    command.add_option("--steps", faults.biasSteps, "Number of bias steps in a run")->type_name("N");
    command.add_option("--motion", faults.motionBursts, "Number of times the gyro is moved in a run")
        ->type_name("N");
    command.add_option("--gaps", faults.gaps, "Number of gaps in a run")->type_name("N");
    command.add_option("--outliers", faults.outlierFraction, "Fraction of samples that are off by 3 dps")
        ->type_name("FRACTION");
    command.add_option("--nan", faults.nonFiniteFraction, "Fraction of samples whose rates are NaN")
        ->type_name("FRACTION");
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
    command->option_defaults()->always_capture_default();
    command->add_option("--out", arguments->out, "Folder for the files; made if it is not there")
        ->required()
        ->type_name("DIR");
    command->add_option("--runs", arguments->runs, "Number of runs")->type_name("N");
    addSeedOption(*command, arguments->seed);
    addChamberOptions(*command, *arguments);
    addGyroOptions(*command, *arguments);
    addFaultOptions(*command, arguments->faults);
    addJsonOption(*command, arguments->json);
    command->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return simulate(*arguments); }; });
}

} // namespace driftbench::cli
