#include "app/session/run_recorder.h"

#include "app/session/chunk_store.h"
#include "app/session/recorder_queue.h"
#include "app/session/session_file_state.h"
#include "engine/base/text.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace driftbench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kBatchesAtOnce = 64; // of a transaction, where much has waited

double secondsSince(Clock::time_point then)
{
    return std::chrono::duration<double>(Clock::now() - then).count();
}

// Where a run that is gone on with continues.
struct Continuation
{
    bool pending = false; // no sample has come yet
    double lastTimeS = 0.0;
    double intervalS = 0.0;
    double sampleRateHz = 0.0;
    std::optional<double> startedAt; // seconds since 1970
};

double clockSeconds()
{
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

} // namespace

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

    // Of the thread that writes.
    ChunkWriter writer;
    RecorderQueue pending; // taken from the queue and not committed yet
    std::int64_t writtenInRun;
    bool finished = false;

    // Of both threads.
    mutable std::mutex mutex;
    std::condition_variable_any wake;
    RecorderQueue queue;
    RecorderStats counts;
    Clock::time_point allWrittenAt = Clock::now();
    Clock::time_point oldestWaitingAt = Clock::now();
    bool slow = false;

    // Of the acquisition thread.
    Continuation continuation;
    double laterS = 0.0;

    std::jthread thread;

    void writeWhileRecording(const std::stop_token &stop);
    Status writePending();
    Status commitBatches(std::size_t batches);
    Status writeMark(const RecorderMark &mark, std::int64_t beforeSample);
    void noteOutcome(const Status &outcome, Clock::time_point takenAt, Clock::time_point begunAt);
    Status close();
    void tell(RecorderEventKind kind, const std::string &sentence) const;
    void continueRun(const SampleBlock &block);
};

void RunRecorder::State::tell(RecorderEventKind kind, const std::string &sentence) const
{
    if (options.onEvent)
        options.onEvent({kind, sentence});
}

Status RunRecorder::State::writeMark(const RecorderMark &mark, std::int64_t beforeSample)
{
    if (const auto *gap = std::get_if<SampleGap>(&mark.what))
        return file.database().run(
            "INSERT INTO gap(run_id, before_sample, start_s, end_s, lost_samples, cause)"
            " VALUES(?1, ?2, ?3, ?4, ?5, ?6)",
            run, beforeSample, gap->startS, gap->endS, gap->lostSamples, gapCauseText(gap->cause));
    const auto &remark = std::get<RecorderRemark>(mark.what);
    return insertEvent(file.database(), {run, beforeSample, remark.utc, remark.kind, remark.text});
}

Status RunRecorder::State::commitBatches(std::size_t batches)
{
    auto transaction = Transaction::begin(file.database());
    if (!transaction)
        return transaction.error();
    std::int64_t sample = writtenInRun;
    SampleColumns rows;
    for (std::size_t i = 0; i < batches; ++i) {
        const RecorderBatch &batch = pending[i];
        rows.append(batch.rows, 0, batch.rows.size());
        for (const RecorderMark &mark : batch.marks) {
            if (Status marked = writeMark(mark, sample + static_cast<std::int64_t>(mark.beforeRow)); !marked)
                return marked;
        }
        sample += static_cast<std::int64_t>(batch.rows.size());
    }
    if (Status appended = writer.append(rows, 0, rows.size()); !appended)
        return appended;
    if (Status committed = transaction->commit(); !committed)
        return committed;
    writtenInRun = sample;
    return {};
}

Status RunRecorder::State::writePending()
{
    while (!pending.empty()) {
        const std::size_t batches = std::min(pending.size(), kBatchesAtOnce);
        if (Status committed = commitBatches(batches); !committed) {
            writer.rolledBack();
            return committed;
        }
        writer.committed();
        std::int64_t samples = 0;
        for (std::size_t i = 0; i < batches; ++i)
            samples += static_cast<std::int64_t>(pending[i].rows.size());
        pending.dropFirst(batches);
        const std::lock_guard guard(mutex);
        counts.written += samples;
        counts.queuedBytes -= static_cast<std::size_t>(samples) * kSampleBytes;
        ++counts.commits;
    }
    return {};
}

void RunRecorder::State::noteOutcome(const Status &outcome, Clock::time_point takenAt,
                                     Clock::time_point begunAt)
{
    std::string sentence;
    {
        const std::lock_guard guard(mutex);
        counts.longestCommitS = std::max(counts.longestCommitS, secondsSince(begunAt));
        if (outcome) {
            allWrittenAt = takenAt;
            slow = false;
            if (!counts.failing)
                return;
            counts.failing = false;
            sentence = "The samples that waited in memory are written.";
        } else {
            ++counts.failedCommits;
            if (counts.failing)
                return;
            counts.failing = true;
            sentence = outcome.error().message + " Recording goes on in memory, up to " +
                       std::to_string(options.memoryBoundBytes >> 20) + " MiB.";
        }
        queue.put(RecorderRemark{"recorder", sentence, utcNow()});
    }
    tell(outcome ? RecorderEventKind::Recovered : RecorderEventKind::Failing, sentence);
}

