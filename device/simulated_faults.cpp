#include "device/simulated_faults.h"

#include "device/firmware/bridge_bytes.h"

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
    if (m_compensationError != 0 && (report[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_COMPENSATED) != 0)
        miscompensate(report);
    if (m_damaged.holds(number))
        report[BRIDGE_SAMPLES_COUNT] = 0xFF;
    return std::none_of(m_lost.begin(), m_lost.end(),
                        [number](const Span &span) { return span.holds(number); });
}

void SimulatedFaults::miscompensate(BridgeReport &report) const
{
    for (std::size_t i = 0; i < report[BRIDGE_SAMPLES_COUNT]; ++i) {
        std::uint8_t *x = &report[BRIDGE_SAMPLES_RATES + i * BRIDGE_SAMPLE_SIZE];
        bridge_put_u16(x, static_cast<std::uint16_t>(bridge_get_i16(x) + m_compensationError));
    }
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
