#include "app/session/recorder_queue.h"

namespace driftbench {

namespace {

constexpr std::size_t kBatchRows = 8192;

} // namespace

RecorderBatch &RecorderQueue::lastBatch(std::size_t room)
{
    if (m_batches.empty() ||
        (!m_batches.back().rows.empty() && m_batches.back().rows.size() + room > kBatchRows)) {
        m_batches.emplace_back();
        m_batches.back().rows.reserve(std::max(room, room == 0 ? 0 : kBatchRows));
    }
    return m_batches.back();
}

void RecorderQueue::put(const SampleBlock &block, Eigen::Index count, double laterS)
{
    lastBatch(static_cast<std::size_t>(count)).rows.append(block, count, laterS);
}

void RecorderQueue::dropFirst(std::size_t batches)
{
    m_batches.erase(m_batches.begin(), m_batches.begin() + static_cast<std::ptrdiff_t>(batches));
}

void RecorderQueue::append(const RecorderQueue &other)
{
    m_batches.insert(m_batches.end(), other.m_batches.begin(), other.m_batches.end());
}

std::int64_t RecorderQueue::samples() const
{
    std::int64_t samples = 0;
    for (const RecorderBatch &batch : m_batches)
        samples += static_cast<std::int64_t>(batch.rows.size());
    return samples;
}

} // namespace driftbench
