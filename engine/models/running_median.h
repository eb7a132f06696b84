// Median over a window that slides along a series, as scipy.signal.medfilt: beyond both ends there are zeros.
#pragma once

#include <Eigen/Core>

namespace driftbench {

inline constexpr int kMedianWindow = 31;

// N values -> N medians, that of values i - 15 .. i + 15 at i. Values must be finite.
Eigen::VectorXd runningMedian(const Eigen::VectorXd &values);

} // namespace driftbench
