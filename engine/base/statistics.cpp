#include "engine/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace driftbench {

double median(std::vector<double> values)
{
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1)
        return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double robustSigma(std::vector<double> values)
{
    const double centre = median(values);
    for (double &value : values)
        value = std::abs(value - centre);
    return 1.4826 * median(std::move(values));
}

double mean(std::span<const double> values)
{
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

namespace {

// Continued fraction of the incomplete beta function (DLMF 8.17.22) by the modified Lentz method.
double betaContinuedFraction(double a, double b, double x)
{
    constexpr double kTiny = 1e-300;
    const auto awayFromZero = [](double v) { return std::abs(v) < kTiny ? kTiny : v; };
    double c = 1.0;
    double d = 1.0 / awayFromZero(1.0 - (a + b) * x / (a + 1.0));
    double result = d;
    for (int m = 1; m <= 300; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        d = 1.0 / awayFromZero(1.0 + even * d);
        c = awayFromZero(1.0 + even / c);
        result *= d * c;
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1.0 / awayFromZero(1.0 + odd * d);
        c = awayFromZero(1.0 + odd / c);
        result *= d * c;
        if (std::abs(d * c - 1.0) < 1e-15)
            break;
    }
    return result;
}

// std::lgamma leaves the sign in a global variable, which several threads must not write.
double logGamma(double x)
{
    int sign = 0;
    return ::lgamma_r(x, &sign);
}

double regularisedBeta(double a, double b, double x)
{
    if (x <= 0.0)
        return 0.0;
    if (x >= 1.0)
        return 1.0;
    const double front =
        std::exp(logGamma(a + b) - logGamma(a) - logGamma(b) + a * std::log(x) + b * std::log1p(-x));
    if (x < (a + 1.0) / (a + b + 2.0))
        return front * betaContinuedFraction(a, b, x) / a;
    return 1.0 - front * betaContinuedFraction(b, a, 1.0 - x) / b;
}

} // namespace

double studentTwoSided(double confidence, double degreesOfFreedom)
{
    const double nu = degreesOfFreedom;
    const auto outside = [nu](double t) { return regularisedBeta(0.5 * nu, 0.5, nu / (nu + t * t)); };
    double low = 0.0;
    double high = 1.0;
    while (outside(high) > 1.0 - confidence && high < 1e12)
        high *= 2.0;
    for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
        const double middle = 0.5 * (low + high);
        (outside(middle) > 1.0 - confidence ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace driftbench
