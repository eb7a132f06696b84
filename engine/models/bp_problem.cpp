#include "engine/models/bp_problem.h"

#include "engine/models/bp_activation.h"
#include "engine/models/least_squares.h"

#include <cmath>
#include <numbers>

namespace driftbench {

BpProblem::BpProblem(const Eigen::MatrixXd &inputs, const Eigen::VectorXd &targets,
                     const Eigen::VectorXd &weights, int hiddenUnits)
    : m_inputs(inputs)
    , m_targets(targets)
    , m_rootWeights((weights / weights.sum()).cwiseSqrt())
    , m_hidden(hiddenUnits)
    , m_activation(inputs.rows(), hiddenUnits)
    , m_residuals(inputs.rows())
    , m_jacobian(inputs.rows(), 4 * hiddenUnits + 1)
{
    m_jacobian.rightCols<1>() = m_rootWeights;
}

void BpProblem::activate(const Eigen::VectorXd &parameters)
{
    const Eigen::Index h = m_hidden;
    m_activation.noalias() = m_inputs.col(0) * parameters.head(h).transpose();
    m_activation.noalias() += m_inputs.col(1) * parameters.segment(h, h).transpose();
    m_activation.rowwise() += parameters.segment(2 * h, h).transpose();
    tanhInPlace(m_activation);
}

double BpProblem::loss(const Eigen::VectorXd &parameters)
{
    activate(parameters);
    m_residuals.noalias() = m_activation * parameters.segment(3 * m_hidden, m_hidden);
    m_residuals.array() += parameters[4 * m_hidden];
    m_residuals = (m_residuals - m_targets).cwiseProduct(m_rootWeights);
    return m_residuals.squaredNorm();
}

void BpProblem::linearise(const Eigen::VectorXd &parameters, NormalEquations &equations)
{
    const Eigen::Index h = m_hidden;
    const auto outputWeights = parameters.segment(3 * h, h);
    for (Eigen::Index unit = 0; unit < h; ++unit) {
        const auto t = m_activation.col(unit).array();
        // dr/db1; those of the weights are this times the inputs.
        m_jacobian.col(2 * h + unit) = m_rootWeights.array() * (1.0 - t.square()) * outputWeights[unit];
        m_jacobian.col(unit) = m_jacobian.col(2 * h + unit).cwiseProduct(m_inputs.col(0));
        m_jacobian.col(h + unit) = m_jacobian.col(2 * h + unit).cwiseProduct(m_inputs.col(1));
        m_jacobian.col(3 * h + unit) = m_rootWeights.array() * t;
    }
    equations.curvature.setZero();
    equations.curvature.selfadjointView<Eigen::Lower>().rankUpdate(m_jacobian.transpose());
    equations.gradient.noalias() = m_jacobian.transpose() * m_residuals;
}

Eigen::VectorXd BpProblem::randomStart(Random &random)
{
    const Eigen::Index h = m_hidden;
    const double slope = 0.7 * std::sqrt(static_cast<double>(h));
    Eigen::VectorXd parameters = Eigen::VectorXd::Zero(parameterCount());
    for (Eigen::Index unit = 0; unit < h; ++unit) {
        const double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
        const auto at = static_cast<Eigen::Index>(random.below(static_cast<std::uint64_t>(m_inputs.rows())));
        parameters[unit] = slope * std::cos(direction);
        parameters[h + unit] = slope * std::sin(direction);
        // The unit turns over at one of the cells: elsewhere it would say nothing.
        parameters[2 * h + unit] =
            -(parameters[unit] * m_inputs(at, 0) + parameters[h + unit] * m_inputs(at, 1));
    }
    activate(parameters);
    Eigen::MatrixXd rows(m_inputs.rows(), h + 2);
    rows << m_activation, Eigen::VectorXd::Ones(m_inputs.rows()), m_targets;
    rows.array().colwise() *= m_rootWeights.array();
    parameters.tail(h + 1) = solveJoined(rows, h + 1);
    return parameters;
}

BpNetwork::Axis BpProblem::network(const Eigen::VectorXd &parameters)
{
    const Eigen::Index h = (parameters.size() - 1) / 4;
    BpNetwork::Axis axis;
    axis.hiddenWeights = Eigen::Map<const Eigen::MatrixXd>(parameters.data(), h, 2);
    axis.hiddenBias = parameters.segment(2 * h, h);
    axis.outputWeights = parameters.segment(3 * h, h);
    axis.outputBias = parameters[4 * h];
    return axis;
}

} // namespace driftbench