void RunRecorder::State::writeWhileRecording(const std::stop_token &stop)
{
    bool failing = false;
    while (!stop.stop_requested()) {
        Clock::time_point takenAt;
        {
            std::unique_lock lock(mutex);
            const std::chrono::duration<double> pause(failing ? options.retryEveryS : options.commitEveryS);
            wake.wait_for(lock, stop, pause, [] { return false; });
            if (stop.stop_requested())
                return;
            takenAt = Clock::now();
            if (pending.empty())
                std::swap(pending, queue);
            oldestWaitingAt = pending.empty() ? takenAt : oldestWaitingAt;
        }
        const auto begunAt = Clock::now();
        const Status written = writePending();
        failing = !written;
        noteOutcome(written, takenAt, begunAt);
        if (written) {
            const std::lock_guard guard(mutex);
            oldestWaitingAt = takenAt;
        }
    }
}

// The rest, and the run's end, in the thread of whoever ends it.
Status RunRecorder::State::close()
{
    for (;;) {
        if (Status written = writePending(); !written)
            return written;
        const std::lock_guard guard(mutex);
        if (queue.empty())
            break;
        std::swap(pending, queue);
    }
    auto transaction = Transaction::begin(file.database());
    if (!transaction)
        return transaction.error();
    Status done = writer.joinPieces();
    if (done)
        done = file.database().run("UPDATE run SET state = 'complete', ended_utc = ?2 WHERE id = ?1", run,
                                   utcNow());
    if (done)
        done = transaction->commit();
    done ? writer.committed() : writer.rolledBack();
    return done;
}

void RunRecorder::State::continueRun(const SampleBlock &block)
{
    continuation.pending = false;
    const double earliestS = continuation.lastTimeS + continuation.intervalS;
    const double byClockS = continuation.startedAt ? clockSeconds() - *continuation.startedAt : earliestS;
    const double startS = std::max(earliestS, byClockS);
    laterS = startS - block.timeS[0];
    const double lost = (startS - continuation.lastTimeS) * continuation.sampleRateHz - 1.0;
    const std::int64_t lostSamples = continuation.sampleRateHz > 0.0 ? std::llround(std::max(lost, 0.0)) : -1;
    queue.put(SampleGap{continuation.lastTimeS, startS, lostSamples, GapCause::Interrupted});
}

RunRecorder::RunRecorder(std::unique_ptr<State> state) : m_state(std::move(state))
{
    m_state->thread = std::jthread(
        [&recorder = *m_state](const std::stop_token &stop) { recorder.writeWhileRecording(stop); });
}

RunRecorder::~RunRecorder()
{
    (void)finish();
}

Result<std::unique_ptr<RunRecorder>>
RunRecorder::start(const SessionFile &file, const RunDescription &description, RecorderOptions options)
{
    if (file.readOnly())
        return Error{Errc::SessionReadOnly, file.readOnlyReason()};
    auto own = file.another();
    if (!own)
        return own.error();
    auto transaction = Transaction::begin(own->database());
    if (!transaction)
        return transaction.error();
    const auto run = insertRun(own->database(), description, runStateName(RunState::Recording));
    if (!run)
        return run.error();
    if (Status committed = transaction->commit(); !committed)
        return committed.error();
    return std::unique_ptr<RunRecorder>(
        new RunRecorder(std::make_unique<State>(std::move(*own), *run, 0, std::move(options))));
}

Result<std::unique_ptr<RunRecorder>> RunRecorder::resume(const SessionFile &file, RunId run,
                                                         const SourceInfo &source, RecorderOptions options)
{
    if (file.readOnly())
        return Error{Errc::SessionReadOnly, file.readOnlyReason()};
    auto own = file.another();
    if (!own)
        return own.error();
    const auto record = own->run(run);
    if (!record)
        return record.error();
    const std::string name = "Run \"" + record->description.name + "\"";
    if (record->state == RunState::Recording || record->state == RunState::Imported)
        return Error{
            Errc::InvalidOption,
            name +
                (record->state == RunState::Recording ? " is being recorded" : " was imported from a log") +
                " and can't be continued; record a new run."};
    const SensorIdentity &sensor = record->description.sensor;
    if (sensor.model != source.sensor.model || sensor.serial != source.sensor.serial)
        return Error{Errc::WrongSensor, name + " is of " + sensor.text() + ", and this is " +
                                            source.sensor.text() +
                                            "; connect the sensor of the run, or record a new run."};
    if (Status begun =
            own->database().run("UPDATE run SET state = 'recording', ended_utc = '' WHERE id = ?1", run);
        !begun)
        return begun.error();
    auto state = std::make_unique<State>(std::move(*own), run, record->samples, std::move(options));
    if (record->samples > 0) {
        const double meanS = record->samples > 1 ? (record->lastTimeS - record->firstTimeS) /
                                                       static_cast<double>(record->samples - 1)
                                                 : 0.0;
        const double rateHz = source.sampleRateHz;
        state->continuation = {true, record->lastTimeS, rateHz > 0.0 ? 1.0 / rateHz : std::max(meanS, 1e-6),
                               rateHz, secondsOfUtc(record->description.startedUtc)};
    }
    return std::unique_ptr<RunRecorder>(new RunRecorder(std::move(state)));
}

