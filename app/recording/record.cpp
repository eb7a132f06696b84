#include "app/recording/record.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <thread>

namespace driftbench {

namespace {

// How much longer than it should a device may take that has to start first, or whose clock runs slow.
constexpr double kGraceS = 2.0;

// The source on its thread, until it has ended.
class RunningSource
{
public:
    RunningSource(SampleSource &source, SampleSink &sink)
        : m_thread([this, &source, &sink](const std::stop_token &stop) {
            auto stats = source.run(sink, stop);
            {
                const std::lock_guard lock(m_mutex);
                m_stats.emplace(std::move(stats));
            }
            m_ended.notify_all();
        })
    {
    }

    bool waitForEnd(double durationS)
    {
        std::unique_lock lock(m_mutex);
        return m_ended.wait_for(lock, std::chrono::duration<double>(durationS),
                                [this] { return m_stats.has_value(); });
    }
    void requestStop() { m_thread.request_stop(); }
    Result<SourceStats> join()
    {
        m_thread.join();
        return *m_stats;
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_ended;
    std::optional<Result<SourceStats>> m_stats;
    std::jthread m_thread; // last: it uses all of the above
};

double nowS()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

RecordingOutcome record(SampleSource &source, SampleSink &sink, const RecordOptions &options,
                        const RecordingTick &tick)
{
    // Midway between two samples, as their times are known to microseconds only.
    const double rateHz = source.info().sampleRateHz;
    const double halfS = rateHz > 0.0 ? std::min(0.5 / rateHz, 0.5 * options.durationS) : 0.0;
    RecordingMonitor monitor(sink, options.durationS - halfS);
    const double deadlineS = nowS() + options.durationS + kGraceS;
    const bool hasDeadline = options.isRealTime && options.durationS > 0.0;
    std::optional<RecordingEnd> stopped;
    RunningSource running(source, monitor);
    while (!running.waitForEnd(options.tickS)) {
        if (!stopped && tick(monitor.state()) == Flow::Stop)
            stopped = RecordingEnd::Asked;
        else if (!stopped && hasDeadline && nowS() >= deadlineS)
            stopped = RecordingEnd::Duration;
        if (stopped)
            running.requestStop();
    }
    const auto stats = running.join();
    RecordingOutcome outcome;
    outcome.state = monitor.state();
    if (!stats) {
        outcome.end = RecordingEnd::Error;
        outcome.status = stats.error();
        return outcome;
    }
    outcome.stats = *stats;
    outcome.end = outcome.state.refused      ? RecordingEnd::Sink
                  : outcome.state.reachedEnd ? RecordingEnd::Duration
                                             : stopped.value_or(RecordingEnd::Source);
    return outcome;
}

} // namespace driftbench
