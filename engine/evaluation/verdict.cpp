#include "engine/evaluation/verdict.h"

#include <algorithm>

namespace driftbench {

namespace {

constexpr double kWorseInFloors = 0.02;
constexpr double kSmallestErrorInFloors = 0.001;
constexpr double kNoDriftInFloors = 0.02;
constexpr double kGainForYes = 0.75;
constexpr double kGainForCare = 0.5;

} // namespace

bool HeldOutError::worse() const
{
    return modelMsd > constantMsd + kWorseInFloors * floor;
}

Judgement judge(const AxisEvidence &evidence)
{
    double constantError = 0.0;
    double modelError = 0.0;
    double floor = 0.0;
    Judgement judgement;
    for (const HeldOutError &run : evidence.heldOut) {
        constantError += run.constantError();
        modelError += run.modelError();
        floor += run.floor;
        judgement.worse += run.worse() ? 1 : 0;
    }
    judgement.gain = constantError > 0.0 ? 1.0 - modelError / constantError : 0.0;
    const int runs = static_cast<int>(evidence.heldOut.size());
    const bool something = constantError > kSmallestErrorInFloors * floor;
    if (something && judgement.gain >= kGainForYes && judgement.worse == 0 && !evidence.singleRun)
        judgement.verdict = Verdict::Yes;
    else if (something && judgement.gain >= kGainForCare && judgement.worse <= runs / 3)
        judgement.verdict = Verdict::WithCare;
    else if (evidence.inRunVariance <= kNoDriftInFloors * floor / std::max(runs, 1))
        judgement.verdict = Verdict::NoDrift;
    return judgement;
}

} // namespace driftbench
