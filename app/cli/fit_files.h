// What a fit leaves in its folder:
//   comparison.json, .csv, .md, recommendation.json, .txt    (engine/exports/comparison_files.h)
//   models/<name>.json               trained on all runs that were not explicitly held out
//   held-out/<run>/<name>.json       trained without that run or block: what the comparison's figures are of
//   request.json                     which runs and how they were read (app/campaign/campaign_request.h)
// All are put in place together. Models of an earlier fit in the same folder that this one did not train are
// removed: beside its comparison they would mislead. Nothing else is touched.
#pragma once

#include "engine/base/result.h"
#include "engine/evaluation/comparison.h"
#include "engine/exports/comparison_files.h"

#include <filesystem>
#include <string>
#include <vector>

namespace driftbench::cli {

// Folders below held-out for the folds of these names, each another: the name itself where it can be the name
// of a folder.
std::vector<std::string> heldOutFolders(const std::vector<std::string> &foldNames);

// request: the text of request.json. Errc: OutputNotWritable, OutputFull.
Status writeFitFiles(const std::filesystem::path &folder, const Comparison &comparison,
                     const CampaignSummary &campaign, const std::string &request);

} // namespace driftbench::cli
