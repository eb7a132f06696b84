#include "app/cli/session_fit.h"

#include "app/cli/model_input.h"

#include <algorithm>

namespace driftbench::cli {

Result<std::optional<std::filesystem::path>> sessionAmong(const std::vector<std::filesystem::path> &files)
{
    const auto session = std::find_if(files.begin(), files.end(), isSessionPath);
    if (session == files.end())
        return std::optional<std::filesystem::path>();
    if (files.size() > 1)
        return Error{Errc::InvalidOption,
                     session->string() +
                         " is a session and stands beside other runs; bring those into it with "
                         "\"session import\", or name logs alone."};
    return std::optional(*session);
}

Result<CalibrationPlan> overridden(const Session &session, const PlanOverrides &overrides)
{
    CalibrationPlan plan = session.plan();
    if (overrides.referenceRate) {
        plan.referenceFromHold = *overrides.referenceRate == ReferenceRateKind::InitialHold;
        for (RunInPlan &run : plan.runs) {
            if (!plan.referenceFromHold)
                run.referenceRateDps = overrides.referenceRateDps;
        }
    }
    for (const TimeRange &range : overrides.quality.excluded) {
        const auto isThere = [&range](const Exclusion &each) {
            return each.range.startS == range.startS && each.range.endS == range.endS;
        };
        for (RunInPlan &run : plan.runs) {
            if (std::none_of(run.excluded.begin(), run.excluded.end(), isThere))
                run.excluded.push_back({range, "--exclude"});
        }
    }
    if (overrides.referenceTemperatureC)
        plan.referenceTemperatureC = overrides.referenceTemperatureC;
    plan.quality.maskBadRows |= overrides.quality.maskBadRows;
    plan.quality.allowSmallSpan |= overrides.quality.allowSmallSpan;
    plan.quality.allowShort |= overrides.quality.allowShort;
    plan.models = overrides.models.value_or(plan.models);
    plan.judging = overrides.judging.value_or(plan.judging);
    plan.seed = overrides.seed.value_or(plan.seed);
    if (!overrides.holdOut)
        return plan;
    plan.holdOut.clear();
    for (const std::string &name : *overrides.holdOut) {
        const auto &runs = session.runs();
        const auto run = std::find_if(runs.begin(), runs.end(), [&name](const RunRecord &each) {
            return each.description.name == name;
        });
        if (run == runs.end())
            return Error{Errc::NoSuchRun, session.path().string() + " has no run named " + name +
                                              "; \"session info\" lists them."};
        plan.holdOut.push_back(run->id);
    }
    return plan;
}

Result<PreparedCampaign> prepareSession(const Session &session, const CalibrationPlan &plan,
                                        const ProgressHook &hook)
{
    const auto runs = loadRuns(session.file(), plan, {}, hook);
    if (!runs)
        return runs.error();
    auto prepared = prepareCampaign(plan, *runs, hook);
    if (prepared && prepared->refusal)
        return *prepared->refusal;
    return prepared;
}

} // namespace driftbench::cli
