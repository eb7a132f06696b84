#include "device/gyros/fifo_clock.h"

#include <cmath>

namespace driftbench {

namespace {

// Relative: how far a data rate may lie off the nominal one, and how far it walks with each sample. The
// latter lets the filter follow 1 % per 100 C at 1 C a minute within 0.02 samples at 100 Hz.
constexpr double kRateTolerance = 0.1;
constexpr double kRateWalk = 1e-6;

constexpr double square(double x)
{
    return x * x;
}

} // namespace

FifoClock::FifoClock(double nominalRateHz) : m_periodS(1.0 / nominalRateHz) {}

void FifoClock::see(std::int64_t taken, double atS, double jitterS)
{
    // Variances of uniform distributions.
    const double noise = square(m_periodS) / 12.0 + square(jitterS) / 3.0;
    if (!m_started) {
        m_started = true;
        m_anchor = taken;
        m_anchorS = atS + 0.5 * m_periodS;
        m_varianceS = noise;
        m_periodVariance = square(kRateTolerance * m_periodS);
        return;
    }
    const auto steps = static_cast<double>(taken - m_anchor);
    m_anchor = taken;
    m_anchorS += steps * m_periodS;
    m_varianceS += steps * (2.0 * m_covariance + steps * m_periodVariance);
    m_covariance += steps * m_periodVariance;
    m_periodVariance += steps * square(kRateWalk * m_periodS);

    // What is seen is a - p/2 of the moved anchor.
    const double innovationS = atS - (m_anchorS - 0.5 * m_periodS);
    const double toAnchor = m_varianceS - 0.5 * m_covariance;
    const double toPeriod = m_covariance - 0.5 * m_periodVariance;
    const double total = toAnchor - 0.5 * toPeriod + noise;
    m_anchorS += toAnchor / total * innovationS;
    m_periodS += toPeriod / total * innovationS;
    m_varianceS -= toAnchor * toAnchor / total;
    m_covariance -= toAnchor * toPeriod / total;
    m_periodVariance -= toPeriod * toPeriod / total;
}

double FifoClock::timeS(std::int64_t sample) const
{
    return m_anchorS + static_cast<double>(sample - m_anchor) * m_periodS;
}

double FifoClock::takenAt(double timeS) const
{
    return static_cast<double>(m_anchor) + (timeS - m_anchorS) / m_periodS + 0.5;
}

double FifoClock::takenErrorAt(double timeS) const
{
    const double steps = (timeS - m_anchorS) / m_periodS;
    return std::sqrt(m_varianceS + steps * (2.0 * m_covariance + steps * m_periodVariance)) / m_periodS;
}

} // namespace driftbench
