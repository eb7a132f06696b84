#include "app/gui/record/run_progress.h"

#include <algorithm>

namespace driftbench {

PlanProgress::PlanProgress(const TestPlan &plan)
{
    const auto profile = plan.profile();
    if (!profile)
        return;
    m_profile = *profile;
    m_segments = plan.segments();
}

std::optional<RunProgress> PlanProgress::at(double elapsedS) const
{
    if (!m_profile)
        return std::nullopt;
    const double durationS = m_profile->durationS();
    RunProgress progress;
    progress.fraction = durationS > 0.0 ? std::clamp(elapsedS / durationS, 0.0, 1.0) : 1.0;
    progress.remainingS = std::max(durationS - elapsedS, 0.0);
    progress.setpointC = m_profile->setpointC(elapsedS);
    progress.ended = elapsedS >= durationS;
    const auto &steps = m_profile->steps();
    progress.steps = static_cast<int>(steps.size()) - 1;
    const auto next =
        std::upper_bound(steps.begin(), steps.end(), elapsedS,
                         [](double timeS, const ProfileStep &step) { return timeS < step.startS; });
    progress.step = std::max(static_cast<int>(next - steps.begin()) - 1, 0);
    for (const PlanSegment &segment : m_segments) {
        if (elapsedS < segment.startS || segment.isHold())
            progress.phase = elapsedS >= segment.startS ? RunPhase::Hold : progress.phase;
        else
            progress.phase = segment.toC > segment.fromC ? RunPhase::Rise : RunPhase::Fall;
    }
    return progress;
}

} // namespace driftbench
