#include "app/session/acquisition_sink.h"

namespace driftbench {

namespace {

SampleBlock firstRows(const SampleBlock &block, Eigen::Index count)
{
    return {block.firstSample, block.timeS.head(count), block.temperatureC.head(count),
            block.rateDps.topRows(count)};
}

std::shared_ptr<const SampleBlock> joined(const std::vector<SampleBlock> &blocks)
{
    Eigen::Index rows = 0;
    for (const SampleBlock &block : blocks)
        rows += block.size();
    auto whole = std::make_shared<SampleBlock>(SampleBlock::withRows(rows));
    whole->firstSample = blocks.front().firstSample;
    Eigen::Index row = 0;
    for (const SampleBlock &block : blocks) {
        whole->timeS.segment(row, block.size()) = block.timeS;
        whole->temperatureC.segment(row, block.size()) = block.temperatureC;
        whole->rateDps.middleRows(row, block.size()) = block.rateDps;
        row += block.size();
    }
    return whole;
}

} // namespace

Flow AcquisitionSink::samples(const SampleBlock &block, Eigen::Index count)
{
    record(block, count);
    const std::lock_guard lock(m_mutex);
    if (count > 0) {
        m_blocks.push_back(firstRows(block, count));
        m_blocks.back().firstSample = m_samples;
        m_samples += count;
    }
    return Flow::Continue;
}

void AcquisitionSink::record(const SampleBlock &block, Eigen::Index count)
{
    const std::lock_guard lock(m_recorderMutex);
    if (!m_recorder || count == 0)
        return;
    if (!m_firstRecordedS)
        m_firstRecordedS = block.timeS[0];
    const SampleBlock *recorded = &block;
    if (*m_firstRecordedS != 0.0) {
        m_shifted = firstRows(block, count);
        m_shifted.timeS.array() -= *m_firstRecordedS;
        recorded = &m_shifted;
    }
    if (m_recorder->samples(*recorded, count) == Flow::Stop) {
        m_refused = true;
        m_recorder.reset();
    }
}

void AcquisitionSink::gap(const SampleGap &gap)
{
    {
        const std::lock_guard lock(m_recorderMutex);
        // One before the first recorded sample is not of the run.
        if (m_recorder && m_firstRecordedS)
            m_recorder->gap(
                {gap.startS - *m_firstRecordedS, gap.endS - *m_firstRecordedS, gap.lostSamples, gap.cause});
    }
    const std::lock_guard lock(m_mutex);
    closeBlock();
    m_items.emplace_back(gap);
}

void AcquisitionSink::event(const std::string &sentence)
{
    {
        const std::lock_guard lock(m_recorderMutex);
        if (m_recorder)
            m_recorder->event(sentence);
    }
    const std::lock_guard lock(m_mutex);
    closeBlock();
    m_items.emplace_back(sentence);
}

void AcquisitionSink::closeBlock()
{
    if (m_blocks.empty())
        return;
    m_items.emplace_back(joined(m_blocks));
    m_blocks.clear();
}

std::vector<AcquisitionSink::Item> AcquisitionSink::take()
{
    std::vector<SampleBlock> blocks;
    std::vector<Item> items;
    {
        const std::lock_guard lock(m_mutex);
        items.swap(m_items);
        blocks.swap(m_blocks);
    }
    // Joined here, as the thread of the source should not wait for it.
    if (!blocks.empty())
        items.emplace_back(joined(blocks));
    return items;
}

void AcquisitionSink::setRecorder(std::shared_ptr<RunRecorder> recorder)
{
    const std::lock_guard lock(m_recorderMutex);
    m_recorder.swap(recorder);
    m_firstRecordedS.reset();
    m_refused = false;
}

std::optional<double> AcquisitionSink::recordedFromS() const
{
    const std::lock_guard lock(m_recorderMutex);
    return m_firstRecordedS;
}

bool AcquisitionSink::isRefused() const
{
    const std::lock_guard lock(m_recorderMutex);
    return m_refused;
}

} // namespace driftbench
