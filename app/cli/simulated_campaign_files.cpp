#include "app/cli/simulated_campaign_files.h"

#include "app/cli/output_folder.h"
#include "app/cli/pending_files.h"
#include "engine/base/axes.h"
#include "engine/formats/csv_writer.h"
#include "engine/formats/sidecar.h"
#include "engine/physics/gyro_simulator.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kTruthStepsPerC = 10.0;
constexpr Eigen::Index kBlockRows = 8192;

Json triple(const Eigen::Vector3d &value)
{
    return {value[0], value[1], value[2]};
}

// On multiples of 0.1 C within the range, and at its ends.
std::vector<double> truthTemperaturesC(const DriftTable &table)
{
    std::vector<double> temperaturesC{table.lowestC()};
    for (double tenth = std::floor(table.lowestC() * kTruthStepsPerC) + 1.0;
         tenth / kTruthStepsPerC < table.highestC(); ++tenth)
        temperaturesC.push_back(tenth / kTruthStepsPerC);
    if (table.highestC() > table.lowestC())
        temperaturesC.push_back(table.highestC());
    return temperaturesC;
}

Json curveJson(const DriftTable &table, const std::vector<double> &temperaturesC)
{
    std::array<std::vector<double>, kAxisCount> curves;
    for (const double temperatureC : temperaturesC) {
        const Eigen::Vector3d rateDps = table.rateDps(temperatureC);
        for (int axis = 0; axis < kAxisCount; ++axis)
            curves[axis].push_back(rateDps[axis]);
    }
    Json json;
    for (int axis = 0; axis < kAxisCount; ++axis)
        json[std::string(kAxisNames[axis])] = curves[axis];
    return json;
}

Json optionsJson(const SimulationOptions &options)
{
    const auto &[chamber, gyro, faults] = std::tie(options.chamber, options.gyro, options.faults);
    return {{"profile", options.profile.name()},
            {"truth", options.truth.name},
            {"chamber_lag_s", chamber.lagS},
            {"chamber_dead_time_s", chamber.deadTimeS},
            {"thermometer_noise_C", chamber.thermometerNoiseC},
            {"thermometer_counts_per_C", chamber.thermometerCountsPerC},
            {"sample_rate_hz", gyro.sampleRateHz},
            {"reference_rate_dps", triple(gyro.referenceRateDps)},
            {"noise_dps", gyro.noiseDps},
            {"bias_instability_dps", gyro.biasInstabilityDps},
            {"rate_random_walk_dps_per_root_s", gyro.rateRandomWalkDpsPerRootS},
            {"spread", gyro.spread},
            {"turn_on_bias_dps", gyro.turnOnBiasDps},
            {"package_lag_s", gyro.packageLagS},
            {"hysteresis_dps", gyro.hysteresisDps},
            {"hysteresis_play_C", gyro.hysteresisPlayC},
            {"sensitivity_mdps", gyro.sensitivityMdps},
            {"range_dps", gyro.rangeDps},
            {"bias_steps", faults.biasSteps},
            {"bias_step_dps", faults.biasStepDps},
            {"motion_bursts", faults.motionBursts},
            {"gaps", faults.gaps},
            {"outlier_fraction", faults.outlierFraction},
            {"non_finite_fraction", faults.nonFiniteFraction}};
}

Json combsJson(const CombAxis &axis)
{
    const auto &[material, geometry, straightAtC] = axis.combs;
    return {{"expansion_per_C", material.expansionPerC},
            {"elastic_modulus_GPa", material.elasticModulusGPa},
            {"poisson_ratio", material.poissonRatio},
            {"thickness_um", geometry.thicknessUm},
            {"overlap_length_um", geometry.overlapLengthUm},
            {"overlap_width_um", geometry.overlapWidthUm},
            {"gap_um", geometry.gapUm},
            {"gap_count", geometry.gapCount},
            {"relative_permittivity", geometry.relativePermittivity},
            {"straight_at_C", straightAtC},
            {"rest_dps", axis.restDps},
            {"package_step_dps", axis.package.stepDps},
            {"package_step_at_C", axis.package.stepAtC},
            {"package_step_width_C", axis.package.stepWidthC}};
}

Json combsJson(const CombDrift &drift)
{
    Json json{{"displacement_per_dps_um", drift.displacementPerDpsUm}};
    for (int axis = 0; axis < kAxisCount; ++axis)
        json[std::string(kAxisNames[axis])] = combsJson(drift.axes[axis]);
    return json;
}

Json sensorJson(const SensorIdentity &sensor)
{
    return {{"model", sensor.model}, {"serial", sensor.serial}};
}

