// The runs of a calibration plan made ready for training, by the engine's chain: checkRun, makeCampaign,
// makeTrainingSet; then compared, by compareModels. Refused runs stay in it with what was found, so that they
// can be looked at.
#pragma once

#include "app/campaign/calibration_result.h"
#include "app/campaign/campaign_request.h"
#include "app/session/calibration_plan.h"
#include "app/session/session_file.h"
#include "engine/base/progress.h"
#include "engine/base/result.h"

#include <memory>
#include <optional>
#include <vector>

namespace driftbench {

// A run with its samples; a long one as means of them (block_means.h), so that memory does not depend on it.
struct LoadedRun
{
    RunRecord record;
    std::shared_ptr<const Recording> recording;
};

struct PreparedRun
{
    RunId id = 0;
    CheckedRun checked;
};

struct PreparedCampaign
{
    CalibrationPlan plan;           // by which it was made
    std::vector<PreparedRun> runs;  // those that take part, in the plan's order
    std::optional<Error> refusal{}; // of the first refused run, or of the runs together
    LoadedCampaign loaded{};        // without runs where there is a refusal

    const PreparedRun *find(RunId run) const; // null: it does not take part
};

// The runs that take part; those in `known` are not read again. Errors of SessionFile::readRun.
Result<std::vector<LoadedRun>> loadRuns(const SessionFile &file, const CalibrationPlan &plan,
                                        const std::vector<LoadedRun> &known, const ProgressHook &hook = {});

// runs: those that take part. Cancelled if the hook says Stop; what is wrong with the runs is in the value.
Result<PreparedCampaign> prepareCampaign(const CalibrationPlan &plan, const std::vector<LoadedRun> &runs,
                                         const ProgressHook &hook = {});

// What compareModels gets. InvalidOption where a run is held out that does not take part.
Result<ComparisonOptions> comparisonOptions(const PreparedCampaign &prepared);

// Errors: the refusal of the campaign, those of compareModels. A stop keeps the models that are finished.
Result<CalibrationResult>
calibrate(const PreparedCampaign &prepared, const ProgressHook &hook = {},
          const std::function<void(const std::string &, double)> &onModelTrained = {});

} // namespace driftbench
