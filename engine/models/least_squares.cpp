#include "engine/models/least_squares.h"

#include <Eigen/QR>

#include <algorithm>
#include <limits>

namespace driftbench {

Eigen::MatrixXd solveLeastSquares(const Eigen::MatrixXd &design, const Eigen::MatrixXd &targets)
{
    if (design.rows() == 0)
        return Eigen::MatrixXd::Zero(design.cols(), targets.cols());
    Eigen::RowVectorXd length = design.colwise().norm();
    length = (length.array() > 0.0).select(length, 1.0);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
    factors.setThreshold(std::numeric_limits<double>::epsilon() * static_cast<double>(design.cols()));
    factors.compute(design.array().rowwise() / length.array());
    return factors.solve(targets).array().colwise() / length.transpose().array();
}

Eigen::MatrixXd triangleOf(const Eigen::MatrixXd &rows)
{
    // By blocks that stay in the cache: the triangle so far goes on top of the next block.
    constexpr Eigen::Index kBlock = 512;
    const Eigen::Index columns = rows.cols();
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(columns, columns);
    Eigen::MatrixXd block(columns + kBlock, columns);
    for (Eigen::Index first = 0; first < rows.rows(); first += kBlock) {
        const Eigen::Index count = std::min(kBlock, rows.rows() - first);
        block.topRows(columns) = triangle;
        block.middleRows(columns, count) = rows.middleRows(first, count);
        const Eigen::HouseholderQR<Eigen::MatrixXd> factors(block.topRows(columns + count));
        triangle = factors.matrixQR().topRows(columns).triangularView<Eigen::Upper>();
    }
    return triangle;
}

Eigen::MatrixXd solveJoined(const Eigen::MatrixXd &rows, Eigen::Index features)
{
    return solveLeastSquares(rows.leftCols(features), rows.rightCols(rows.cols() - features));
}

Eigen::MatrixXd powersOf(const Eigen::VectorXd &x, int degree)
{
    Eigen::MatrixXd powers(x.size(), degree + 1);
    powers.col(0).setOnes();
    for (int k = 1; k <= degree; ++k)
        powers.col(k) = powers.col(k - 1).cwiseProduct(x);
    return powers;
}

} // namespace driftbench
