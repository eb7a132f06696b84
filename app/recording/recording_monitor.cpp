#include "app/recording/recording_monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

double RecordingState::measuredRateHz() const
{
    const double seconds = durationS() - gapS;
    const auto intervals = samples - 1 - gaps;
    return intervals > 0 && seconds > 0.0 ? static_cast<double>(intervals) / seconds : 0.0;
}

RecordingMonitor::RecordingMonitor(SampleSink &sink, double endS) : m_sink(sink), m_endS(endS)
{
    m_state.lowestC = std::numeric_limits<double>::infinity();
    m_state.highestC = -std::numeric_limits<double>::infinity();
}

Flow RecordingMonitor::samples(const SampleBlock &block, Eigen::Index count)
{
    const Eigen::Index rows = rowsBeforeEnd(block, count);
    if (rows > 0) {
        note(block, rows);
        if (m_sink.samples(block, rows) == Flow::Stop) {
            const std::lock_guard lock(m_mutex);
            m_state.refused = true;
            return Flow::Stop;
        }
    }
    if (rows == count)
        return Flow::Continue;
    const std::lock_guard lock(m_mutex);
    m_state.reachedEnd = true;
    return Flow::Stop;
}

void RecordingMonitor::gap(const SampleGap &gap)
{
    // One that reaches beyond the end belongs to what is left out.
    if (m_endS > 0.0 && gap.endS >= m_endS)
        return;
    {
        const std::lock_guard lock(m_mutex);
        ++m_state.gaps;
        m_state.lostSamples += std::max<std::int64_t>(0, gap.lostSamples);
        m_state.gapS += gap.endS - gap.startS;
    }
    m_sink.gap(gap);
}

void RecordingMonitor::event(const std::string &sentence)
{
    {
        const std::lock_guard lock(m_mutex);
        ++m_state.events;
    }
    m_sink.event(sentence);
}

RecordingState RecordingMonitor::state() const
{
    const std::lock_guard lock(m_mutex);
    return m_state;
}

Eigen::Index RecordingMonitor::rowsBeforeEnd(const SampleBlock &block, Eigen::Index count) const
{
    if (m_endS <= 0.0)
        return count;
    for (Eigen::Index i = 0; i < count; ++i) {
        if (block.timeS[i] >= m_endS)
            return i;
    }
    return count;
}

void RecordingMonitor::note(const SampleBlock &block, Eigen::Index count)
{
    const std::lock_guard lock(m_mutex);
    if (m_state.samples == 0)
        m_state.firstS = block.timeS[0];
    m_state.samples += count;
    m_state.lastS = block.timeS[count - 1];
    m_state.temperatureC = block.temperatureC[count - 1];
    for (Eigen::Index i = 0; i < count; ++i) {
        m_state.lowestC = std::fmin(m_state.lowestC, block.temperatureC[i]);
        m_state.highestC = std::fmax(m_state.highestC, block.temperatureC[i]);
    }
    m_state.rateDps = block.rateDps.topRows(count).colwise().mean().transpose();
}

} // namespace driftbench
