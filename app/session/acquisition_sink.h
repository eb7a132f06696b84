// What stands between the thread of a source and its two listeners: the recorder, which gets every block at
// once, and the owner, who takes what came since the last time. Private to acquisition.cpp.
#pragma once

#include "app/session/run_recorder.h"
#include "device/sample_source.h"

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace driftbench {

class AcquisitionSink final : public SampleSink
{
public:
    // In the order in which they came; samples between two gaps or events are one block.
    using Item = std::variant<std::shared_ptr<const SampleBlock>, SampleGap, std::string>;

    // By the thread of the source.
    Flow samples(const SampleBlock &block, Eigen::Index count) override;
    void gap(const SampleGap &gap) override;
    void event(const std::string &sentence) override;

    // By the owner.
    std::vector<Item> take();
    void setRecorder(std::shared_ptr<RunRecorder> recorder); // null: no longer
    std::optional<double> recordedFromS() const;             // of the recorder that was set last
    bool isRefused() const;                                  // the recorder said Stop

private:
    void record(const SampleBlock &block, Eigen::Index count);
    void closeBlock();

    mutable std::mutex m_mutex; // of what waits for the owner
    std::vector<Item> m_items;
    std::vector<SampleBlock> m_blocks; // behind the last item
    std::int64_t m_samples = 0;

    mutable std::mutex
        m_recorderMutex; // held while it is called, so that none is called once it was taken away
    std::shared_ptr<RunRecorder> m_recorder;
    std::optional<double> m_firstRecordedS;
    SampleBlock m_shifted;
    bool m_refused = false;
};

} // namespace driftbench
