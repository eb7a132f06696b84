// What a recording has come to, counted on its way to the sink that keeps it, and its end at a given time.
// Samples at or after endS are left out; a source's blocks do not end where a recording does.
//
//   measured rate = (samples - 1 - gaps) / (span - time in gaps)
#pragma once

#include "device/sample_source.h"

#include <cstdint>
#include <mutex>

namespace driftbench {

struct RecordingState
{
    std::int64_t samples = 0;
    std::int64_t lostSamples = 0; // of the gaps that know it
    std::int64_t gaps = 0;
    std::int64_t events = 0;
    double firstS = 0.0; // time of the samples
    double lastS = 0.0;
    double gapS = 0.0; // in all gaps
    double temperatureC = 0.0;
    double lowestC = 0.0; // of all temperatures that are numbers; above highestC: there is none
    double highestC = 0.0;
    Eigen::Vector3d rateDps = Eigen::Vector3d::Zero(); // mean of the last block
    bool reachedEnd = false;
    bool refused = false; // the sink said Stop

    bool hasTemperature() const { return samples > 0 && lowestC <= highestC; }
    double durationS() const { return lastS - firstS; }
    double measuredRateHz() const; // 0: not known
};

class RecordingMonitor final : public SampleSink
{
public:
    // endS: 0 for none. The sink must outlive the monitor.
    RecordingMonitor(SampleSink &sink, double endS);

    Flow samples(const SampleBlock &block, Eigen::Index count) override;
    void gap(const SampleGap &gap) override;
    void event(const std::string &sentence) override;

    RecordingState state() const; // any thread

private:
    Eigen::Index rowsBeforeEnd(const SampleBlock &block, Eigen::Index count) const;
    void note(const SampleBlock &block, Eigen::Index count);

    SampleSink &m_sink;
    double m_endS;
    mutable std::mutex m_mutex;
    RecordingState m_state;
};

} // namespace driftbench
