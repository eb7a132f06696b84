// What goes wrong with a simulated board when, on demand. Reports and exchanges are counted from the call on,
// 0 being the next.
#pragma once

#include "device/bridge/bridge_codec.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace driftbench {

class SimulatedFaults
{
public:
    void loseReports(std::int64_t first, std::int64_t count) // input reports, on their way to the host
    {
        m_lost.push_back({m_reports + first, m_reports + first + count});
    }
    void stall(std::int64_t report, double durationS) // from this report on the device sends nothing so long
    {
        m_stallAt = m_reports + report;
        m_stallS = durationS;
    }
    void damageReports(std::int64_t first, std::int64_t count) // their count of samples can't be
    {
        m_damaged = {m_reports + first, m_reports + first + count};
    }
    void compensateWrongly(int counts) { m_compensationError = counts; } // so much more on x, from now on
    void unplugAtReport(std::int64_t report) { m_unplugAtReport = m_reports + report; } // instead of it
    void unplugAtExchange(std::int64_t exchange) // instead of this get or set
    {
        m_unplugAtExchange = m_exchanges + exchange;
    }
    void refuse(std::uint8_t command, std::uint8_t result) { m_refusal = {command, result}; } // the next such
    void ignoreSets(int count) { m_ignoredSets = count; } // the next sets have neither effect nor result
    void stallRefusedSets(bool stalls) { m_stallsRefusedSets = stalls; } // they are errors on the bus as well
    void pretendMajor(std::uint8_t major) { m_major = major; }           // the protocol version in info

    // For the board.
    std::int64_t exchanges() const { return m_exchanges; } // gets and sets so far
    bool nextReportUnplugs();
    bool nextExchangeUnplugs(); // counts it
    bool isStalled(double nowS);
    void endStall() { m_stalledUntilS.reset(); }
    bool passes(BridgeReport &report); // counts it; false: it is lost. May damage it
    std::optional<std::uint8_t> refusal(std::uint8_t command);
    bool ignoresSet();
    bool stallsRefusedSets() const { return m_stallsRefusedSets; }
    void pretend(BridgeReport &answer) const;

private:
    void miscompensate(BridgeReport &report) const;

    struct Span
    {
        std::int64_t first = 0;
        std::int64_t end = 0;
        bool holds(std::int64_t number) const { return first <= number && number < end; }
    };
    struct Refusal
    {
        std::uint8_t command;
        std::uint8_t result;
    };

    std::int64_t m_reports = 0;
    std::int64_t m_exchanges = 0;
    std::vector<Span> m_lost;
    std::optional<std::int64_t> m_stallAt;
    double m_stallS = 0.0;
    std::optional<double> m_stalledUntilS;
    Span m_damaged;
    int m_compensationError = 0;
    std::optional<std::int64_t> m_unplugAtReport;
    std::optional<std::int64_t> m_unplugAtExchange;
    std::optional<Refusal> m_refusal;
    std::optional<std::uint8_t> m_major;
    int m_ignoredSets = 0;
    bool m_stallsRefusedSets = false;
};

} // namespace driftbench
