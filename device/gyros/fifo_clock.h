// When the samples of a gyro were taken, from the host times at which its FIFO was seen at some level.
//
// A gyro has no time stamps, and its data rate differs from the nominal one by several percent and drifts
// with temperature. Sample n (from 0) is taken at a + n p. Seeing N samples taken says that the last one is
// up to p old, so on average t = a + (N - 1/2) p, with an error uniform within p/2, plus the jitter of the
// look. A Kalman filter on (a, p) follows both, p as a random walk.
//
// Times are host times in seconds. No errors.
#pragma once

#include <cstdint>

namespace driftbench {

class FifoClock
{
public:
    explicit FifoClock(double nominalRateHz);

    // At atS, give or take jitterS, so many samples had been taken, lost ones included.
    void see(std::int64_t taken, double atS, double jitterS);

    bool started() const { return m_started; }
    double periodS() const { return m_periodS; }
    double timeS(std::int64_t sample) const;
    double takenAt(double timeS) const;      // fractional: right on average when rounded
    double takenErrorAt(double timeS) const; // standard deviation of that, in samples

private:
    bool m_started = false;
    std::int64_t m_anchor = 0; // the sample that m_anchorS is the time of
    double m_anchorS = 0.0;
    double m_periodS;
    // Covariance of (m_anchorS, m_periodS).
    double m_varianceS = 0.0;
    double m_covariance = 0.0;
    double m_periodVariance = 0.0;
};

} // namespace driftbench
