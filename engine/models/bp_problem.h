// One axis of the BP network as a least-squares problem over cells:
//   loss(p) = sum_i w_i (f(z_i; p) - t_i)^2 / sum_i w_i      f = b2 + w2 . tanh(W1 z + b1)
// p = [W1 by columns (H, H) | b1 (H) | w2 (H) | b2], 4 H + 1 numbers.
#pragma once

#include "engine/base/random.h"
#include "engine/models/bp_network.h"
#include "engine/models/levenberg_marquardt.h"

#include <Eigen/Core>

namespace driftbench {

class BpProblem
{
public:
    // inputs: N x 2, standardised; targets, weights: N
    BpProblem(const Eigen::MatrixXd &inputs, const Eigen::VectorXd &targets, const Eigen::VectorXd &weights,
              int hiddenUnits);

    Eigen::Index parameterCount() const { return 4 * m_hidden + 1; }

    double loss(const Eigen::VectorXd &parameters);
    // At the parameters that loss() was last called with.
    void linearise(const Eigen::VectorXd &parameters, NormalEquations &equations);

    const Eigen::VectorXd &residuals() const { return m_residuals; } // weighted, after loss()
    const Eigen::MatrixXd &jacobian() const { return m_jacobian; }   // N x P, weighted, after linearise()

    // Hidden units spread over the inputs after Nguyen & Widrow (1990), the output layer by least squares.
    Eigen::VectorXd randomStart(Random &random);

    static BpNetwork::Axis network(const Eigen::VectorXd &parameters);

private:
    void activate(const Eigen::VectorXd &parameters);

    const Eigen::MatrixXd &m_inputs;
    Eigen::VectorXd m_targets;
    Eigen::VectorXd m_rootWeights;
    Eigen::Index m_hidden;
    Eigen::MatrixXd m_activation; // N x H
    Eigen::VectorXd m_residuals;
    Eigen::MatrixXd m_jacobian;
};

} // namespace driftbench
