#include "device/simulated_gyro.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

namespace {

// What is no number can't be told in counts; the end of the range is what a broken gyro would show.
std::int16_t countsOf(double rateDps, BridgeRange range)
{
    using Limits = std::numeric_limits<std::int16_t>;
    if (!std::isfinite(rateDps))
        return Limits::min();
    const double counts = std::nearbyint(rateDps * 100000.0 / range.sensitivity);
    return static_cast<std::int16_t>(std::clamp<double>(counts, Limits::min(), Limits::max()));
}

std::int32_t milliC(double temperatureC)
{
    return static_cast<std::int32_t>(std::lround(temperatureC * 1000.0));
}

} // namespace

SimulatedGyro::SimulatedGyro(SimulationOptions options, bool externalThermometer, int firstRun)
    : m_options(std::move(options)), m_externalThermometer(externalThermometer), m_run(firstRun)
{
}

Status SimulatedGyro::start(std::uint32_t rateMilliHz, BridgeRange range, double nowS)
{
    const bool goesOn = m_interrupted && rateMilliHz == m_rateMilliHz && range == m_range;
    if (!goesOn)
        return restart(rateMilliHz, range, nowS);
    // The chamber went on meanwhile.
    while (m_next && m_startS + m_next->timeS < nowS)
        fetch();
    m_lost = 0;
    m_interrupted = false;
    return {};
}

Status SimulatedGyro::restart(std::uint32_t rateMilliHz, BridgeRange range, double nowS)
{
    SimulationOptions options = m_options;
    options.gyro.sampleRateHz = rateMilliHz / 1000.0;
    options.gyro.sensitivityMdps = range.sensitivity / 100.0;
    options.gyro.rangeDps = range.rateDps(32768);
    auto simulator = GyroSimulator::create(options, m_run);
    if (!simulator)
        return simulator.error();
    ++m_run;
    m_rateMilliHz = rateMilliHz;
    m_range = range;
    m_interrupted = false;
    m_startS = nowS;
    m_index = -1;
    m_simulator = *std::move(simulator);
    m_die.reset();
    fetch();
    m_lost = 0;
    return {};
}

void SimulatedGyro::stop()
{
    m_simulator.reset();
    m_next.reset();
    m_interrupted = false;
}

void SimulatedGyro::fetch()
{
    m_next = m_simulator->next();
    if (!m_next)
        return;
    const std::int64_t index = std::llround(m_next->timeS * m_rateMilliHz / 1000.0);
    m_lost = index - m_index - 1;
    m_index = index;
    if (!m_die)
        m_die.emplace(m_options.gyro.packageLagS, 1000.0 / m_rateMilliHz, m_next->temperatureC);
    m_die->advance(m_next->temperatureC);
}

std::optional<double> SimulatedGyro::dueS() const
{
    if (!m_next || m_interrupted)
        return std::nullopt;
    return m_startS + m_next->timeS;
}

SimulatedGyro::Sample SimulatedGyro::take()
{
    Sample taken;
    taken.dueS = m_startS + m_next->timeS;
    taken.lostBefore = static_cast<std::uint32_t>(m_lost);
    for (int axis = 0; axis < 3; ++axis)
        taken.sample.counts[axis] = countsOf(m_next->rateDps[axis], m_range);
    taken.sample.die_valid = true;
    taken.sample.die_millic = milliC(m_die->value());
    taken.sample.external_valid = m_externalThermometer;
    taken.sample.external_millic = m_externalThermometer ? milliC(m_next->temperatureC) : 0;
    fetch();
    return taken;
}

} // namespace driftbench
