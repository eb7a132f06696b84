#include "engine/models/levenberg_marquardt.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace driftbench {

namespace {

// The state between two trial steps.
class Minimiser
{
public:
    Minimiser(const LeastSquaresProblem &problem, const LevenbergMarquardtOptions &options,
              Eigen::VectorXd &parameters)
        : m_problem(problem)
        , m_options(options)
        , m_parameters(parameters)
        , m_scale(Eigen::VectorXd::Zero(parameters.size()))
        , m_factor(parameters.size())
        , m_damping(options.initialDamping)
    {
        m_summary.initialLoss = m_summary.finalLoss = problem.loss(parameters);
        m_equations.curvature.resize(parameters.size(), parameters.size());
        m_equations.gradient.resize(parameters.size());
    }

    LevenbergMarquardtSummary run(const ProgressHook &hook)
    {
        if (!std::isfinite(m_summary.finalLoss))
            return finished(LmTermination::StartNotFinite);
        linearise();
        while (m_summary.iterations < m_options.iterations) {
            if (gradientIsSmall())
                return finished(LmTermination::SmallGradient);
            if (report(hook, "fitting", fractionDone()) == Flow::Stop)
                return finished(LmTermination::Stopped);
            ++m_summary.iterations;
            if (const auto reason = tryStep())
                return finished(*reason);
        }
        return finished(LmTermination::IterationLimit);
    }

private:
    LevenbergMarquardtSummary finished(LmTermination reason)
    {
        m_summary.termination = reason;
        return m_summary;
    }

    double fractionDone() const
    {
        return static_cast<double>(m_summary.iterations) / static_cast<double>(m_options.iterations);
    }

    void linearise()
    {
        m_problem.linearise(m_parameters, m_equations);
        m_scale = m_scale.cwiseMax(m_equations.curvature.diagonal());
    }

    // A parameter without any influence yet must not make the damped matrix singular.
    Eigen::VectorXd damping() const
    {
        return m_damping * (m_scale.array() > 0.0).select(m_scale, Eigen::VectorXd::Ones(m_scale.size()));
    }

    bool gradientIsSmall() const
    {
        const double residual = std::sqrt(m_summary.finalLoss);
        if (residual == 0.0)
            return true;
        const auto length = m_equations.curvature.diagonal().array().max(0.0).sqrt();
        return (m_equations.gradient.array().abs() <= m_options.smallGradient * residual * length).all();
    }

    bool stepIsSmall(const Eigen::VectorXd &step) const
    {
        const Eigen::VectorXd length = m_scale.cwiseSqrt();
        return step.cwiseProduct(length).norm() <=
               m_options.smallStep * (m_parameters.cwiseProduct(length).norm() + m_options.smallStep);
    }

    std::optional<LmTermination> tryStep()
    {
        const Eigen::VectorXd damped = damping();
        m_damped = m_equations.curvature;
        m_damped.diagonal() += damped;
        m_factor.compute(m_damped);
        if (m_factor.info() != Eigen::Success)
            return reject();
        const Eigen::VectorXd step = m_factor.solve(-m_equations.gradient);
        if (!step.allFinite())
            return reject();
        if (stepIsSmall(step))
            return LmTermination::SmallStep;
        const Eigen::VectorXd trial = m_parameters + step;
        const double loss = m_problem.loss(trial);
        const double predicted = step.dot(damped.cwiseProduct(step) - m_equations.gradient);
        if (!(loss < m_summary.finalLoss))
            return reject();
        return accept(trial, loss, predicted);
    }

    std::optional<LmTermination> reject()
    {
        m_damping *= m_growth;
        m_growth *= 2.0;
        // Damped to nothing: no step of representable length goes down.
        return std::isfinite(m_damping) ? std::nullopt : std::optional(LmTermination::SmallStep);
    }

    std::optional<LmTermination> accept(const Eigen::VectorXd &trial, double loss, double predicted)
    {
        const double decrease = m_summary.finalLoss - loss;
        const double gain = std::min(decrease / predicted, 1.0);
        m_damping *= std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * gain - 1.0, 3));
        m_damping = std::max(m_damping, std::numeric_limits<double>::min());
        m_growth = 2.0;
        m_smallInARow = decrease < m_options.smallDecrease * m_summary.finalLoss ? m_smallInARow + 1 : 0;
        m_parameters = trial;
        m_summary.finalLoss = loss;
        ++m_summary.accepted;
        if (m_smallInARow >= m_options.smallDecreases)
            return LmTermination::SmallDecrease;
        linearise();
        return std::nullopt;
    }

    const LeastSquaresProblem &m_problem;
    const LevenbergMarquardtOptions &m_options;
    Eigen::VectorXd &m_parameters;
    Eigen::VectorXd m_scale; // D
    NormalEquations m_equations;
    Eigen::MatrixXd m_damped;
    Eigen::LLT<Eigen::MatrixXd> m_factor;
    double m_damping;
    double m_growth = 2.0;
    int m_smallInARow = 0;
    LevenbergMarquardtSummary m_summary;
};

} // namespace

bool LevenbergMarquardtSummary::converged() const
{
    return termination == LmTermination::SmallDecrease || termination == LmTermination::SmallStep ||
           termination == LmTermination::SmallGradient;
}

LeastSquaresProblem problemFromResiduals(ResidualFunction function, const Eigen::VectorXd &weights)
{
    struct State
    {
        ResidualFunction function;
        Eigen::VectorXd rootWeights;
        Eigen::VectorXd residuals;
        Eigen::MatrixXd jacobian;
    };
    auto state = std::make_shared<State>(State{std::move(function), weights.cwiseSqrt(), {}, {}});
    state->residuals.resize(weights.size());
    LeastSquaresProblem problem;
    problem.loss = [state](const Eigen::VectorXd &parameters) {
        state->function(parameters, state->residuals, nullptr);
        return state->residuals.cwiseProduct(state->rootWeights).squaredNorm();
    };
    problem.linearise = [state](const Eigen::VectorXd &parameters, NormalEquations &equations) {
        state->jacobian.resize(state->residuals.size(), parameters.size());
        state->function(parameters, state->residuals, &state->jacobian);
        state->jacobian.array().colwise() *= state->rootWeights.array();
        equations.curvature.setZero();
        equations.curvature.selfadjointView<Eigen::Lower>().rankUpdate(state->jacobian.transpose());
        equations.gradient = state->jacobian.transpose() * state->residuals.cwiseProduct(state->rootWeights);
    };
    return problem;
}

LevenbergMarquardtSummary minimise(const LeastSquaresProblem &problem, Eigen::VectorXd &parameters,
                                   const LevenbergMarquardtOptions &options, const ProgressHook &hook)
{
    return Minimiser(problem, options, parameters).run(hook);
}

} // namespace driftbench
