// What goes wrong in a simulated run, at times that are drawn before it starts: bias steps, bursts of motion
// and gaps. With n events of a kind the run is cut into n equal stretches and each holds one, so that events
// of a kind never overlap; one that would be longer than half its stretch is shortened to that.
#pragma once

#include "engine/base/random.h"
#include "engine/physics/simulation_options.h"

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

namespace driftbench {

struct BiasStep
{
    double timeS = 0.0;
    Eigen::Vector3d stepDps = Eigen::Vector3d::Zero(); // stays until the end
};

// Swings that grow and die away: peak sin^2(pi x) sin(2 pi c x), x from 0 to 1 over the burst.
struct MotionBurst
{
    double startS = 0.0;
    double endS = 0.0;
    Eigen::Vector3d peakDps = Eigen::Vector3d::Zero();
    double cycles = 0.0;

    Eigen::Vector3d rateDps(double timeS) const
    {
        const double x = (timeS - startS) / (endS - startS);
        const double envelope = std::sin(std::numbers::pi * x);
        return peakDps * (envelope * envelope * std::sin(2.0 * std::numbers::pi * cycles * x));
    }
};

struct Gap
{
    double startS = 0.0; // the first sample at or after it is lost
    double endS = 0.0;   // the first sample at or after it is there again
};

struct FaultEvents
{
    std::vector<BiasStep> biasSteps; // each list ascending in time
    std::vector<MotionBurst> motionBursts;
    std::vector<Gap> gaps;

    bool empty() const { return biasSteps.empty() && motionBursts.empty() && gaps.empty(); }
};

std::vector<BiasStep> drawBiasSteps(const FaultOptions &options, double durationS, Random random);
std::vector<MotionBurst> drawMotionBursts(const FaultOptions &options, double durationS, Random random);
std::vector<Gap> drawGaps(const FaultOptions &options, double durationS, Random random);

// The events at the time of a sample; time must not go backwards from call to call.
class FaultPlayer
{
public:
    explicit FaultPlayer(FaultEvents events) : m_events(std::move(events)) {}

    void advance(double timeS);
    bool sampleLost() const { return m_inGap; }
    const Eigen::Vector3d &rateDps() const { return m_rateDps; } // of steps so far and of motion now

    const FaultEvents &events() const { return m_events; }

private:
    FaultEvents m_events;
    std::size_t m_nextStep = 0;
    std::size_t m_motion = 0; // the one that goes on or comes next
    std::size_t m_gap = 0;
    bool m_inGap = false;
    Eigen::Vector3d m_biasDps = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_rateDps = Eigen::Vector3d::Zero();
};

} // namespace driftbench
