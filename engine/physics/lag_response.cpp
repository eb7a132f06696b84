#include "engine/physics/lag_response.h"

#include <cassert>
#include <cmath>

namespace driftbench {

LagResponse::LagResponse(const std::vector<ProfileStep> &setpoint, double startS, const Lag &lag)
    : m_setpoint(setpoint), m_lag(lag), m_timeS(startS), m_inputC(setpoint.front().setpointC)
{
    assert(lag.timeConstantS > 0.0);
    while (m_next < m_setpoint.size() && dueS(m_next) <= m_timeS)
        m_inputC = m_setpoint[m_next++].setpointC;
    m_outputC = m_inputC;
}

void LagResponse::advanceTo(double timeS)
{
    while (m_next < m_setpoint.size() && dueS(m_next) <= timeS) {
        decay(dueS(m_next) - m_timeS);
        m_timeS = dueS(m_next);
        m_inputC = m_setpoint[m_next++].setpointC;
    }
    decay(timeS - m_timeS);
    m_timeS = timeS;
}

void LagResponse::decay(double intervalS)
{
    if (intervalS != m_intervalS) {
        m_intervalS = intervalS;
        m_factor = std::exp(-intervalS / m_lag.timeConstantS);
        m_slope = m_factor * intervalS / (m_lag.timeConstantS * m_lag.timeConstantS);
    }
    const double awayC = m_outputC - m_inputC;
    m_byTimeConstant = m_byTimeConstant * m_factor + awayC * m_slope;
    m_outputC = m_inputC + awayC * m_factor;
    m_startPart *= m_factor;
}

} // namespace driftbench
