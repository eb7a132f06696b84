// What a user asks to be calibrated: files, how to read them, what to accept. The command line fills one from
// its options; `fit` leaves it as request.json in its folder, so that whoever needs the same runs again (the
// report) gets them by the same way.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/features/run_features.h"
#include "engine/formats/read_options.h"
#include "engine/recording/campaign.h"
#include "engine/recording/quality.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct CampaignRequest
{
    std::vector<std::filesystem::path> files;
    ReadOptions read;
    QualityOptions quality; // its name is not used: runs are named after their files
    CampaignOptions campaign;
    std::optional<double> referenceTemperatureC;
    SensorIdentity sensor; // stated by the user, for logs that don't say
};

struct LoadedCampaign
{
    Campaign campaign;
    TrainingSet features;
    bool simulated = false; // any of the runs
};

// Reads and checks the runs and makes their features. The error of a run names its file.
Result<LoadedCampaign> loadCampaign(const CampaignRequest &request, const ProgressHook &hook = {});

// Prepared runs made one campaign with its features. The reference temperature is chosen unless it is given.
Result<LoadedCampaign> gatherCampaign(std::vector<Run> runs, const CampaignOptions &options,
                                      std::optional<double> referenceTemperatureC);

// Who measured, by what the log says and the user stated; DifferentSensors if these contradict each other.
Result<SensorIdentity> statedSensor(const std::filesystem::path &file, const SensorIdentity &measured,
                                    const SensorIdentity &stated);

// Reads one file and says who measured, if the user stated it; DifferentSensors if the log says otherwise.
Result<Recording> readStatedLog(const std::filesystem::path &file, const ReadOptions &read,
                                const SensorIdentity &stated, const ProgressHook &hook = {});

// File names are stored absolute, so that the folder can be used from anywhere.
std::string requestToJson(const CampaignRequest &request);
// Errc::FileNotFound, FileUnreadable, ModelDamaged.
Result<CampaignRequest> loadRequest(const std::filesystem::path &file);

} // namespace driftbench
