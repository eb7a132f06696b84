#include "app/campaign/paper_experiments.h"

#include "engine/base/parallel_for.h"
#include "engine/evaluation/comparison.h"
#include "engine/evaluation/paper_improvements.h"
#include "engine/physics/gyro_simulator.h"
#include "engine/physics/sensor_presets.h"
#include "engine/recording/campaign.h"
#include "engine/recording/quality.h"

#include <cassert>
#include <optional>

namespace driftbench {

namespace {

constexpr double kSimulationShare = 0.2; // of the time

std::string runName(int run)
{
    return "run " + std::to_string(run + 1);
}

Result<Run> simulatedRun(const SimulationOptions &options, int run)
{
    auto recording = simulateRun(options, run);
    if (!recording)
        return recording.error();
    QualityOptions quality;
    quality.name = runName(run);
    return prepareRun(*std::move(recording), quality);
}

Result<Campaign> simulatedCampaign(const SimulationOptions &options)
{
    // Runs are simulated side by side; each call writes its own slot.
    std::vector<std::optional<Result<Run>>> simulated(kPaperRuns);
    parallelFor(simulated.size(), 0,
                [&](std::size_t i) { simulated[i] = simulatedRun(options, static_cast<int>(i)); });
    std::vector<Run> runs;
    for (auto &run : simulated) {
        if (!*run)
            return run->error();
        runs.push_back(**std::move(run));
    }
    CampaignOptions campaign;
    campaign.referenceRateDps = options.gyro.referenceRateDps;
    return makeCampaign(std::move(runs), campaign);
}

ProgressHook afterSimulation(const ProgressHook &hook)
{
    return [&hook](const Progress &part) {
        return report(hook, part.stage, kSimulationShare + (1.0 - kSimulationShare) * part.fraction);
    };
}

} // namespace

const std::vector<PaperExperiment> &paperExperiments()
{
    static const std::vector<PaperExperiment> experiments{
        {"L3GD20H", {0.0, 0.0, 0.0}, 1, 1}, {"I3G4250D", {25.0, 5.0, 53.0}, 2, kPaperTableCount}};
    return experiments;
}

std::vector<std::string> paperModelNames()
{
    std::vector<std::string> names{std::string(kConventional1Model), std::string(kConventional2Model)};
    names.insert(names.end(), kNovelModels.begin(), kNovelModels.end());
    return names;
}

MsdByRole PaperExperimentOutcome::msds(int run, int axis, std::string_view novel) const
{
    const PaperModels models{std::string(kConventional1Model), std::string(kConventional2Model),
                             std::string(novel)};
    for (const PaperRow &row : paperImprovements(rows, models)) {
        if (row.run == runName(run) && row.axis == axis)
            return {row.msd1, row.msd4, row.msd5, row.msd6};
    }
    assert(false && "no such run or axis");
    return {};
}

Result<PaperExperimentOutcome> runPaperExperiment(const PaperExperiment &experiment, std::uint64_t seed,
                                                  const ProgressHook &hook)
{
    auto simulation = presetSimulation(experiment.sensor, experiment.referenceRateDps);
    if (!simulation)
        return simulation.error();
    simulation->seed = seed;
    if (report(hook, "Simulating the " + experiment.sensor, 0.0) == Flow::Stop)
        return Error{Errc::Cancelled, "The experiment was stopped before it was done; nothing was written."};
    const auto campaign = simulatedCampaign(*simulation);
    if (!campaign)
        return campaign.error();
    const double referenceC = chooseReferenceTemperature(*campaign, std::nullopt);
    ComparisonOptions options;
    options.models = paperModelNames();
    options.seed = seed;
    auto comparison = compareModels(makeTrainingSet(*campaign, referenceC), {campaign->sensor, true}, options,
                                    afterSimulation(hook));
    if (!comparison)
        return comparison.error();
    return PaperExperimentOutcome{experiment, seed, std::move(comparison->rows),
                                  std::move(comparison->warnings)};
}

} // namespace driftbench
