// z = (x - mean) / scale, column by column, with the mean and standard deviation of the training set.
#pragma once

#include <Eigen/Core>

namespace driftbench {

struct Standardiser
{
    Eigen::RowVectorXd mean;  // F
    Eigen::RowVectorXd scale; // F, > 0; 1 for a column that does not vary

    // rows: N x F; weights: N >= 0, their sum > 0
    static Standardiser fit(const Eigen::MatrixXd &rows, const Eigen::VectorXd &weights);

    Eigen::MatrixXd transform(const Eigen::MatrixXd &rows) const
    {
        return (rows.rowwise() - mean).array().rowwise() / scale.array();
    }
};

} // namespace driftbench
