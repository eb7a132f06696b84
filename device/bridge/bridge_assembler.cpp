#include "device/bridge/bridge_assembler.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

namespace {

constexpr double kQuietAfterS = 10.0;  // a saturation this long after the last one is told again
constexpr double kLongestJitter = 1.5; // intervals that a sample may be late without a loss
constexpr double kMostOffRate = 4.0;   // times that a device may sample faster or slower than it was told
constexpr auto kMostInReport = static_cast<std::int64_t>(BRIDGE_SAMPLES_PER_REPORT);

bool atLimit(std::int16_t counts)
{
    using Limits = std::numeric_limits<std::int16_t>;
    return counts == Limits::max() || counts == Limits::min();
}

std::string saturatedAxes(const BridgeSamples &report)
{
    std::string axes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool saturated = std::any_of(report.counts.begin(), report.counts.begin() + report.count,
                                           [axis](const auto &counts) { return atLimit(counts[axis]); });
        if (saturated)
            axes += (axes.empty() ? "" : ", ") + std::string(1, "xyz"[axis]);
    }
    return axes.empty() ? "an axis, before it was compensated" : axes;
}

} // namespace

BridgeAssembler::BridgeAssembler(const BridgeAssembly &assembly, SampleSink &sink)
    : m_assembly(assembly)
    , m_sink(sink)
    , m_block(SampleBlock::withRows(
          static_cast<Eigen::Index>(std::ceil(2.0 * assembly.blockS * assembly.sampleRateHz)) +
          kMostInReport))
    , m_saturatedS(-kQuietAfterS)
{
}

bool BridgeAssembler::isRepeat(const BridgeSamples &report) const
{
    return m_started && !m_away && report.sequence == m_sequence && report.timeUs == m_timeUs;
}

Flow BridgeAssembler::add(const BridgeSamples &report, double hostS)
{
    if (isRepeat(report))
        return Flow::Continue;
    // A device clock that goes back must not take the samples with it.
    const double mappedS = m_clock.map(report.timeUs, hostS);
    const double startS = m_started ? std::max(mappedS, m_lastS) : mappedS;
    if (m_started && markLoss(report, startS) == Flow::Stop)
        return Flow::Stop;
    m_started = true;
    m_away = false;
    m_sequence = report.sequence;
    m_timeUs = report.timeUs;
    m_startS = startS;
    m_reportSamples = report.count;
    return append(report, startS);
}

// On the device's clock, exact to its microseconds, where it went on without a wrap or a step back.
double BridgeAssembler::elapsedS(const BridgeSamples &report, double startS) const
{
    const double mappedS = startS - m_startS;
    const double deviceS = static_cast<std::uint32_t>(report.timeUs - m_timeUs) * 1e-6;
    return !m_away && std::abs(deviceS - mappedS) < 0.001 * mappedS + 1e-3 ? deviceS : mappedS;
}

double BridgeAssembler::intervalS() const
{
    const double nominalS = 1.0 / m_assembly.sampleRateHz;
    if (m_followedSamples == 0)
        return nominalS;
    // A clock that stands still or jumps must not make samples countless.
    return std::clamp(m_followedS / static_cast<double>(m_followedSamples), nominalS / kMostOffRate,
                      nominalS * kMostOffRate);
}

Flow BridgeAssembler::markLoss(const BridgeSamples &report, double startS)
{
    const double elapsed = elapsedS(report, startS);
    const double late = elapsed / intervalS() - m_reportSamples; // intervals after the sample was due
    const std::int64_t missing = std::max<std::int64_t>(std::llround(late), 0);
    const std::int64_t skipped = m_away ? 0 : static_cast<std::uint16_t>(report.sequence - m_sequence - 1);
    const bool overrun = report.has(BRIDGE_FLAG_OVERRUN) || (skipped == 0 && late > kLongestJitter);
    if (!m_away && skipped == 0 && !overrun) {
        m_followedS += elapsed;
        m_followedSamples += m_reportSamples;
        return Flow::Continue;
    }
    // What came before the gap goes out before it is told.
    const Flow flow = flush();
    if (m_away) {
        gap(startS, missing, GapCause::Unplugged);
        return flow;
    }
    const std::int64_t inReports =
        overrun ? std::min(missing, skipped * kMostInReport) : std::max(missing, skipped);
    if (skipped > 0)
        gap(startS, inReports, GapCause::ReportsLost);
    if (overrun)
        gap(startS, missing - (skipped > 0 ? inReports : 0), GapCause::DeviceOverrun);
    return flow;
}

