// Dynamic temperature-correlated quantities: what the temperature does, beside what it is. An experiment, off
// by default: on recorded logs they have not survived nested hold-out.
//
// Rate of change: slope of the least-squares line through T over a centred window, degrees Celsius per
// second. At a gap in time, and at the ends, the window takes what lies on this side. Lag: T - L, degrees
// Celsius, with L the first-order low-pass of T, tau dL/dt = T - L, started at L = T. For T linear between
// samples this is integrated exactly; in a ramp dT/dt = r the lag tends to r tau, and after a step it falls
// as exp(-t / tau). After a gap L starts anew.
#pragma once

#include <Eigen/Core>

namespace driftbench {

// Samples further apart than this many median intervals have a gap between them.
inline constexpr double kDynamicGapFactor = 5.0;

// timeS: N rising times. windowS > 0: the whole width. N -> N. Alone between gaps, a sample has the rate 0.
Eigen::VectorXd temperatureRate(const Eigen::VectorXd &timeS, const Eigen::VectorXd &temperatureC,
                                double windowS);

// timeConstantS > 0. N -> N.
Eigen::VectorXd temperatureLag(const Eigen::VectorXd &timeS, const Eigen::VectorXd &temperatureC,
                               double timeConstantS);

} // namespace driftbench
