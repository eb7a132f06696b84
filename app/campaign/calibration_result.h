// What a calibration found, as one value: the figures of the comparison, the models, and those that were
// trained without a run. It is the same whether it was just computed or read back from where it was kept, as
// both go through the text of comparison.json.
#pragma once

#include "app/campaign/campaign_request.h"
#include "engine/evaluation/comparison.h"
#include "engine/exports/comparison_files.h"
#include "engine/exports/comparison_reader.h"

#include <map>
#include <string>
#include <vector>

namespace driftbench {

// Trained without the run (or block) that it is named after.
struct HeldOutModels
{
    std::string fold;
    std::vector<TrainedModel> models; // as the comparison's, without "auto"
};

struct CalibrationResult
{
    ReadComparison figures;
    std::vector<TrainedModel> models;        // "auto" last
    std::vector<HeldOutModels> heldOut;      // by fold
    std::map<std::string, double> trainingS; // by model: what its training took, where that is known
    std::string comparisonJson;              // comparisonToJson
    std::string recommendationJson;

    const TrainedModel *model(const std::string &name) const; // null: there is none
    // Null: there is none.
    const TrainedModel *heldOutModel(const std::string &fold, const std::string &name) const;
};

CampaignSummary summaryOf(const LoadedCampaign &loaded);
std::vector<HeldOutModels> heldOutModels(const Comparison &comparison);
CalibrationResult resultOf(const Comparison &comparison, const CampaignSummary &campaign);
// Errors of comparisonFromJson.
Result<CalibrationResult> resultFrom(const std::string &comparisonJson, const std::string &recommendationJson,
                                     std::vector<TrainedModel> models, std::vector<HeldOutModels> heldOut);

} // namespace driftbench
