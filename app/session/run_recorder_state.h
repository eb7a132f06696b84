// What the two threads of a recorder share: the acquisition's, which only puts into the queue
// (run_recorder.cpp), and the recorder's own, which writes (run_recorder_writer.cpp). A private header of
// those.
#pragma once

#include "app/session/chunk_store.h"
#include "app/session/recorder_queue.h"
#include "app/session/run_recorder.h"
#include "app/session/session_file_state.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace driftbench {

using RecorderClock = std::chrono::steady_clock;

inline double secondsSince(RecorderClock::time_point then)
{
    return std::chrono::duration<double>(RecorderClock::now() - then).count();
}

// Where a run that is gone on with continues.
struct RecorderContinuation
{
    bool pending = false; // no sample has come yet
    double lastTimeS = 0.0;
    double intervalS = 0.0;
    double sampleRateHz = 0.0;
    std::optional<double> startedAt; // seconds since 1970
};

struct RunRecorder::State
{
    State(SessionFile ownFile, RunId id, std::int64_t samplesBefore, RecorderOptions givenOptions)
        : file(std::move(ownFile))
        , run(id)
        , options(std::move(givenOptions))
        , writer(file.database(), id, samplesBefore)
        , writtenInRun(samplesBefore)
    {
    }

    SessionFile file; // of the recorder's own
    RunId run;
    RecorderOptions options;

    // Of the thread that writes; the queue's own changes are under the mutex, for unwritten().
    ChunkWriter writer;
    RecorderQueue pending; // taken from the queue and not committed yet
    std::int64_t writtenInRun;
    bool finished = false;

    // Of both threads.
    mutable std::mutex mutex;
    std::condition_variable_any wake;
    RecorderQueue queue;
    RecorderStats counts;
    RecorderClock::time_point allWrittenAt = RecorderClock::now();
    RecorderClock::time_point oldestWaitingAt = RecorderClock::now();
    bool slow = false;

    // Of the acquisition thread.
    RecorderContinuation continuation;
    double laterS = 0.0;

    std::jthread thread;

    void writeWhileRecording(const std::stop_token &stop);
    Status writePending();
    Status commitBatches(std::size_t batches);
    Status writeMark(const RecorderMark &mark, std::int64_t beforeSample);
    void noteOutcome(const Status &outcome, RecorderClock::time_point takenAt,
                     RecorderClock::time_point begunAt);
    Status close();
    void tell(RecorderEventKind kind, const std::string &sentence) const;
    void continueRun(const SampleBlock &block);
};

} // namespace driftbench
