#include "engine/physics/tangent_series.h"

#include <cassert>
#include <cmath>

namespace driftbench {

namespace {

// Inside this circle the closed forms lose digits to cancellation; the series needs 28 terms at its edge.
constexpr double kSeriesRadius = 0.25;
constexpr int kSeriesTerms = 28;

double closedForm(double z)
{
    if (z < 0.0) {
        const double root = std::sqrt(-z);
        return std::atan(root) / root;
    }
    // The logarithm of a quotient that is exact where z nears one, where atanh(sqrt z) would lose 1 - z.
    const double root = std::sqrt(z);
    return 0.5 * std::log((1.0 + root) * (1.0 + root) / (1.0 - z)) / root;
}

} // namespace

double tangentSeries(int order, double z)
{
    assert((order == 1 || order == 3) && z < 1.0);
    if (std::abs(z) > kSeriesRadius)
        return order == 1 ? closedForm(z) : (closedForm(z) - 1.0) / z;
    double sum = 0.0;
    for (int k = kSeriesTerms; k >= 0; --k)
        sum = sum * z + 1.0 / (2 * k + order);
    return sum;
}

double tangentSeriesSlope(int order, double z)
{
    assert((order == 1 || order == 3) && z < 1.0);
    if (std::abs(z) > kSeriesRadius)
        return (1.0 / (1.0 - z) - order * tangentSeries(order, z)) / (2.0 * z);
    double sum = 0.0;
    for (int k = kSeriesTerms; k >= 1; --k)
        sum = sum * z + static_cast<double>(k) / (2 * k + order);
    return sum;
}

} // namespace driftbench
