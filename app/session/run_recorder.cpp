#include "app/session/run_recorder.h"

#include "app/session/run_recorder_state.h"
#include "engine/base/text.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace driftbench {

namespace {

double clockSeconds()
{
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

} // namespace

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
            state.oldestWaitingAt = RecorderClock::now();
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
    const auto begunAt = RecorderClock::now();
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
