// Orthogonal least squares, column by column, for several targets at once (Chen, Cowan & Grant 1991).
//
// Columns that are taken are made orthonormal by classical Gram-Schmidt, twice; of the candidates that are
// not in only the squared length of their orthogonal part and its product with the targets are kept up to
// date, which is all that the choice of the next one needs. Forced columns are not shrunk; the others'
// coefficients are multiplied by v^2 / (v^2 + ridge), v the length of the orthogonal part.
#pragma once

#include <Eigen/Core>

namespace driftbench {

class OrthogonalSelection
{
public:
    // candidates: N x M, targets: N x 3 (rows and targets already weighted)
    OrthogonalSelection(Eigen::MatrixXd candidates, Eigen::MatrixX3d targets, Eigen::Index mostColumns,
                        double ridge);

    // Takes a column of N rows in, unless it depends on those that are.
    bool take(const Eigen::VectorXd &column, bool forced);

    // The candidate with the largest  sum_a c_a^2 / (v^2 + ridge),  c_a its product with what is left of
    // target a; -1 if none has anything new.
    Eigen::Index best() const;
    void strike(Eigen::Index candidate) { m_rest[candidate] = 0.0; }

    const Eigen::MatrixXd &candidates() const { return m_candidates; }
    Eigen::Index columns() const { return m_columns; }
    // Of the C columns taken: columns = orthonormal * triangle, C x C.
    Eigen::MatrixXd triangle() const { return m_triangle.topLeftCorner(m_columns, m_columns); }
    // Of the orthonormal columns, C x 3.
    Eigen::MatrixX3d coefficients() const { return m_coefficients.topRows(m_columns); }

private:
    void removeFromCandidates(const Eigen::VectorXd &direction, const Eigen::RowVector3d &projection);

    Eigen::MatrixXd m_candidates;
    Eigen::MatrixX3d m_targets;
    double m_ridge;
    Eigen::MatrixXd m_orthonormal;
    Eigen::MatrixXd m_triangle;
    Eigen::MatrixX3d m_coefficients;
    Eigen::VectorXd m_length; // squared, of the candidates as they are
    Eigen::VectorXd m_rest;   // squared, of their orthogonal parts
    Eigen::MatrixX3d m_product;
    Eigen::Index m_columns = 0;
};

} // namespace driftbench
