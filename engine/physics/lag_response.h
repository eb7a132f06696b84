// The answer of a first-order lag with dead time to a stair of set-points, at any ascending times, with its
// derivatives:
//
//   tau dx/dt = u(t - theta) - x
//
// Exact: between two steps x is an exponential. x starts at the set-point that has arrived by then; what a
// real start was off decays by startPart.
#pragma once

#include "engine/physics/temperature_profile.h"

#include <cstddef>
#include <vector>

namespace driftbench {

struct Lag
{
    double deadTimeS = 0.0;     // theta
    double timeConstantS = 0.0; // tau > 0
};

class LagResponse
{
public:
    // setpoint: ascending in time, not empty; must outlive this.
    LagResponse(const std::vector<ProfileStep> &setpoint, double startS, const Lag &lag);

    void advanceTo(double timeS);

    double outputC() const { return m_outputC; }
    double startPart() const { return m_startPart; } // of what the output was off at the start
    double byDeadTime() const { return (m_outputC - m_inputC) / m_lag.timeConstantS; }
    double byTimeConstant() const { return m_byTimeConstant; }

private:
    double dueS(std::size_t step) const { return m_setpoint[step].startS + m_lag.deadTimeS; }
    void decay(double intervalS);

    const std::vector<ProfileStep> &m_setpoint;
    Lag m_lag;
    std::size_t m_next = 0;
    double m_timeS;
    double m_inputC;
    double m_outputC = 0.0;
    double m_byTimeConstant = 0.0;
    double m_startPart = 1.0;
    double m_intervalS = -1.0; // of the factors below
    double m_factor = 1.0;
    double m_slope = 0.0;
};

} // namespace driftbench
