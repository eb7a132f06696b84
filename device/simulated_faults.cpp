#include "device/simulated_faults.h"

#include <algorithm>
#include <utility>

namespace driftbench {

bool SimulatedFaults::nextReportUnplugs()
{
    if (m_unplugAtReport != m_reports)
        return false;
    m_unplugAtReport.reset();
    return true;
}

bool SimulatedFaults::nextExchangeUnplugs()
{
    if (m_unplugAtExchange != m_exchanges++)
        return false;
    m_unplugAtExchange.reset();
    return true;
}

bool SimulatedFaults::isStalled(double nowS)
{
    if (m_stallAt == m_reports) {
        m_stallAt.reset();
        m_stalledUntilS = nowS + m_stallS;
    }
    if (m_stalledUntilS && nowS >= *m_stalledUntilS)
        m_stalledUntilS.reset();
    return m_stalledUntilS.has_value();
}

bool SimulatedFaults::passes(BridgeReport &report)
{
    const std::int64_t number = m_reports++;
    if (m_damaged.holds(number))
        report[BRIDGE_SAMPLES_COUNT] = 0xFF;
    return std::none_of(m_lost.begin(), m_lost.end(),
                        [number](const Span &span) { return span.holds(number); });
}

std::optional<std::uint8_t> SimulatedFaults::refusal(std::uint8_t command)
{
    if (!m_refusal || m_refusal->command != command)
        return std::nullopt;
    return std::exchange(m_refusal, std::nullopt)->result;
}

bool SimulatedFaults::ignoresSet()
{
    if (m_ignoredSets == 0)
        return false;
    --m_ignoredSets;
    return true;
}

void SimulatedFaults::pretend(BridgeReport &answer) const
{
    if (m_major && answer[0] == BRIDGE_REPORT_INFO)
        answer[BRIDGE_INFO_MAJOR] = *m_major;
}

} // namespace driftbench
