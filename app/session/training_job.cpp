#include "app/session/training_job.h"

namespace driftbench {

namespace {

Result<std::shared_ptr<const PreparedCampaign>> preparedFrom(const TrainingInput &input,
                                                             const ProgressHook &hook)
{
    if (input.prepared && computesTheSame(input.prepared->plan, input.plan))
        return input.prepared;
    std::vector<LoadedRun> runs = input.known;
    if (input.file) {
        auto loaded = loadRuns(*input.file, input.plan, input.known, hook);
        if (!loaded)
            return loaded.error();
        runs = *std::move(loaded);
    }
    auto prepared = prepareCampaign(input.plan, runs, hook);
    if (!prepared)
        return prepared.error();
    return std::shared_ptr<const PreparedCampaign>(
        std::make_shared<const PreparedCampaign>(*std::move(prepared)));
}

} // namespace

bool TrainingJob::start(TrainingInput input)
{
    return run([this, input = std::move(input), post = sender()](const ProgressHook &hook) -> Deliver {
        const auto campaign = preparedFrom(input, hook);
        if (!campaign)
            return [this, error = campaign.error()] { emit failed(error); };
        if (*campaign != input.prepared)
            post.post([this, made = *campaign] { emit prepared(made); });
        if (!input.train)
            return {};
        auto result = calibrate(**campaign, hook, [this, &post](const std::string &name, double seconds) {
            post.post(
                [this, name = QString::fromStdString(name), seconds] { emit modelTrained(name, seconds); });
        });
        if (!result)
            return [this, error = result.error()] {
                emit trained(Result<std::shared_ptr<const CalibrationResult>>(error));
            };
        auto shared = std::make_shared<const CalibrationResult>(*std::move(result));
        return [this, shared] { emit trained(Result<std::shared_ptr<const CalibrationResult>>(shared)); };
    });
}

} // namespace driftbench
