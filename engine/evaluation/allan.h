// Overlapping Allan deviation of rate data (IEEE Std 952-1997, Annex C; NIST SP 1065, Eq. 10).
//
//   sigma^2(m tau0) = 1 / (2 (N - 2m) tau^2) * sum_k (theta_{k+2m} - 2 theta_{k+m} + theta_k)^2
// with theta the integral of the rate, N its points (one more than samples of rate). Bias instability is the
// lowest deviation divided by sqrt(2 ln 2 / pi), read where at least nine windows fit into the data: beyond
// that the deviation of a few windows may be low by chance.
#pragma once

#include <Eigen/Core>

namespace driftbench {

struct AllanCurve
{
    Eigen::VectorXd tauS;          // averaging times, logarithmically spaced
    Eigen::MatrixX3d deviationDps; // one row each
    Eigen::Vector3d biasInstabilityDps = Eigen::Vector3d::Zero();
    Eigen::Vector3d biasInstabilityTauS = Eigen::Vector3d::Zero(); // where it was read
};

// The longest stretch without a gap (a step over 1.5 times the median interval) is used. Empty curve if that
// has fewer than 9 samples.
AllanCurve allanDeviation(const Eigen::VectorXd &timeS, const Eigen::MatrixX3d &rateDps,
                          int pointsPerDecade = 10);

} // namespace driftbench
