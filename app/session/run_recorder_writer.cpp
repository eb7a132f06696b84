#include "app/session/run_recorder_state.h"

#include <algorithm>

namespace driftbench {

namespace {

constexpr std::size_t kBatchesAtOnce = 64; // of a transaction, where much has waited

} // namespace

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
        const std::lock_guard guard(mutex);
        pending.dropFirst(batches);
        counts.written += samples;
        counts.queuedBytes -= static_cast<std::size_t>(samples) * kSampleBytes;
        ++counts.commits;
    }
    return {};
}

void RunRecorder::State::noteOutcome(const Status &outcome, RecorderClock::time_point takenAt,
                                     RecorderClock::time_point begunAt)
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
        RecorderClock::time_point takenAt;
        {
            std::unique_lock lock(mutex);
            const std::chrono::duration<double> pause(failing ? options.retryEveryS : options.commitEveryS);
            wake.wait_for(lock, stop, pause, [] { return false; });
            if (stop.stop_requested())
                return;
            takenAt = RecorderClock::now();
            if (pending.empty())
                std::swap(pending, queue);
            oldestWaitingAt = pending.empty() ? takenAt : oldestWaitingAt;
        }
        const auto begunAt = RecorderClock::now();
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

} // namespace driftbench
