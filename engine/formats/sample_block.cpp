#include "engine/formats/sample_block.h"

#include <utility>

namespace driftbench {

namespace {

void resize(SampleBlock &block, Eigen::Index samples)
{
    block.timeS.conservativeResize(samples);
    block.temperatureC.conservativeResize(samples);
    block.rateDps.conservativeResize(samples, Eigen::NoChange);
}

} // namespace

BlockBuffer::BlockBuffer(BlockSink sink) : m_sink(std::move(sink))
{
    resize(m_block, kBlockSamples);
}

Flow BlockBuffer::flush()
{
    if (m_count == 0)
        return Flow::Continue;
    if (m_count < kBlockSamples)
        resize(m_block, m_count);
    const Flow flow = m_sink(m_block);
    m_block.firstSample += std::exchange(m_count, 0);
    if (m_block.size() < kBlockSamples)
        resize(m_block, kBlockSamples);
    return flow;
}

void RecordingCollector::collect(const SampleBlock &block)
{
    m_blocks.push_back(block);
    m_samples += block.size();
}

Recording RecordingCollector::take(RecordingInfo info)
{
    Recording recording;
    recording.info = std::move(info);
    recording.timeS.resize(m_samples);
    recording.temperatureC.resize(m_samples);
    recording.rateDps.resize(m_samples, Eigen::NoChange);
    Eigen::Index first = 0;
    for (const SampleBlock &block : m_blocks) {
        recording.timeS.segment(first, block.size()) = block.timeS;
        recording.temperatureC.segment(first, block.size()) = block.temperatureC;
        recording.rateDps.middleRows(first, block.size()) = block.rateDps;
        first += block.size();
    }
    m_blocks.clear();
    m_samples = 0;
    return recording;
}

} // namespace driftbench
