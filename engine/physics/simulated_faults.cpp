#include "engine/physics/simulated_faults.h"

#include <algorithm>

namespace driftbench {

namespace {

struct Interval
{
    double startS = 0.0;
    double endS = 0.0;
};

std::vector<Interval> drawIntervals(int count, double lengthS, double durationS, Random &random)
{
    std::vector<Interval> intervals;
    const double stretchS = durationS / count;
    const double shortenedS = std::min(lengthS, 0.5 * stretchS);
    for (int i = 0; i < count; ++i) {
        const double startS = i * stretchS + random.uniform(0.0, stretchS - shortenedS);
        intervals.push_back({startS, startS + shortenedS});
    }
    return intervals;
}

// Between half and all of size on each axis, either way.
Eigen::Vector3d drawSwing(double size, Random &random)
{
    Eigen::Vector3d swing;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const double magnitude = random.uniform(0.5 * size, size);
        swing[axis] = random.below(2) == 0 ? magnitude : -magnitude;
    }
    return swing;
}

} // namespace

std::vector<BiasStep> drawBiasSteps(const FaultOptions &options, double durationS, Random random)
{
    std::vector<BiasStep> steps;
    for (const Interval &interval : drawIntervals(options.biasSteps, 0.0, durationS, random))
        steps.push_back({interval.startS, drawSwing(options.biasStepDps, random)});
    return steps;
}

std::vector<MotionBurst> drawMotionBursts(const FaultOptions &options, double durationS, Random random)
{
    constexpr double kFewestCycles = 3.0;
    constexpr double kMostCycles = 10.0;
    std::vector<MotionBurst> bursts;
    for (const Interval &interval : drawIntervals(options.motionBursts, options.motionS, durationS, random))
        bursts.push_back({interval.startS, interval.endS, drawSwing(options.motionDps, random),
                          random.uniform(kFewestCycles, kMostCycles)});
    return bursts;
}

std::vector<Gap> drawGaps(const FaultOptions &options, double durationS, Random random)
{
    std::vector<Gap> gaps;
    for (const Interval &interval : drawIntervals(options.gaps, options.gapS, durationS, random))
        gaps.push_back({interval.startS, interval.endS});
    return gaps;
}

void FaultPlayer::advance(double timeS)
{
    const auto &[biasSteps, motionBursts, gaps] = m_events;
    while (m_nextStep < biasSteps.size() && biasSteps[m_nextStep].timeS <= timeS)
        m_biasDps += biasSteps[m_nextStep++].stepDps;
    while (m_motion < motionBursts.size() && motionBursts[m_motion].endS <= timeS)
        ++m_motion;
    while (m_gap < gaps.size() && gaps[m_gap].endS <= timeS)
        ++m_gap;
    m_inGap = m_gap < gaps.size() && gaps[m_gap].startS <= timeS;
    m_rateDps = m_biasDps;
    if (m_motion < motionBursts.size() && motionBursts[m_motion].startS <= timeS)
        m_rateDps += motionBursts[m_motion].rateDps(timeS);
}

} // namespace driftbench
