// Small statistics that more than one folder needs.
#pragma once

#include <limits>
#include <span>
#include <vector>

namespace driftbench {

// A figure that does not exist here: nothing to compare with, too few values.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Of an empty span: NaN. The argument is taken by value because the order of its elements is lost.
double median(std::vector<double> values);

// 1.4826 times the median distance from the median: the standard deviation of normal data, deaf to outliers.
double robustSigma(std::vector<double> values);

double mean(std::span<const double> values);

// The quantile t of Student's distribution with P(|t'| < t) = confidence, degreesOfFreedom >= 1.
// Found by bisection on the regularised incomplete beta function (continued fraction, Lentz's method).
double studentTwoSided(double confidence, double degreesOfFreedom);

} // namespace driftbench
