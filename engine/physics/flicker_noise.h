// Bias instability of a gyro: flicker noise, whose power density falls with the frequency, on three axes.
//
// With the coefficient B in dps (IEEE Std 952-1997, Annex C) the one-sided density is S(f) = B^2 / (pi f) and
// the Allan deviation is flat at B sqrt(2 ln 2 / pi) = 0.664 B. It is made of 22 first-order Gauss-Markov
// processes whose correlation times T_k = T_0 2^k are octaves apart, all of variance s^2 = B^2 ln 2 / pi:
//   x_k <- a x_k + sqrt(1 - a^2) s n,  a = exp(-h_k / T_k), n standard normal
// which is exact for a step of h_k, and started stationary. A node is the longer of 1 s and 32 samples, T_0 a
// quarter of it. h_k is one node or, where that is longer, T_k / 4, so that six normal numbers per node and
// axis are enough for a run of any length; in between a process goes along straight lines. They take a share
// of (1 - exp(-1/4)) / 3 of its variance, which s makes up for.
//
// Measured, the deviation is flat within 1 % from 5 to 4000 nodes; it stays so to a tenth of the longest T_k,
// 50 000 nodes. At 32 Hz or more that is 5 s to 14 h. Below, where white noise prevails, it falls.
#pragma once

#include "engine/base/axes.h"
#include "engine/base/random.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace driftbench {

// The samples from node to node of slow noise.
std::int64_t samplesPerNoiseNode(double sampleRateHz);

class FlickerNoise
{
public:
    FlickerNoise(double biasInstabilityDps, double sampleRateHz, const Random &random);

    void advance()
    {
        if (m_samplesLeft == 0)
            startNode();
        --m_samplesLeft;
        m_rateDps += m_stepDps;
    }
    const Eigen::Vector3d &rateDps() const { return m_rateDps; }

private:
    struct Process
    {
        std::int64_t nodes = 1; // h, in nodes
        double keep = 0.0;      // a
        double addDps = 0.0;    // standard deviation of what comes new
        Eigen::Vector3d rateDps = Eigen::Vector3d::Zero();
        Eigen::Vector3d stepDps = Eigen::Vector3d::Zero(); // per sample
    };

    void startNode();

    static constexpr int kProcesses = 22;

    std::array<Process, kProcesses> m_processes;
    std::int64_t m_samplesPerNode;
    std::int64_t m_samplesLeft = 0;
    std::uint64_t m_node = 0;
    Eigen::Vector3d m_rateDps = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_stepDps = Eigen::Vector3d::Zero();
    NormalStream m_normals;
};

} // namespace driftbench
