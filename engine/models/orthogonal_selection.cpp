#include "engine/models/orthogonal_selection.h"

#include <cmath>

namespace driftbench {

namespace {

// A candidate that is left with less than this part of its squared length adds nothing but rounding errors.
constexpr double kSmallestNewPart = 1e-6;

} // namespace

OrthogonalSelection::OrthogonalSelection(Eigen::MatrixXd candidates, Eigen::MatrixX3d targets,
                                         Eigen::Index mostColumns, double ridge)
    : m_candidates(std::move(candidates))
    , m_targets(std::move(targets))
    , m_ridge(ridge)
    , m_orthonormal(m_targets.rows(), mostColumns)
    , m_triangle(Eigen::MatrixXd::Zero(mostColumns, mostColumns))
    , m_coefficients(mostColumns, 3)
    , m_length(m_candidates.colwise().squaredNorm().transpose())
    , m_rest(m_length)
    , m_product(m_candidates.transpose() * m_targets)
{
}

bool OrthogonalSelection::take(const Eigen::VectorXd &column, bool forced)
{
    Eigen::VectorXd rest = column;
    const auto basis = m_orthonormal.leftCols(m_columns);
    Eigen::VectorXd along = basis.transpose() * rest;
    rest -= basis * along;
    const Eigen::VectorXd again = basis.transpose() * rest; // the second pass removes what rounding left
    rest -= basis * again;
    along += again;
    const double square = rest.squaredNorm();
    if (!(square > kSmallestNewPart * column.squaredNorm()) &&
        !(forced && square > 1e-20 * column.squaredNorm()))
        return false;
    const double length = std::sqrt(square);
    m_triangle.col(m_columns).head(m_columns) = along;
    m_triangle(m_columns, m_columns) = length;
    m_orthonormal.col(m_columns) = rest / length;
    const Eigen::RowVector3d projection = m_orthonormal.col(m_columns).transpose() * m_targets;
    m_coefficients.row(m_columns) = projection * (forced ? 1.0 : square / (square + m_ridge));
    removeFromCandidates(m_orthonormal.col(m_columns), projection);
    ++m_columns;
    return true;
}

Eigen::Index OrthogonalSelection::best() const
{
    Eigen::Index winner = -1;
    double most = 0.0;
    for (Eigen::Index j = 0; j < m_rest.size(); ++j) {
        if (m_rest[j] <= kSmallestNewPart * m_length[j])
            continue;
        const double explained = m_product.row(j).squaredNorm() / (m_rest[j] + m_ridge);
        if (explained > most) {
            most = explained;
            winner = j;
        }
    }
    return winner;
}

void OrthogonalSelection::removeFromCandidates(const Eigen::VectorXd &direction,
                                               const Eigen::RowVector3d &projection)
{
    if (m_candidates.cols() == 0)
        return;
    const Eigen::VectorXd along = m_candidates.transpose() * direction;
    m_rest -= along.cwiseAbs2();
    m_product -= along * projection;
}

} // namespace driftbench
