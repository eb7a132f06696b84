#include "device/clock_map.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr double kWrapS = 4294.967296;
constexpr std::int64_t kWrapUs = std::int64_t{1} << 32;
constexpr double kFirstWindowS = 5.0;
constexpr std::size_t kMostWindows = 64;
constexpr std::size_t kFewestWindows = 6;
constexpr double kMostSlope = 500e-6;
constexpr double kShortestPart = 0.25; // of the span, between two points of a slope

} // namespace

// Unsigned in 32 bits, plus the whole wraps (or, where the clock went back, minus one) that the host saw
// pass.
std::int64_t ClockMap::elapsedUs(std::uint32_t deviceUs, double hostS) const
{
    const std::int64_t step = static_cast<std::uint32_t>(deviceUs - m_lastUs);
    const double hostElapsedS = hostS - m_lastHostS;
    const double wraps = std::round((hostElapsedS - static_cast<double>(step) * 1e-6) / kWrapS);
    return step + static_cast<std::int64_t>(wraps) * kWrapUs;
}

double ClockMap::map(std::uint32_t deviceUs, double hostS)
{
    if (!m_started || m_restarted) {
        if (m_started)
            m_lastTimeS += std::max(0.0, hostS - m_lastHostS);
        m_started = true;
        m_restarted = false;
        m_anchorUs = m_originUs = m_deviceUs;
        m_anchorS = m_lastTimeS;
        m_originHostS = hostS;
        m_windowS = kFirstWindowS;
        m_windowEndS = kFirstWindowS;
    } else {
        m_deviceUs += elapsedUs(deviceUs, hostS);
        const double timeS = m_anchorS + static_cast<double>(m_deviceUs - m_anchorUs) * 1e-6 * rate();
        m_lastTimeS = std::max(m_lastTimeS, timeS);
    }
    m_lastUs = deviceUs;
    m_lastHostS = hostS;
    const double deviceS = static_cast<double>(m_deviceUs - m_originUs) * 1e-6;
    observe({deviceS, hostS - m_originHostS - deviceS});
    return m_lastTimeS;
}

void ClockMap::restart()
{
    m_restarted = m_started;
    m_points.clear();
    m_lowest.reset();
}

void ClockMap::observe(const Point &point)
{
    if (point.deviceS >= m_windowEndS) {
        closeWindow();
        m_windowEndS = (std::floor(point.deviceS / m_windowS) + 1.0) * m_windowS;
    }
    if (!m_lowest || residualS(point) < residualS(*m_lowest))
        m_lowest = point;
}

void ClockMap::closeWindow()
{
    if (!m_lowest)
        return;
    m_points.push_back(*m_lowest);
    m_lowest.reset();
    if (m_points.size() >= kFewestWindows)
        estimateSlope();
    if (m_points.size() < kMostWindows)
        return;
    for (std::size_t i = 0; i < kMostWindows / 2; ++i) {
        const Point &first = m_points[2 * i];
        const Point &second = m_points[2 * i + 1];
        m_points[i] = residualS(second) < residualS(first) ? second : first;
    }
    m_points.resize(kMostWindows / 2);
    m_windowS *= 2.0;
}

void ClockMap::estimateSlope()
{
    const double shortestS = kShortestPart * (m_points.back().deviceS - m_points.front().deviceS);
    std::vector<double> slopes;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        for (std::size_t j = i + 1; j < m_points.size(); ++j) {
            const double spanS = m_points[j].deviceS - m_points[i].deviceS;
            if (spanS > 0.0 && spanS >= shortestS)
                slopes.push_back((m_points[j].delayS - m_points[i].delayS) / spanS);
        }
    }
    if (slopes.empty())
        return;
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    m_anchorS = m_lastTimeS;
    m_anchorUs = m_deviceUs;
    m_slope = std::clamp(*middle, -kMostSlope, kMostSlope);
    m_driftKnown = true;
}

} // namespace driftbench
