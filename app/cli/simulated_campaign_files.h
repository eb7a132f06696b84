// The files of a simulated campaign:
//   run1.csv ...            the samples, as any CSV reader opens them
//   run1.csv.meta.json ...  what a CSV can't say: sensor, that it is simulated, reference rate
//   truth.json              seed, options, and per axis the true curve every 0.1 C, of the campaign and of
//   each
//                           run, with the times of what went wrong in it; the combs, if they make the drift
// All are written beside their targets first and put in place together at the end, so that an error or a
// cancel leaves the folder as it was.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/physics/simulation_options.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace driftbench::cli {

inline constexpr int kMostSimulatedRuns = 200;

struct SimulatedRunFile
{
    std::filesystem::path path;
    std::int64_t samples = 0;
};

struct SimulatedCampaignFiles
{
    std::vector<SimulatedRunFile> runs;
    std::filesystem::path truth;
};

Result<SimulatedCampaignFiles> writeSimulatedCampaign(const SimulationOptions &options, int runs,
                                                      const std::filesystem::path &folder,
                                                      const ProgressHook &hook);

} // namespace driftbench::cli
