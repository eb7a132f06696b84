#include "engine/features/dynamic_quantities.h"

#include "engine/base/statistics.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace driftbench {

namespace {

double longestIntervalS(const Eigen::VectorXd &timeS)
{
    std::vector<double> intervals;
    for (Eigen::Index i = 1; i < timeS.size(); ++i)
        intervals.push_back(timeS[i] - timeS[i - 1]);
    return intervals.empty() ? std::numeric_limits<double>::infinity()
                             : kDynamicGapFactor * median(std::move(intervals));
}

// Sums of a least-squares line that samples can join and leave; times and temperatures count from the
// segment's first sample, so that little is lost to cancellation.
struct SlidingLine
{
    double count = 0.0;
    double t = 0.0;
    double tt = 0.0;
    double y = 0.0;
    double ty = 0.0;

    void add(double timeS, double temperatureC, double sign)
    {
        count += sign;
        t += sign * timeS;
        tt += sign * timeS * timeS;
        y += sign * temperatureC;
        ty += sign * timeS * temperatureC;
    }
    double slope() const { return count < 2.0 ? 0.0 : (count * ty - t * y) / (count * tt - t * t); }
};

void segmentRates(const Eigen::VectorXd &timeS, const Eigen::VectorXd &temperatureC, Eigen::Index first,
                  Eigen::Index end, double windowS, Eigen::VectorXd &rates)
{
    SlidingLine line;
    Eigen::Index in = first;
    Eigen::Index out = first;
    const auto move = [&](Eigen::Index i, double sign) {
        line.add(timeS[i] - timeS[first], temperatureC[i] - temperatureC[first], sign);
    };
    for (Eigen::Index i = first; i < end; ++i) {
        for (; in < end && timeS[in] <= timeS[i] + 0.5 * windowS; ++in)
            move(in, 1.0);
        for (; timeS[out] < timeS[i] - 0.5 * windowS; ++out)
            move(out, -1.0);
        rates[i] = line.slope();
    }
}

} // namespace

Eigen::VectorXd temperatureRate(const Eigen::VectorXd &timeS, const Eigen::VectorXd &temperatureC,
                                double windowS)
{
    assert(timeS.size() == temperatureC.size() && windowS > 0.0);
    const double longestS = longestIntervalS(timeS);
    Eigen::VectorXd rates(timeS.size());
    for (Eigen::Index first = 0; first < timeS.size();) {
        Eigen::Index end = first + 1;
        while (end < timeS.size() && timeS[end] - timeS[end - 1] <= longestS)
            ++end;
        segmentRates(timeS, temperatureC, first, end, windowS, rates);
        first = end;
    }
    return rates;
}

Eigen::VectorXd temperatureLag(const Eigen::VectorXd &timeS, const Eigen::VectorXd &temperatureC,
                               double timeConstantS)
{
    assert(timeS.size() == temperatureC.size() && timeConstantS > 0.0);
    const double longestS = longestIntervalS(timeS);
    Eigen::VectorXd lags(timeS.size());
    double lag = 0.0;
    for (Eigen::Index i = 0; i < timeS.size(); ++i) {
        const double intervalS = i == 0 ? 0.0 : timeS[i] - timeS[i - 1];
        if (i == 0 || intervalS > longestS) {
            lag = 0.0;
        } else {
            // d lag/dt = slope - lag / tau, solved over the interval.
            const double decay = std::exp(-intervalS / timeConstantS);
            const double slope = (temperatureC[i] - temperatureC[i - 1]) / intervalS;
            lag = lag * decay + slope * timeConstantS * (1.0 - decay);
        }
        lags[i] = lag;
    }
    return lags;
}

} // namespace driftbench