Json runTruthJson(const GyroSimulator &simulator, const std::string &fileName,
                  const std::vector<double> &temperaturesC)
{
    Json steps = Json::array();
    for (const BiasStep &step : simulator.events().biasSteps)
        steps.push_back({{"time_s", step.timeS}, {"step_dps", triple(step.stepDps)}});
    Json motion = Json::array();
    for (const MotionBurst &burst : simulator.events().motionBursts)
        motion.push_back({{"start_s", burst.startS}, {"end_s", burst.endS}});
    Json gaps = Json::array();
    for (const Gap &gap : simulator.events().gaps)
        gaps.push_back({{"start_s", gap.startS}, {"end_s", gap.endS}});
    return {{"file", fileName},
            {"curve_dps", curveJson(simulator.truth(), temperaturesC)},
            {"bias_steps", steps},
            {"motion", motion},
            {"gaps", gaps}};
}

std::string fileText(const Json &json)
{
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

// The samples of a run to its file; how many there were.
Result<std::int64_t> writeSamples(GyroSimulator &simulator, CsvWriter &file, const ProgressHook &hook)
{
    SampleBlock block = SampleBlock::withRows(kBlockRows);
    std::int64_t samples = 0;
    while (const Eigen::Index count = simulator.fill(block)) {
        if (const Status written = file.write(block, count); !written)
            return written.error();
        samples += count;
        if (report(hook, "simulating", simulator.fractionDone()) == Flow::Stop)
            return Error{Errc::Cancelled, "The simulation was cancelled; no file was written."};
    }
    return samples;
}

// The progress of one run as part of that of all.
ProgressHook partOf(const ProgressHook &hook, int run, int runs)
{
    if (!hook)
        return {};
    const std::string stage = "simulating run " + std::to_string(run + 1) + " of " + std::to_string(runs);
    return [&hook, stage, run, runs](const Progress &progress) {
        return hook({stage, (run + progress.fraction) / runs});
    };
}

class CampaignWriter
{
public:
    CampaignWriter(const SimulationOptions &options, std::filesystem::path folder)
        : m_options(options)
        , m_folder(std::move(folder))
        , m_campaign(campaignTruth(options))
        , m_temperaturesC(truthTemperaturesC(m_campaign))
    {
        m_written.truth = m_folder / "truth.json";
    }

    Status addRun(int run, const ProgressHook &hook)
    {
        const std::string name = "run" + std::to_string(run + 1) + ".csv";
        auto simulator = GyroSimulator::create(m_options, run);
        if (!simulator)
            return simulator.error();
        auto file = CsvWriter::create(m_folder / name);
        if (!file)
            return file.error();
        const auto samples = writeSamples(*simulator, *file, hook);
        if (!samples)
            return samples.error();
        if (const Status added = m_pending.add(*std::move(file)); !added)
            return added;
        m_written.runs.push_back({m_folder / name, *samples});
        m_runTruths.push_back(runTruthJson(*simulator, name, m_temperaturesC));
        RecordingInfo info;
        info.sensor = m_options.sensor;
        info.simulated = true;
        return m_pending.add(sidecarPath(m_folder / name),
                             sidecarText(info, m_options.gyro.referenceRateDps));
    }

    Result<SimulatedCampaignFiles> finish()
    {
        Json truth{{"simulated", true},
                   {"seed", m_options.seed},
                   {"sensor", sensorJson(m_options.sensor)},
                   {"options", optionsJson(m_options)},
                   {"temperature_C", m_temperaturesC},
                   {"curve_dps", curveJson(m_campaign, m_temperaturesC)},
                   {"runs", m_runTruths}};
        if (m_options.combs)
            truth["combs"] = combsJson(*m_options.combs);
        if (const Status ok = m_pending.add(m_written.truth, fileText(truth)); !ok)
            return ok.error();
        if (const Status ok = m_pending.commit(); !ok)
            return ok.error();
        return m_written;
    }

private:
    const SimulationOptions &m_options;
    std::filesystem::path m_folder;
    DriftTable m_campaign;
    std::vector<double> m_temperaturesC;
    PendingFiles m_pending;
    Json m_runTruths = Json::array();
    SimulatedCampaignFiles m_written;
};

} // namespace

Result<SimulatedCampaignFiles> writeSimulatedCampaign(const SimulationOptions &options, int runs,
                                                      const std::filesystem::path &folder,
                                                      const ProgressHook &hook)
{
    if (runs < 1 || runs > kMostSimulatedRuns)
        return Error{Errc::InvalidOption, "The number of runs is " + std::to_string(runs) + "; give 1 to " +
                                              std::to_string(kMostSimulatedRuns) + "."};
    if (const Status ok = checkOptions(options); !ok)
        return ok.error();
    OutputFolders folders;
    if (const Status ok = folders.make(folder); !ok)
        return ok.error();
    CampaignWriter writer(options, folder);
    for (int run = 0; run < runs; ++run) {
        if (const Status ok = writer.addRun(run, partOf(hook, run, runs)); !ok)
            return ok.error();
    }
    auto written = writer.finish();
    if (written)
        folders.keep();
    return written;
}

} // namespace driftbench::cli
