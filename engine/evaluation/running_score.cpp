#include "engine/evaluation/running_score.h"

#include "engine/base/statistics.h"

#include <cmath>
#include <limits>

namespace driftbench {

namespace {

const Eigen::Vector3d kNone = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());

} // namespace

void RunningScore::add(const Eigen::Ref<const Eigen::VectorXd> &timeS,
                       const Eigen::Ref<const Eigen::MatrixX3d> &residualDps)
{
    for (Eigen::Index row = 0; row < timeS.size(); ++row) {
        const Eigen::Vector3d residual = residualDps.row(row).transpose();
        if (std::isfinite(timeS[row]) && residual.allFinite())
            addRow(timeS[row], residual);
        else
            ++m_leftOut;
    }
}

void RunningScore::addRow(double timeS, const Eigen::Vector3d &residualDps)
{
    if (m_samples == 0)
        m_firstS = timeS;
    else if (m_fewest == 0.0)
        m_intervals.push_back(timeS - m_lastS);
    m_lastS = timeS;
    const double index = std::floor((timeS - m_firstS) / m_windowS);
    if (m_open.samples > 0 && index != m_open.index) {
        count(m_open);
        m_open = {};
    }
    m_open.index = index;
    ++m_open.samples;
    m_open.sumDps += residualDps;
    ++m_samples;
    m_squares += residualDps.cwiseAbs2();
    if (m_intervals.size() == kIntervals)
        learnInterval();
}

void RunningScore::learnInterval()
{
    const double interval = median(std::move(m_intervals));
    m_intervals = {};
    m_fewest = 0.5 * m_windowS / interval;
    for (const Window &window : m_waiting)
        count(window);
    m_waiting.clear();
}

void RunningScore::count(const Window &window)
{
    if (m_fewest == 0.0) {
        m_waiting.push_back(window);
        return;
    }
    if (static_cast<double>(window.samples) < m_fewest)
        return;
    ++m_windows;
    m_windowSquares += (window.sumDps / static_cast<double>(window.samples)).cwiseAbs2();
}

Eigen::Vector3d RunningScore::msdDps2() const
{
    return m_samples > 0 ? Eigen::Vector3d(m_squares / static_cast<double>(m_samples)) : kNone;
}

RunningScore RunningScore::closed() const
{
    RunningScore whole = *this;
    // So few samples that the median is that of what there is.
    if (whole.m_fewest == 0.0 && !whole.m_intervals.empty())
        whole.learnInterval();
    if (whole.m_open.samples > 0)
        whole.count(whole.m_open);
    return whole;
}

Eigen::Index RunningScore::windows() const
{
    return closed().m_windows;
}

Eigen::Vector3d RunningScore::rms10sDps() const
{
    const RunningScore whole = closed();
    if (whole.m_windows == 0)
        return kNone;
    return (whole.m_windowSquares / static_cast<double>(whole.m_windows)).cwiseSqrt();
}

} // namespace driftbench