RunId RunRecorder::run() const
{
    return m_state->run;
}

Flow RunRecorder::samples(const SampleBlock &block, Eigen::Index count)
{
    State &state = *m_state;
    std::string slow;
    std::string full;
    bool stop = false;
    {
        const std::lock_guard guard(state.mutex);
        if (state.continuation.pending && count > 0)
            state.continueRun(block);
        RecorderStats &counts = state.counts;
        if (counts.queuedBytes == 0)
            state.oldestWaitingAt = Clock::now();
        state.queue.put(block, count, state.laterS);
        counts.taken += count;
        counts.queuedBytes += static_cast<std::size_t>(count) * kSampleBytes;
        counts.largestQueuedBytes = std::max(counts.largestQueuedBytes, counts.queuedBytes);
        if (!state.slow && !counts.failing &&
            secondsSince(state.oldestWaitingAt) > state.options.slowAfterS) {
            state.slow = true;
            slow = "The disk is slow: the samples of the last " +
                   fixed(secondsSince(state.oldestWaitingAt), 1) + " s wait in memory.";
            state.queue.put(RecorderRemark{"recorder", slow, utcNow()});
        }
        stop = counts.queuedBytes >= state.options.memoryBoundBytes;
        if (stop && !counts.full) {
            counts.full = true;
            full = "Recording is stopped: " + std::to_string(state.options.memoryBoundBytes >> 20) +
                   " MiB of samples wait in memory and can't be written. Make room on the disk, then end the "
                   "run.";
            state.queue.put(RecorderRemark{"recorder", full, utcNow()});
        }
        stop = counts.full;
    }
    if (!slow.empty())
        state.tell(RecorderEventKind::Slow, slow);
    if (!full.empty())
        state.tell(RecorderEventKind::Full, full);
    return stop ? Flow::Stop : Flow::Continue;
}

void RunRecorder::gap(const SampleGap &gap)
{
    const std::lock_guard guard(m_state->mutex);
    m_state->queue.put(
        {gap.startS + m_state->laterS, gap.endS + m_state->laterS, gap.lostSamples, gap.cause});
}

void RunRecorder::event(const std::string &sentence)
{
    const std::lock_guard guard(m_state->mutex);
    m_state->queue.put(RecorderRemark{"device", sentence, utcNow()});
}

Status RunRecorder::finish()
{
    State &state = *m_state;
    if (state.thread.joinable()) {
        state.thread.request_stop();
        state.thread.join();
    }
    if (state.finished)
        return {};
    const auto begunAt = Clock::now();
    const Status closed = state.close();
    state.finished = closed.ok();
    state.noteOutcome(closed, begunAt, begunAt);
    return closed;
}

Recording RunRecorder::unwritten() const
{
    const State &state = *m_state;
    const std::lock_guard guard(state.mutex);
    RecorderQueue waiting = state.pending;
    waiting.append(state.queue);
    Recording recording;
    const auto rows = static_cast<Eigen::Index>(waiting.samples());
    recording.timeS.resize(rows);
    recording.temperatureC.resize(rows);
    recording.rateDps.resize(rows, 3);
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
        const SampleColumns &part = waiting[i].rows;
        std::copy(part.column(0).begin(), part.column(0).end(), recording.timeS.data() + row);
        std::copy(part.column(1).begin(), part.column(1).end(), recording.temperatureC.data() + row);
        for (int axis = 0; axis < 3; ++axis) {
            const auto rates = part.column(static_cast<std::size_t>(2 + axis));
            std::copy(rates.begin(), rates.end(), recording.rateDps.col(axis).data() + row);
        }
        row += static_cast<Eigen::Index>(part.size());
    }
    return recording;
}

RecorderStats RunRecorder::stats() const
{
    const std::lock_guard guard(m_state->mutex);
    RecorderStats stats = m_state->counts;
    stats.lastCommitAgeS = secondsSince(m_state->allWrittenAt);
    return stats;
}

} // namespace driftbench
