// tanh of a whole array. By the exponential, which Eigen computes several values at a time; the error is
// below 3e-16 absolute, and the same formula trains and predicts.
#pragma once

#include <Eigen/Core>

namespace driftbench {

inline void tanhInPlace(Eigen::MatrixXd &x)
{
    x = 1.0 - 2.0 / ((2.0 * x.array()).exp() + 1.0);
}

} // namespace driftbench
