#include "app/session/load_job.h"

#include "app/campaign/campaign_request.h"

namespace driftbench {

namespace {

// Reading is the longer half.
constexpr double kReadingShare = 0.7;

Result<RunId> importLog(const LoadInput &input, const std::filesystem::path &path, const ProgressHook &hook)
{
    const auto part = [&hook](double from, double share) -> ProgressHook {
        return [&hook, from, share](const Progress &now) {
            return report(hook, now.stage, from + share * now.fraction);
        };
    };
    auto recording = readStatedLog(path, input.read, input.sensor, part(0.0, kReadingShare));
    if (!recording)
        return recording.error();
    RunDescription description = describeRecording(recording->info, path.stem().string());
    description.referenceRateDps = input.referenceRateDps;
    return input.file->importRun(*recording, std::move(description),
                                 part(kReadingShare, 1.0 - kReadingShare));
}

} // namespace

std::vector<LoadedLog> importLogs(const LoadInput &input, const ProgressHook &hook)
{
    std::vector<LoadedLog> logs;
    const double share = 1.0 / static_cast<double>(input.files.size());
    for (const std::filesystem::path &path : input.files) {
        const double before = share * static_cast<double>(logs.size());
        const ProgressHook ofFile = [&](const Progress &now) {
            return report(hook, "Reading " + path.filename().string(), before + share * now.fraction);
        };
        logs.push_back({path, importLog(input, path, ofFile)});
        if (!logs.back().run && logs.back().run.error().code == Errc::Cancelled)
            break;
    }
    return logs;
}

bool LoadJob::start(LoadInput input)
{
    return run([this, input = std::move(input)](const ProgressHook &hook) -> Deliver {
        return [this, logs = importLogs(input, hook)] { emit finished(logs); };
    });
}

} // namespace driftbench
