// Samples on their way from a reader to whoever uses them, a block at a time: memory does not depend on the
// length of the log.
#pragma once

#include "engine/base/progress.h"
#include "engine/recording/recording.h"
#include "engine/recording/sample_block.h"

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace driftbench {

// Gets every block in the order of the log, none of them empty.
using BlockSink = std::function<Flow(const SampleBlock &)>;

// Gathers single samples to blocks of kBlockSamples for a sink.
class BlockBuffer
{
public:
    static constexpr Eigen::Index kBlockSamples = 8192;

    explicit BlockBuffer(BlockSink sink);

    Flow push(double timeS, double temperatureC, const Eigen::Vector3d &rateDps)
    {
        m_block.timeS[m_count] = timeS;
        m_block.temperatureC[m_count] = temperatureC;
        m_block.rateDps.row(m_count) = rateDps.transpose();
        return ++m_count == kBlockSamples ? flush() : Flow::Continue;
    }
    Flow flush(); // hands over what has gathered

    std::int64_t samples() const { return m_block.firstSample + m_count; }

private:
    BlockSink m_sink;
    SampleBlock m_block;
    Eigen::Index m_count = 0;
};

// Joins blocks to one recording. Its collect() is a sink.
class RecordingCollector
{
public:
    void collect(const SampleBlock &block);
    Recording take(RecordingInfo info); // empties the collector

private:
    std::vector<SampleBlock> m_blocks;
    Eigen::Index m_samples = 0;
};

} // namespace driftbench
