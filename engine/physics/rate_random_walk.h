// Rate random walk of a gyro on three axes: a bias whose increments are independent (IEEE Std 952-1997,
// C.1.1.4). With the coefficient K in dps/sqrt(s) its variance grows by K^2 each second from 0 at the start,
// and its Allan deviation is K sqrt(tau / 3).
//
// The increments are drawn for nodes, those of the flicker noise, and joined by straight lines;
// from 10 nodes on the Allan deviation is that of the walk itself.
#pragma once

#include "engine/base/random.h"
#include "engine/physics/flicker_noise.h"

#include <Eigen/Core>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace driftbench {

class RateRandomWalk
{
public:
    RateRandomWalk(double walkDpsPerRootS, double sampleRateHz, const Random &random)
        : m_samplesPerNode(samplesPerNoiseNode(sampleRateHz))
        , m_stepScaleDps(walkDpsPerRootS / std::sqrt(static_cast<double>(m_samplesPerNode) * sampleRateHz))
        , m_random(random)
    {
        assert(walkDpsPerRootS >= 0.0 && sampleRateHz > 0.0);
    }

    void advance()
    {
        if (m_samplesLeft == 0) {
            for (double &step : m_stepDps)
                step = m_stepScaleDps * m_random.normal();
            m_samplesLeft = m_samplesPerNode;
        }
        --m_samplesLeft;
        m_rateDps += m_stepDps;
    }
    const Eigen::Vector3d &rateDps() const { return m_rateDps; }

private:
    std::int64_t m_samplesPerNode;
    double m_stepScaleDps; // per sample: K sqrt(node) / samples of a node
    std::int64_t m_samplesLeft = 0;
    Eigen::Vector3d m_rateDps = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_stepDps = Eigen::Vector3d::Zero();
    Random m_random;
};

} // namespace driftbench
