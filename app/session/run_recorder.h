// Takes the samples of a source and brings them into a session file while they come.
//
// samples(), gap() and event() are called by the acquisition thread and only put what they get into a queue;
// a thread of the recorder's own, with its own connection, commits it every commitEveryS. Samples, gaps and
// events keep their order; a commit holds all of them up to a moment, or nothing.
//
// Nothing is dropped. A slow disk makes the queue grow and is reported as Slow. A commit that fails (disk
// full, file read-only, a failed write or sync) counts as not made: what it held stays in memory and is tried
// again every retryEveryS, with Failing first and Recovered afterwards. If memoryBoundBytes is reached,
// samples() says Stop, the run ends with an error, and all that was taken is kept: it is written if there is
// room in time, and else unwritten() has it.
#pragma once

#include "app/session/session_file.h"
#include "device/sample_source.h"

#include <functional>
#include <memory>

namespace driftbench {

enum class RecorderEventKind
{
    Slow,      // more than slowAfterS of samples wait
    Failing,   // a commit failed; recording goes on in memory
    Recovered, // all that waited is written
    Full,      // the bound of memory is reached; the run is stopped
};

struct RecorderEvent
{
    RecorderEventKind kind = RecorderEventKind::Slow;
    std::string sentence; // for the user
};

struct RecorderOptions
{
    double commitEveryS = 0.25;
    double retryEveryS = 0.5;
    double slowAfterS = 2.0;
    std::size_t memoryBoundBytes = std::size_t{256} << 20; // of samples that wait
    // Called by the recorder's thread; must not call the recorder.
    std::function<void(const RecorderEvent &)> onEvent{};
};

struct RecorderStats
{
    std::int64_t taken = 0;   // samples that came
    std::int64_t written = 0; // of them on the disk
    std::int64_t queued() const { return taken - written; }
    std::size_t queuedBytes = 0;
    std::size_t largestQueuedBytes = 0;
    std::int64_t commits = 0;
    std::int64_t failedCommits = 0;
    double lastCommitAgeS = 0.0; // since all that had come then was on the disk
    double longestCommitS = 0.0;
    bool failing = false;
    bool full = false;
};

class RunRecorder final : public SampleSink
{
public:
    // Begins a new run. Errors: SessionReadOnly, those of database.h.
    static Result<std::unique_ptr<RunRecorder>>
    start(const SessionFile &file, const RunDescription &description, RecorderOptions options = {});
    // Goes on with an interrupted or complete run, behind a gap of cause Interrupted as long as the clock
    // says (at least a sample). Errors: WrongSensor unless model and serial are those of the run, NoSuchRun,
    // InvalidOption for a run that is being recorded or was imported.
    static Result<std::unique_ptr<RunRecorder>>
    resume(const SessionFile &file, RunId run, const SourceInfo &source, RecorderOptions options = {});
    ~RunRecorder() override; // as finish(), where that was not called

    RunId run() const;

    // Stop once the bound of memory is reached.
    Flow samples(const SampleBlock &block, Eigen::Index count) override;
    void gap(const SampleGap &gap) override;
    void event(const std::string &sentence) override;

    // Writes what waits, marks the run complete and ends the thread. An error, OutputFull or what the disk
    // said, means that something could not be written; unwritten() has it, and the run is left as it would be
    // after a crash. Calling it again tries again.
    Status finish();
    Recording unwritten() const; // after a finish() that failed

    RecorderStats stats() const; // from any thread

private:
    struct State;
    explicit RunRecorder(std::unique_ptr<State> state);

    std::unique_ptr<State> m_state;
};

} // namespace driftbench
