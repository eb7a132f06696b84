#include "engine/physics/flicker_noise.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <numbers>

namespace driftbench {

namespace {

constexpr double kShortestTimeNodes = 0.25; // T_0
constexpr double kNodesPerTime = 4.0;       // of a slow process
constexpr int kLastOnEveryNode = 4;         // T_4 is four nodes

Eigen::Vector3d triple(NormalStream &normals)
{
    Eigen::Vector3d values;
    for (double &value : values)
        value = normals.next();
    return values;
}

} // namespace

std::int64_t samplesPerNoiseNode(double sampleRateHz)
{
    constexpr double kShortestNodeS = 1.0;
    constexpr std::int64_t kFewestSamples = 32;
    return std::max(kFewestSamples, std::int64_t{std::llround(kShortestNodeS * sampleRateHz)});
}

FlickerNoise::FlickerNoise(double biasInstabilityDps, double sampleRateHz, const Random &random)
    : m_samplesPerNode(samplesPerNoiseNode(sampleRateHz)), m_normals(random)
{
    assert(biasInstabilityDps >= 0.0 && sampleRateHz > 0.0);
    // Straight lines between nodes with a correlation of a have (2 + a) / 3 of the nodes' variance.
    const double shareOfJoined = (2.0 + std::exp(-1.0 / kNodesPerTime)) / 3.0;
    const double deviationDps =
        biasInstabilityDps * std::sqrt(std::numbers::ln2 / std::numbers::pi / shareOfJoined);
    for (int k = 0; k < kProcesses; ++k) {
        Process &process = m_processes[k];
        const double timeNodes = std::ldexp(kShortestTimeNodes, k);
        process.nodes = std::max<std::int64_t>(1, std::llround(timeNodes / kNodesPerTime));
        process.keep = std::exp(-static_cast<double>(process.nodes) / timeNodes);
        process.addDps = deviationDps * std::sqrt(1.0 - process.keep * process.keep);
        process.rateDps = deviationDps * triple(m_normals);
        m_rateDps += process.rateDps;
    }
}

// The processes of every node, and those slower ones, octaves apart, whose own nodes this is.
void FlickerNoise::startNode()
{
    const int due =
        m_node == 0 ? kProcesses : std::min(kProcesses, kLastOnEveryNode + 1 + std::countr_zero(m_node));
    for (int k = 0; k < due; ++k) {
        Process &process = m_processes[k];
        const Eigen::Vector3d next = process.keep * process.rateDps + process.addDps * triple(m_normals);
        const Eigen::Vector3d stepDps =
            (next - process.rateDps) / static_cast<double>(process.nodes * m_samplesPerNode);
        m_stepDps += stepDps - process.stepDps;
        process.rateDps = next;
        process.stepDps = stepDps;
    }
    ++m_node;
    m_samplesLeft = m_samplesPerNode;
}

} // namespace driftbench
