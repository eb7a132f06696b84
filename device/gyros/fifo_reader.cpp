#include "device/gyros/fifo_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace driftbench {

using namespace st_gyro;

namespace {

// Well below 32: what comes while a slow bridge fetches must find room; and no longer than a user waits for
// a stop. The fraction (of the golden section) makes looks fall on all phases between two samples, so that
// the errors of rounding to whole samples cancel.
constexpr double kSamplesWorthALook = 12.0;
constexpr double kLongestWaitS = 0.2;
constexpr double kFraction = 0.382;
// Until then the gyro has settled, and the clock knows its data rate within some 0.2 %.
constexpr int kWarmUpLooks = 12;
constexpr double kErrorsForALoss = 3.0;

} // namespace

FifoReader::FifoReader(StGyro &gyro, HostClock &clock, std::size_t longestRead)
    : m_gyro(gyro)
    , m_clock(clock)
    , m_samplesPerRead(longestRead / kBytesPerSample)
    , m_fifoClock(gyro.nominalRateHz())
{
}

Status FifoReader::start()
{
    return m_gyro.restartFifo();
}

Result<FifoBurst> FifoReader::next()
{
    if (m_fatal)
        return *m_fatal;
    const Result<Look> now = look();
    if (!now) {
        if (const Status ok = overcome(now.error()); !ok)
            return ok.error();
        return FifoBurst{};
    }
    ++m_looks;
    m_shortestLookS = std::min(m_shortestLookS, now->endedS - now->beganS);
    const FifoBurst burst = settle(&*now);
    const bool levelCounts = !now->state.full && !m_restarted;
    if (levelCounts || !m_fifoClock.started())
        m_fifoClock.see(m_taken + now->state.samples, now->atS(), jitterS(*now));
    if (const Status fetched = fetch(*now); fetched) {
        m_failures = 0;
    } else if (const Status ok = overcome(fetched.error()); !ok) {
        m_fatal = ok.error(); // after the burst has been delivered
    }
    return burst;
}

FifoBurst FifoReader::last()
{
    return settle(nullptr);
}

void FifoReader::wait() const
{
    const double nowS = m_clock.nowS();
    const double periodS = m_fifoClock.periodS();
    const double samples = std::min(kSamplesWorthALook, std::floor(kLongestWaitS / periodS)) + kFraction;
    double restS = std::max(0.0, m_heldLook.beganS + samples * periodS - nowS);
    // The look that tells how many samples are missing falls midway between two of them, where an error of
    // the clock counts least.
    if (m_heldSuspect && m_held.samples > 0) {
        const double lookS = nowS + restS + 0.5 * (m_heldLook.endedS - m_heldLook.beganS);
        const double taken = m_fifoClock.takenAt(lookS);
        restS += (std::ceil(taken) - taken) * periodS;
    }
    if (restS > 0.0)
        m_clock.waitS(restS);
}

std::optional<Error> FifoReader::takeFailure()
{
    return std::exchange(m_failure, std::nullopt);
}

Result<FifoReader::Look> FifoReader::look()
{
    Look now;
    now.beganS = m_clock.nowS();
    const Result<FifoState> state = m_gyro.fifoState();
    if (!state)
        return state.error();
    now.endedS = m_clock.nowS();
    now.state = *state;
    return now;
}

// A delay that all looks have is no error, only one more phase.
double FifoReader::jitterS(const Look &look) const
{
    return 0.5 * (look.endedS - look.beganS - m_shortestLookS);
}

Status FifoReader::fetch(const Look &look)
{
    std::array<std::uint8_t, kFifoSamples * kBytesPerSample> bytes{};
    const auto samples = static_cast<std::size_t>(look.state.samples);
    for (std::size_t first = 0; first < samples; first += m_samplesPerRead) {
        const std::size_t count = std::min(m_samplesPerRead, samples - first);
        if (const Status ok =
                m_gyro.readFifo(std::span(bytes).subspan(first * kBytesPerSample, count * kBytesPerSample));
            !ok)
            return ok;
    }
    m_heldLook = look;
    m_held = {};
    m_held.samples = look.state.samples;
    for (std::size_t i = 0; i < samples; ++i)
        m_held.counts[i] = decodeCounts(bytes, i);
    const double meanwhile = (m_clock.nowS() - look.beganS) / m_fifoClock.periodS();
    const bool mayHaveRunOver = look.state.full || look.state.samples + meanwhile + 1.0 > kFifoSamples;
    m_heldSuspect = mayHaveRunOver || m_restarted;
    m_held.lostInTransfer = m_restarted;
    if (samples > 0)
        m_restarted = false;
    return {};
}

// Without a look: with what is known.
FifoBurst FifoReader::settle(const Look *look)
{
    if (m_held.samples > 0 && m_heldSuspect && m_taken > 0)
        m_held.lostBefore = lostBeforeHeld(look);
    FifoBurst burst = std::exchange(m_held, {});
    m_taken += burst.lostBefore;
    if (burst.samples == 0)
        return burst;
    if (m_looks <= kWarmUpLooks) {
        m_taken += burst.samples;
        return {};
    }
    burst.firstSample = m_delivered;
    setTimes(burst);
    m_taken += burst.samples;
    m_delivered += burst.samples;
    return burst;
}

std::int64_t FifoReader::lostBeforeHeld(const Look *look) const
{
    const bool useLook = look != nullptr && !look->state.full && !m_restarted;
    const Look &by = useLook ? *look : m_heldLook;
    const int seen = useLook ? m_held.samples + look->state.samples : m_heldLook.state.samples;
    const double missing = m_fifoClock.takenAt(by.atS()) - static_cast<double>(m_taken + seen);
    // A FIFO that only may have run over must not lose samples to a clock that is not sure, or to a look that
    // the host delayed.
    const double doubt =
        kErrorsForALoss * m_fifoClock.takenErrorAt(by.atS()) + jitterS(by) / m_fifoClock.periodS();
    const bool surelyLost = m_heldLook.state.full || m_held.lostInTransfer;
    if (!surelyLost && missing < 0.5 + doubt)
        return 0;
    return std::max<std::int64_t>(0, std::llround(missing));
}

// Corrections of the clock are spread over the burst, so that time never goes backwards.
void FifoReader::setTimes(FifoBurst &burst)
{
    const double periodS = m_fifoClock.periodS();
    burst.firstS = m_fifoClock.timeS(m_taken);
    burst.lastS = m_fifoClock.timeS(m_taken + burst.samples - 1);
    if (m_delivered == 0) {
        burst.lostBefore = 0; // nothing is before it
    } else {
        burst.lastS = std::max(burst.lastS, m_lastS + 0.5 * periodS * burst.samples);
        burst.firstS = burst.lostBefore > 0 ? std::clamp(burst.firstS, m_lastS + 0.5 * periodS, burst.lastS)
                                            : m_lastS + (burst.lastS - m_lastS) / burst.samples;
    }
    m_lastS = burst.lastS;
}

Status FifoReader::overcome(const Error &error)
{
    const bool transient = error.code == Errc::BusNoAcknowledge || error.code == Errc::BusStuck ||
                           error.code == Errc::DamagedReport || error.code == Errc::DeviceSilent;
    if (!transient || ++m_failures > kMostFailures)
        return error;
    m_failure = error;
    m_restarted = true;
    if (const Status ok = m_gyro.restartFifo(); !ok)
        return overcome(ok.error());
    return {};
}

} // namespace driftbench
