// The runs of a session as fit and evaluate take them, in place of logs.
#pragma once

#include "app/campaign/campaign_request.h"
#include "app/session/session.h"
#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/evaluation/comparison.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace driftbench::cli {

// The session that is named in place of logs; nothing: these are logs. InvalidOption if both are named.
Result<std::optional<std::filesystem::path>> sessionAmong(const std::vector<std::filesystem::path> &files);

// What the command line says about a calibration; what it does not say is as the session has it.
struct PlanOverrides
{
    std::optional<ReferenceRateKind> referenceRate;
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    std::optional<double> referenceTemperatureC;
    QualityOptions quality; // set flags and excluded ranges count; the ranges are of every run's time
    std::optional<std::vector<std::string>> models;
    std::optional<std::vector<std::string>> holdOut; // names of runs
    std::optional<Judging> judging;
    std::optional<std::uint64_t> seed;
};

// NoSuchRun where a run is to be held out that the session does not have.
Result<CalibrationPlan> overridden(const Session &session, const PlanOverrides &overrides);

// The campaign of that plan. Errors: reading, the refusal of a run.
Result<PreparedCampaign> prepareSession(const Session &session, const CalibrationPlan &plan,
                                        const ProgressHook &hook);

} // namespace driftbench::cli
