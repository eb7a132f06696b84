// A comparison as files: comparison.json and .csv (every figure at full precision), comparison.md (to be
// read, in the layout of the paper's Tables 2 to 6), recommendation.json and .txt (one verdict an axis).
#pragma once

#include "engine/base/result.h"
#include "engine/evaluation/comparison.h"
#include "engine/recording/run.h"

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace driftbench {

// What of a run a reader of the comparison needs to find it and to redo its features.
struct RunFacts
{
    std::string name;
    std::string file; // as the user gave it
    std::string format;
    int instance = 0;
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    Eigen::Index samples = 0;                   // of the recording
    Eigen::Index usable = 0;                    // for judging
    std::map<std::string, Eigen::Index> masked; // samples by reason, only reasons that occur
};
RunFacts factsOf(const Run &run);

struct CampaignSummary
{
    SensorIdentity sensor;
    double referenceTemperatureC = 0.0;
    std::vector<RunFacts> runs;
};

// An array as "rows" in comparison.json.
std::string rowsToJson(const std::vector<ComparisonRow> &rows);
std::string comparisonToJson(const Comparison &comparison, const CampaignSummary &campaign);
std::string comparisonToCsv(const Comparison &comparison);
std::string comparisonToMarkdown(const Comparison &comparison, const CampaignSummary &campaign);
std::string recommendationToJson(const Comparison &comparison);
std::string recommendationToText(const Comparison &comparison);

struct ComparisonFile
{
    std::string name;
    std::string text;
};
// All five, for whoever writes them together with files of its own.
std::vector<ComparisonFile> comparisonFiles(const Comparison &comparison, const CampaignSummary &campaign);

// All five into folder, which is made unless it is there; each file is replaced whole or not at all.
// Errc: OutputNotWritable, OutputFull.
Status writeComparisonFiles(const Comparison &comparison, const CampaignSummary &campaign,
                            const std::filesystem::path &folder);

} // namespace driftbench
