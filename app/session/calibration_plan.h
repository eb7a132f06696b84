// What of a session's runs goes into a calibration and how: a plain value, replaced as a whole by every edit
// (plan_history.h). What a run itself says (its samples, its sensor) is not in it.
#pragma once

#include "app/session/session_records.h"
#include "engine/base/result.h"
#include "engine/evaluation/comparison.h"
#include "engine/recording/campaign.h"
#include "engine/recording/quality.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct RunInPlan
{
    RunId run = 0;
    bool takesPart = true;
    std::vector<Exclusion> excluded{}; // in the run's time
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
};

struct CalibrationPlan
{
    std::vector<RunInPlan> runs;                 // one for each of the session's, in their order
    bool referenceFromHold = false;              // the mean of each run's initial hold instead of its rate
    std::optional<double> referenceTemperatureC; // nothing: chosen (run_features.h)
    // Checks that the user overrides; name and excluded are not used.
    QualityOptions quality{};

    std::vector<std::string> models = defaultModelNames();
    std::vector<RunId> holdOut; // empty: each run is left out in turn
    RbfOptions rbf{};
    BpOptions bp{};
    std::uint64_t seed = 1;
    Judging judging = Judging::Absolute;

    // What may be left on a held-out run, as rms of the residual in dps; nothing: no limit is set.
    std::optional<double> limitRmsDps;

    const RunInPlan *find(RunId run) const; // null: not in it
    RunInPlan *find(RunId run);
};

bool operator==(const CalibrationPlan &a, const CalibrationPlan &b);
// Equal but for the limit, by which nothing is computed: what was made by one is also that of the other.
bool computesTheSame(const CalibrationPlan &a, const CalibrationPlan &b);

// A run passes on an axis if what the model leaves stays within the limit; nothing without a limit.
std::optional<bool> passes(const CalibrationPlan &plan, const ComparisonRow &row);

// The plan of these runs: entries of runs that are gone go, new runs take part with the rate that they were
// recorded at, the order is that of the runs.
CalibrationPlan fittedToRuns(CalibrationPlan plan, const std::vector<RunRecord> &runs);

// All but what a session file keeps beside each run (exclusions and reference rates). Errors: SessionDamaged.
std::string calibrationPlanToJson(const CalibrationPlan &plan);
Result<CalibrationPlan> calibrationPlanFromJson(const std::string &json);

} // namespace driftbench
