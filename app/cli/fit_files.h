// What a fit leaves in its folder:
//   comparison.json, .csv, .md, recommendation.json, .txt    (engine/exports/comparison_files.h)
//   models/<name>.json               trained on all runs that were not explicitly held out
//   held-out/<run>/<name>.json       trained without that run or block: what the comparison's figures are of
//   request.json                     which runs and how they were read (app/campaign/campaign_request.h)
//   dynamic_experiment.json          of `fit --dynamic`
// All are put in place together. What an earlier fit in the same folder left and this one did not is removed:
// beside its comparison they would mislead. Nothing else is touched.
#pragma once

#include "engine/base/result.h"
#include "engine/evaluation/comparison.h"
#include "engine/exports/comparison_files.h"

#include <filesystem>
#include <string>
#include <vector>

namespace driftbench::cli {

inline constexpr const char *kDynamicExperiment = "dynamic_experiment.json";

struct NamedText
{
    std::string name; // of the file
    std::string text;
};

// beside: further files of the folder. Errc: OutputNotWritable, OutputFull.
Status writeFitFiles(const std::filesystem::path &folder, const Comparison &comparison,
                     const CampaignSummary &campaign, const std::vector<NamedText> &beside);

} // namespace driftbench::cli
