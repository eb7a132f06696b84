// Joins rates that have no temperature of their own with temperatures that come at other times: a sample gets
// the temperature interpolated linearly between the readings before and after it, the first or last reading
// outside of them.
#pragma once

#include "engine/formats/sample_block.h"

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

namespace driftbench {

class TemperatureJoin
{
public:
    // Samples that wait for the next reading; beyond this they take the last one, so that memory is bounded.
    static constexpr std::size_t kMostWaiting = std::size_t{1} << 18;

    explicit TemperatureJoin(BlockBuffer &buffer) : m_buffer(buffer) {}

    Flow addRate(double timeS, const Eigen::Vector3d &rateDps);
    Flow addTemperature(double timeS, double temperatureC);
    Flow finish(); // hands on what still waits

private:
    struct Waiting
    {
        double timeS;
        Eigen::Vector3d rateDps;
    };
    double temperatureAt(double timeS, double nextTimeS, double nextTemperatureC) const;

    BlockBuffer &m_buffer;
    std::vector<Waiting> m_waiting;
    double m_lastTimeS = 0.0;
    double m_lastTemperatureC = std::numeric_limits<double>::quiet_NaN();
};

} // namespace driftbench
