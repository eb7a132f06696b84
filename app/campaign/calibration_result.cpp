#include "app/campaign/calibration_result.h"

#include <algorithm>
#include <cassert>

namespace driftbench {

namespace {

const TrainedModel *named(const std::vector<TrainedModel> &models, const std::string &name)
{
    const auto found = std::find_if(models.begin(), models.end(),
                                    [&name](const TrainedModel &model) { return model.name == name; });
    return found == models.end() ? nullptr : &*found;
}

// What the fold's model has besides its parameters is the same as for the model of all runs, but for the
// runs.
TrainedModel heldOutModel(const Comparison &comparison, const Fold &fold, std::size_t index)
{
    TrainedModel model = comparison.models[index];
    model.model = fold.models[index].model;
    model.summary = fold.models[index].summary;
    model.trainedOn = fold.trainedOn;
    const DeltaTRange range = trainedRange(fold.training);
    model.lowestTemperatureC = model.referenceTemperatureC + range.lowest;
    model.highestTemperatureC = model.referenceTemperatureC + range.highest;
    model.band.reset();
    return model;
}

} // namespace

const TrainedModel *CalibrationResult::model(const std::string &name) const
{
    return named(models, name);
}

const TrainedModel *CalibrationResult::heldOutModel(const std::string &fold, const std::string &name) const
{
    const auto found = std::find_if(heldOut.begin(), heldOut.end(),
                                    [&fold](const HeldOutModels &each) { return each.fold == fold; });
    return found == heldOut.end() ? nullptr : named(found->models, name);
}

CampaignSummary summaryOf(const LoadedCampaign &loaded)
{
    CampaignSummary summary;
    summary.sensor = loaded.campaign.sensor;
    summary.referenceTemperatureC = loaded.features.referenceTemperatureC;
    for (const Run &run : loaded.campaign.runs)
        summary.runs.push_back(factsOf(run));
    return summary;
}

std::vector<HeldOutModels> heldOutModels(const Comparison &comparison)
{
    std::vector<HeldOutModels> all;
    for (const Fold &fold : comparison.folds) {
        HeldOutModels &ofFold = all.emplace_back(HeldOutModels{fold.name, {}});
        for (std::size_t i = 0; i < fold.models.size(); ++i)
            ofFold.models.push_back(heldOutModel(comparison, fold, i));
    }
    return all;
}

CalibrationResult resultOf(const Comparison &comparison, const CampaignSummary &campaign)
{
    auto result = resultFrom(comparisonToJson(comparison, campaign), recommendationToJson(comparison),
                             comparison.models, heldOutModels(comparison));
    assert(result && "what was just written can be read");
    return *std::move(result);
}

Result<CalibrationResult> resultFrom(const std::string &comparisonJson, const std::string &recommendationJson,
                                     std::vector<TrainedModel> models, std::vector<HeldOutModels> heldOut)
{
    auto figures = comparisonFromJson(comparisonJson, "The stored comparison");
    if (!figures)
        return figures.error();
    return CalibrationResult{*std::move(figures), std::move(models), std::move(heldOut), {},
                             comparisonJson,      recommendationJson};
}

} // namespace driftbench
