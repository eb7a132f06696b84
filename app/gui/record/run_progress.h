// Where a run is in its test plan: plain figures for the read-outs of the Record page.
#pragma once

#include "engine/physics/test_plan.h"

#include <optional>

namespace driftbench {

enum class RunPhase
{
    Hold,
    Rise,
    Fall
};

struct RunProgress
{
    double fraction = 0.0; // 0..1 of the plan's time
    double remainingS = 0.0;
    double setpointC = 0.0;
    RunPhase phase = RunPhase::Hold;
    int step = 0; // of the steps of temperature so far
    int steps = 0;
    bool ended = false;
};

// elapsedS: since the first sample. Nothing without a plan that can be played.
class PlanProgress
{
public:
    PlanProgress() = default;
    explicit PlanProgress(const TestPlan &plan);

    const std::optional<TemperatureProfile> &profile() const { return m_profile; }
    std::optional<RunProgress> at(double elapsedS) const;

private:
    std::optional<TemperatureProfile> m_profile;
    std::vector<PlanSegment> m_segments;
};

} // namespace driftbench
