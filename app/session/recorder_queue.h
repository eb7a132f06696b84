// What waits to be written, in the order in which it came: batches of samples, each with the gaps and events
// between them. A batch's memory is taken once and never moved, so that putting a block in costs a copy of
// the block, however much waits.
#pragma once

#include "app/session/sample_columns.h"
#include "device/sample_source.h"

#include <cstddef>
#include <deque>
#include <string>
#include <variant>
#include <vector>

namespace driftbench {

struct RecorderRemark
{
    std::string kind; // of SessionEvent
    std::string text;
    std::string utc;
};

struct RecorderMark
{
    std::size_t beforeRow = 0; // of its batch
    std::variant<SampleGap, RecorderRemark> what;
};

struct RecorderBatch
{
    SampleColumns rows;
    std::vector<RecorderMark> marks;
};

class RecorderQueue
{
public:
    void put(const SampleBlock &block, Eigen::Index count, double laterS);
    void put(SampleGap gap) { lastBatch(0).marks.push_back({lastBatch(0).rows.size(), gap}); }
    void put(RecorderRemark remark)
    {
        RecorderBatch &batch = lastBatch(0);
        batch.marks.push_back({batch.rows.size(), std::move(remark)});
    }

    bool empty() const { return m_batches.empty(); }
    std::size_t size() const { return m_batches.size(); }
    const RecorderBatch &operator[](std::size_t index) const { return m_batches[index]; }
    void dropFirst(std::size_t batches);
    void append(const RecorderQueue &other);

    std::int64_t samples() const;

private:
    RecorderBatch &lastBatch(std::size_t room); // with room for so many rows

    std::deque<RecorderBatch> m_batches;
};

} // namespace driftbench
