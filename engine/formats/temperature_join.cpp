#include "engine/formats/temperature_join.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

double TemperatureJoin::temperatureAt(double timeS, double nextTimeS, double nextTemperatureC) const
{
    if (std::isnan(m_lastTemperatureC))
        return nextTemperatureC;
    if (!(nextTimeS > m_lastTimeS))
        return m_lastTemperatureC;
    const double share = std::clamp((timeS - m_lastTimeS) / (nextTimeS - m_lastTimeS), 0.0, 1.0);
    return m_lastTemperatureC + share * (nextTemperatureC - m_lastTemperatureC);
}

Flow TemperatureJoin::addRate(double timeS, const Eigen::Vector3d &rateDps)
{
    m_waiting.push_back({timeS, rateDps});
    return m_waiting.size() < kMostWaiting ? Flow::Continue : finish();
}

Flow TemperatureJoin::addTemperature(double timeS, double temperatureC)
{
    if (!std::isfinite(temperatureC))
        return Flow::Continue;
    Flow flow = Flow::Continue;
    for (const Waiting &sample : m_waiting) {
        if (flow == Flow::Continue)
            flow =
                m_buffer.push(sample.timeS, temperatureAt(sample.timeS, timeS, temperatureC), sample.rateDps);
    }
    m_waiting.clear();
    m_lastTimeS = timeS;
    m_lastTemperatureC = temperatureC;
    return flow;
}

Flow TemperatureJoin::finish()
{
    Flow flow = Flow::Continue;
    for (const Waiting &sample : m_waiting) {
        if (flow == Flow::Continue)
            flow = m_buffer.push(sample.timeS, m_lastTemperatureC, sample.rateDps);
    }
    m_waiting.clear();
    return flow;
}

} // namespace driftbench
