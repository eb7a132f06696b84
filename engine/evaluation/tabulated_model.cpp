#include "engine/evaluation/tabulated_model.h"

#include "engine/features/temperature_quantities.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr double kSpacingC = 0.1;
constexpr double kToleranceDps = 1e-5;
constexpr Eigen::Index kFewestNodes = 8;
constexpr Eigen::Index kSamplesPerNode = 4;

// One side of dT = 0, from root `first` to root `last`.
class Side
{
public:
    Side(double first, double last)
        : m_first(first)
        , m_nodes(std::max(kFewestNodes, static_cast<Eigen::Index>(std::ceil(
                                             (last - first) * 2.0 *
                                             std::max(std::abs(first), std::abs(last)) / kSpacingC)) +
                                             1))
        , m_spacing((last - first) / static_cast<double>(m_nodes - 1))
    {
    }

    Eigen::Index nodes() const { return m_nodes; }
    void fill(const AnyModel &model) { m_values = valuesAt(model, 0.0, m_nodes); }

    // Largest deviation half way between the nodes.
    double error(const AnyModel &model) const
    {
        const Eigen::MatrixX3d exact = valuesAt(model, 0.5, m_nodes - 1);
        double largest = 0.0;
        for (Eigen::Index i = 0; i < exact.rows(); ++i)
            largest = std::max(largest, (exact.row(i) - at(rootOf(i, 0.5))).cwiseAbs().maxCoeff());
        return largest;
    }

    Eigen::RowVector3d at(double root) const
    {
        const double position = m_spacing > 0.0 ? (root - m_first) / m_spacing : 0.0;
        const auto start = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(position) - 1, 0, m_nodes - 4);
        const double t = position - static_cast<double>(start);
        return (t - 1.0) * (t - 2.0) * (t - 3.0) / -6.0 * m_values.row(start) +
               t * (t - 2.0) * (t - 3.0) / 2.0 * m_values.row(start + 1) +
               t * (t - 1.0) * (t - 3.0) / -2.0 * m_values.row(start + 2) +
               t * (t - 1.0) * (t - 2.0) / 6.0 * m_values.row(start + 3);
    }

private:
    double rootOf(Eigen::Index node, double offset) const
    {
        return m_first + m_spacing * (static_cast<double>(node) + offset);
    }
    Eigen::MatrixX3d valuesAt(const AnyModel &model, double offset, Eigen::Index count) const
    {
        Eigen::VectorXd deltaT(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const double root = rootOf(i, offset);
            deltaT[i] = std::copysign(root * root, root);
        }
        return predictAtDeltaT(model, deltaT);
    }

    double m_first;
    Eigen::Index m_nodes;
    double m_spacing;
    Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> m_values;
};

} // namespace

Eigen::MatrixX3d predictThroughTable(const AnyModel &model, const Eigen::VectorXd &deltaT)
{
    if (deltaT.size() < kSamplesPerNode * kFewestNodes)
        return predictAtDeltaT(model, deltaT);
    const double low = signedRoot(deltaT.minCoeff());
    const double high = signedRoot(deltaT.maxCoeff());
    Side below(std::min(low, 0.0), std::min(high, 0.0));
    Side above(std::max(low, 0.0), std::max(high, 0.0));
    if (deltaT.size() < kSamplesPerNode * (below.nodes() + above.nodes()))
        return predictAtDeltaT(model, deltaT);
    below.fill(model);
    above.fill(model);
    if (!(std::max(below.error(model), above.error(model)) <= kToleranceDps))
        return predictAtDeltaT(model, deltaT);
    Eigen::MatrixX3d tde(deltaT.size(), 3);
    for (Eigen::Index i = 0; i < deltaT.size(); ++i) {
        const double root = signedRoot(deltaT[i]);
        tde.row(i) = root < 0.0 ? below.at(root) : above.at(root);
    }
    return tde;
}

} // namespace driftbench
