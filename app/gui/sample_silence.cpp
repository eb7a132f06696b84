#include "app/gui/sample_silence.h"

#include <algorithm>

namespace driftbench {

static constexpr qint64 kShortestSilenceMs = 1500;

void SampleSilence::start()
{
    m_since.start();
    m_usualPauseMs = 0;
    m_any = false;
}

void SampleSilence::came(bool afterAbsence)
{
    const qint64 pauseMs = m_since.restart();
    if (!afterAbsence)
        m_usualPauseMs = std::max(m_usualPauseMs, std::min(pauseMs, kShortestSilenceMs));
    m_any = true;
}

double SampleSilence::sinceS() const
{
    return static_cast<double>(m_since.elapsed()) / 1000.0;
}

std::optional<double> SampleSilence::overdueForS() const
{
    if (!m_any || m_since.elapsed() < std::max(kShortestSilenceMs, 4 * m_usualPauseMs))
        return std::nullopt;
    return sinceS();
}

} // namespace driftbench
