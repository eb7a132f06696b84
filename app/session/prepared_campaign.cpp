#include "app/session/prepared_campaign.h"

#include "engine/base/parallel_for.h"
#include "engine/recording/block_means.h"

#include <algorithm>

namespace driftbench {

namespace {

QualityOptions qualityFor(const CalibrationPlan &plan, const LoadedRun &run)
{
    QualityOptions quality = plan.quality;
    quality.name = run.record.description.name;
    quality.excluded.clear();
    if (const RunInPlan *inPlan = plan.find(run.record.id)) {
        for (const Exclusion &excluded : inPlan->excluded)
            quality.excluded.push_back(excluded.range);
    }
    return quality;
}

CheckedRun checked(const CalibrationPlan &plan, const LoadedRun &run)
{
    CheckedRun result = checkRun(*run.recording, qualityFor(plan, run));
    if (const RunInPlan *inPlan = plan.find(run.record.id))
        result.run.referenceRateDps = inPlan->referenceRateDps;
    return result;
}

Error about(const std::string &run, Error error)
{
    if (error.message.find(run) == std::string::npos)
        error.message = run + ": " + error.message;
    return error;
}

void gather(PreparedCampaign &prepared)
{
    std::vector<Run> runs;
    for (const PreparedRun &run : prepared.runs) {
        if (run.checked.refusal) {
            prepared.refusal = about(run.checked.run.name, *run.checked.refusal);
            return;
        }
        runs.push_back(run.checked.run);
    }
    CampaignOptions options;
    options.referenceRate =
        prepared.plan.referenceFromHold ? ReferenceRateKind::InitialHold : ReferenceRateKind::OfEachRun;
    auto loaded = gatherCampaign(std::move(runs), options, prepared.plan.referenceTemperatureC);
    if (loaded)
        prepared.loaded = *std::move(loaded);
    else
        prepared.refusal = loaded.error();
}

} // namespace

const PreparedRun *PreparedCampaign::find(RunId run) const
{
    const auto found =
        std::find_if(runs.begin(), runs.end(), [run](const PreparedRun &each) { return each.id == run; });
    return found == runs.end() ? nullptr : &*found;
}

Result<std::vector<LoadedRun>> loadRuns(const SessionFile &file, const CalibrationPlan &plan,
                                        const std::vector<LoadedRun> &known, const ProgressHook &hook)
{
    std::vector<LoadedRun> loaded;
    for (const RunInPlan &run : plan.runs) {
        if (!run.takesPart)
            continue;
        const auto there = std::find_if(known.begin(), known.end(), [&run](const LoadedRun &each) {
            return each.record.id == run.run && each.recording;
        });
        if (there != known.end()) {
            loaded.push_back(*there);
            continue;
        }
        auto record = file.run(run.run);
        if (!record)
            return record.error();
        auto recording = file.readRun(run.run, {.mostPoints = kMostPoints}, hook);
        if (!recording)
            return recording.error();
        loaded.push_back({*std::move(record), std::make_shared<const Recording>(*std::move(recording))});
    }
    return loaded;
}

Result<PreparedCampaign> prepareCampaign(const CalibrationPlan &plan, const std::vector<LoadedRun> &runs,
                                         const ProgressHook &hook)
{
    const Error stopped{Errc::Cancelled, "Checking the runs was stopped."};
    if (report(hook, "Checking the runs", 0.0) == Flow::Stop)
        return stopped;
    PreparedCampaign prepared;
    prepared.plan = plan;
    prepared.runs.resize(runs.size());
    parallelFor(runs.size(), 0, [&](std::size_t i) {
        prepared.runs[i] = {runs[i].record.id, checked(plan, runs[i])};
    });
    if (report(hook, "Checking the runs", 0.9) == Flow::Stop)
        return stopped;
    gather(prepared);
    return prepared;
}

Result<ComparisonOptions> comparisonOptions(const PreparedCampaign &prepared)
{
    const CalibrationPlan &plan = prepared.plan;
    ComparisonOptions options;
    options.models = plan.models;
    options.judging = plan.judging;
    options.seed = plan.seed;
    options.rbf = plan.rbf;
    options.bp = plan.bp;
    for (const RunId run : plan.holdOut) {
        const PreparedRun *heldOut = prepared.find(run);
        if (!heldOut)
            return Error{
                Errc::InvalidOption,
                "A run is to be held out that does not take part; let it take part, or hold out another."};
        options.holdOut.push_back(heldOut->checked.run.name);
    }
    return options;
}

Result<CalibrationResult> calibrate(const PreparedCampaign &prepared, const ProgressHook &hook,
                                    const std::function<void(const std::string &, double)> &onModelTrained)
{
    if (prepared.refusal)
        return *prepared.refusal;
    auto options = comparisonOptions(prepared);
    if (!options)
        return options.error();
    std::map<std::string, double> trainingS;
    options->keepFinished = true;
    options->onModelTrained = [&](const std::string &model, double seconds) {
        trainingS[model] = seconds;
        if (onModelTrained)
            onModelTrained(model, seconds);
    };
    const LoadedCampaign &loaded = prepared.loaded;
    const auto comparison =
        compareModels(loaded.features, {loaded.campaign.sensor, loaded.simulated}, *options, hook);
    if (!comparison)
        return comparison.error();
    CalibrationResult result = resultOf(*comparison, summaryOf(loaded));
    result.trainingS = std::move(trainingS);
    return result;
}

} // namespace driftbench
