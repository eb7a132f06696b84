#include "app/campaign/campaign_request.h"

#include "engine/base/parallel_for.h"
#include "engine/formats/log_reader.h"
#include "engine/recording/block_means.h"

#include <algorithm>

namespace driftbench {

namespace {

// The error of one run among several says which file it is about.
Error about(const std::filesystem::path &file, Error error)
{
    if (error.message.find(file.filename().string()) == std::string::npos)
        error.message = file.string() + ": " + error.message;
    return error;
}

Result<Run> loadRun(const CampaignRequest &request, std::size_t index)
{
    const std::filesystem::path &file = request.files[index];
    auto recording = readStatedLog(file, request.read, request.sensor);
    if (!recording)
        return recording.error();
    QualityOptions quality = request.quality;
    quality.name.clear();
    auto run = prepareRun(shortened(*std::move(recording)), quality);
    if (!run)
        return about(file, run.error());
    return run;
}

} // namespace

Result<SensorIdentity> statedSensor(const std::filesystem::path &file, const SensorIdentity &measured,
                                    const SensorIdentity &stated)
{
    if (measured.contradicts(stated)) {
        return Error{Errc::DifferentSensors, file.string() + " was measured by " + measured.text() +
                                                 ", not by " + stated.text() +
                                                 "; leave the file out or correct --sensor."};
    }
    return SensorIdentity{stated.model.empty() ? measured.model : stated.model,
                          stated.serial.empty() ? measured.serial : stated.serial};
}

Result<Recording> readStatedLog(const std::filesystem::path &file, const ReadOptions &read,
                                const SensorIdentity &stated, const ProgressHook &hook)
{
    auto recording = readLog(file, read, hook);
    if (!recording)
        return recording;
    auto sensor = statedSensor(file, recording->info.sensor, stated);
    if (!sensor)
        return sensor.error();
    recording->info.sensor = *std::move(sensor);
    return recording;
}

Result<LoadedCampaign> loadCampaign(const CampaignRequest &request, const ProgressHook &hook)
{
    // Files are read side by side; each call writes its own slot.
    std::vector<std::optional<Result<Run>>> loaded(request.files.size());
    if (report(hook, "Reading the logs", 0.0) == Flow::Stop)
        return Error{Errc::Cancelled, "Reading was stopped."};
    parallelFor(request.files.size(), 0, [&](std::size_t i) { loaded[i] = loadRun(request, i); });
    std::vector<Run> runs;
    for (auto &run : loaded) {
        if (!*run)
            return run->error();
        runs.push_back(**std::move(run));
    }
    return gatherCampaign(std::move(runs), request.campaign, request.referenceTemperatureC);
}

Result<LoadedCampaign> gatherCampaign(std::vector<Run> runs, const CampaignOptions &options,
                                      std::optional<double> referenceTemperatureC)
{
    auto campaign = makeCampaign(std::move(runs), options);
    if (!campaign)
        return campaign.error();
    LoadedCampaign result;
    result.campaign = *std::move(campaign);
    const double reference = chooseReferenceTemperature(result.campaign, referenceTemperatureC);
    result.features = makeTrainingSet(result.campaign, reference);
    result.simulated = std::any_of(result.campaign.runs.begin(), result.campaign.runs.end(),
                                   [](const Run &run) { return run.recording->info.simulated; });
    return result;
}

} // namespace driftbench