void BridgeAssembler::gap(double startS, std::int64_t lost, GapCause cause)
{
    ++m_stats.gaps;
    m_stats.lostSamples += lost;
    m_sink.gap({m_lastS, startS, lost, cause});
}

Flow BridgeAssembler::append(const BridgeSamples &report, double startS)
{
    const double stepS = report.intervalNs * 1e-9 * m_clock.rate();
    const double temperature = temperatureC(report);
    tellOnce(m_toldCompensation, report.has(BRIDGE_FLAG_COMPENSATED) != m_assembly.compensated,
             m_assembly.compensated
                 ? "The device sends raw rates, the thermometer of its table is not read."
                 : "The device sends compensated rates, although raw ones were asked for.");
    tellOnce(m_toldOutsideTable, report.has(BRIDGE_FLAG_OUTSIDE_TABLE),
             "The temperature lies outside the device's table, whose end value is taken off.");
    tellSaturation(report, startS);
    if (m_count + report.count > m_block.size() && flush() == Flow::Stop)
        return Flow::Stop;
    for (int i = 0; i < report.count; ++i, ++m_count) {
        m_lastS = startS + i * stepS;
        m_block.timeS[m_count] = m_lastS;
        m_block.temperatureC[m_count] = temperature;
        for (int axis = 0; axis < 3; ++axis)
            m_block.rateDps(m_count, axis) = m_assembly.range.rateDps(
                report.counts[static_cast<std::size_t>(i)][static_cast<std::size_t>(axis)]);
        m_stats.saturatedSamples += report.isSaturated(i) ? 1 : 0;
    }
    m_stats.samples += report.count;
    return m_lastS - m_block.timeS[0] >= m_assembly.blockS ? flush() : Flow::Continue;
}

double BridgeAssembler::temperatureC(const BridgeSamples &report)
{
    const auto &milliC = m_assembly.externalThermometer ? report.externalMilliC : report.dieMilliC;
    tellOnce(m_toldNoTemperature, !milliC,
             m_assembly.externalThermometer
                 ? "The external thermometer is not read, samples come without a temperature."
                 : "The thermometer on the die is not read, samples come without a temperature.");
    return milliC ? *milliC / 1000.0 : std::numeric_limits<double>::quiet_NaN();
}

// Once when it begins, and again when it begins anew.
void BridgeAssembler::tellOnce(bool &told, bool happens, const char *sentence)
{
    if (happens && !told)
        m_sink.event(sentence);
    told = happens;
}

void BridgeAssembler::tellSaturation(const BridgeSamples &report, double startS)
{
    if (report.saturated == 0)
        return;
    if (startS - m_saturatedS >= kQuietAfterS)
        m_sink.event("The gyro is saturated on " + saturatedAxes(report) +
                     "; choose a larger range or turn it more slowly.");
    m_saturatedS = startS;
}

Flow BridgeAssembler::flush()
{
    if (m_count == 0)
        return Flow::Continue;
    const Flow flow = m_sink.samples(m_block, m_count);
    m_block.firstSample += m_count;
    m_count = 0;
    return flow;
}

void BridgeAssembler::restart()
{
    m_away = m_started;
    m_clock.restart();
}

SourceStats BridgeAssembler::stats() const
{
    SourceStats stats = m_stats;
    stats.clockDriftPpm = m_clock.driftPpm();
    return stats;
}

} // namespace driftbench
