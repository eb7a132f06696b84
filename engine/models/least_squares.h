// Linear least squares: the X that makes |A X - B|^2 least, all columns of B at once.
//
// The columns of A are scaled to length one, then A is factored by Householder QR with column pivoting (Golub
// & Van Loan, ch. 5.4 and 5.5). Where A lacks rank, the shortest scaled solution is taken, as numpy's polyfit
// does. Shapes: A is N x F, B is N x T, X is F x T. No errors: without rows X is zero.
#pragma once

#include <Eigen/Core>

namespace driftbench {

Eigen::MatrixXd solveLeastSquares(const Eigen::MatrixXd &design, const Eigen::MatrixXd &targets);

// The triangle R of [A | B] = Q R holds all that least squares can learn from these rows, in (F + T) x (F +
// T) numbers. Triangles of parts put on top of each other give the same solution as all their rows. rows: N x
// (F + T), any N >= 0.
Eigen::MatrixXd triangleOf(const Eigen::MatrixXd &rows);

// rows: any [A | B], also stacked triangles; features: F
Eigen::MatrixXd solveJoined(const Eigen::MatrixXd &rows, Eigen::Index features);

// 1, x, x^2 .. x^degree in columns.
Eigen::MatrixXd powersOf(const Eigen::VectorXd &x, int degree);

} // namespace driftbench
