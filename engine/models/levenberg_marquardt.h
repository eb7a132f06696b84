// Weighted nonlinear least squares by Levenberg-Marquardt: the p that makes loss(p) = sum_i r_i(p)^2 least.
//
//   (J^T J + lambda D) step = -J^T r
// D is the largest diagonal of J^T J so far (Marquardt 1963, More 1978), lambda follows the gain ratio as in
// Nielsen (IMM-REP-1999-05, 1999). A weight is a factor sqrt(w_i) in r_i and in the rows of J. A fit that
// does not converge is a termination reason with the best parameters so far, not an error.
#pragma once

#include "engine/base/progress.h"

#include <Eigen/Core>
#include <functional>

namespace driftbench {

struct NormalEquations
{
    Eigen::MatrixXd curvature; // J^T J, P x P; only the lower triangle is read
    Eigen::VectorXd gradient;  // J^T r, P
};

struct LeastSquaresProblem
{
    std::function<double(const Eigen::VectorXd &parameters)> loss; // r^T r; may be infinite or NaN
    // Always called right after loss() of the same parameters, so that work can be shared.
    std::function<void(const Eigen::VectorXd &parameters, NormalEquations &equations)> linearise;
};

// r (N) and, where jacobian is not null, dr/dp (N x P), both already allocated; weights: N, of the squares.
using ResidualFunction = std::function<void(const Eigen::VectorXd &parameters, Eigen::VectorXd &residuals,
                                            Eigen::MatrixXd *jacobian)>;
LeastSquaresProblem problemFromResiduals(ResidualFunction function, const Eigen::VectorXd &weights);

struct LevenbergMarquardtOptions
{
    int iterations = 200; // trial steps, accepted or not
    double initialDamping = 1e-3;
    // Converged when the loss fell by less than this part of itself in so many accepted steps in a row,
    double smallDecrease = 1e-14;
    int smallDecreases = 3;
    // or the step is shorter than this part of the parameters (both in the scale of D),
    double smallStep = 1e-12;
    // or the residuals are at right angles to every column of J but for this cosine.
    double smallGradient = 1e-13;
};

enum class LmTermination
{
    SmallDecrease,
    SmallStep,
    SmallGradient,
    IterationLimit,
    Stopped,       // by the hook
    StartNotFinite // the loss at the start is infinite or NaN: nothing was done
};

struct LevenbergMarquardtSummary
{
    double initialLoss = 0.0;
    double finalLoss = 0.0;
    int iterations = 0; // trial steps
    int accepted = 0;
    LmTermination termination = LmTermination::IterationLimit;

    bool converged() const;
};

// parameters: the start, on return the best found. The hook is asked once in each iteration.
LevenbergMarquardtSummary minimise(const LeastSquaresProblem &problem, Eigen::VectorXd &parameters,
                                   const LevenbergMarquardtOptions &options = {},
                                   const ProgressHook &hook = {});

} // namespace driftbench
