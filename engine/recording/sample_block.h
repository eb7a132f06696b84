// Samples on their way from a reader or a simulator to whoever uses them, a block at a time: memory does not
// depend on the length of the log.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace driftbench {

struct SampleBlock
{
    std::int64_t firstSample = 0; // index of the block's first sample in the log
    Eigen::VectorXd timeS;        // N
    Eigen::VectorXd temperatureC; // N
    Eigen::MatrixX3d rateDps;     // N x 3

    Eigen::Index size() const { return timeS.size(); }

    static SampleBlock withRows(Eigen::Index rows)
    {
        return {0, Eigen::VectorXd(rows), Eigen::VectorXd(rows), Eigen::MatrixX3d(rows, 3)};
    }
};

} // namespace driftbench
