#include "app/cli/session_recording.h"

#include "app/cli/cli_io.h"
#include "app/recording/csv_recorder.h"
#include "engine/base/text.h"

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

namespace driftbench::cli {

namespace {

constexpr std::size_t kMostWaitingBytes = std::size_t{16} << 20;

Result<std::unique_ptr<Session>> sessionFor(const SessionRecordingOptions &options)
{
    std::error_code code;
    const bool isThere = std::filesystem::exists(options.file, code);
    auto session = isThere || options.goOn ? Session::open(options.file) : Session::create(options.file);
    if (session && (*session)->isReadOnly())
        return Error{Errc::SessionReadOnly, (*session)->readOnlyReason().toStdString()};
    return session;
}

std::string nameFor(const SessionRecordingOptions &options, const Session &session)
{
    return options.runName.empty() ? "run " + std::to_string(session.runs().size() + 1) : options.runName;
}

Result<RunId> interruptedRun(const Session &session)
{
    for (auto run = session.runs().rbegin(); run != session.runs().rend(); ++run) {
        if (run->state == RunState::Interrupted)
            return run->id;
    }
    return Error{Errc::NoSuchRun,
                 session.path().string() +
                     " has no interrupted run that could be continued; leave out --continue for a new "
                     "one."};
}

RecorderOptions telling()
{
    RecorderOptions options;
    options.onEvent = [](const RecorderEvent &event) { printNotice(event.sentence); };
    return options;
}

Result<std::unique_ptr<RunRecorder>> recorderFor(const Session &session, const SourceInfo &info,
                                                 const SessionRecordingOptions &options)
{
    if (options.goOn) {
        const auto run = interruptedRun(session);
        if (!run)
            return run.error();
        return RunRecorder::resume(session.file(), *run, info, telling());
    }
    RunDescription description = describeSource(info, nameFor(options, session));
    if (const auto *simulated = options.choice.as<SimulatedChoice>())
        description.referenceRateDps = simulated->referenceRateDps;
    return RunRecorder::start(session.file(), description, telling());
}

} // namespace

Result<std::unique_ptr<SessionRecording>> SessionRecording::begin(const SourceInfo &info,
                                                                  const SessionRecordingOptions &options)
{
    auto session = sessionFor(options);
    if (!session)
        return session.error();
    if (Status set = (*session)->setSource(options.choice); !set)
        return set.error();
    if (options.plan) {
        if (Status set = (*session)->setTestPlan(*options.plan); !set)
            return set.error();
    }
    auto recorder = recorderFor(**session, info, options);
    if (!recorder)
        return recorder.error();
    return std::unique_ptr<SessionRecording>(
        new SessionRecording(*std::move(session), *std::move(recorder), options.mayWait));
}

Flow SessionRecording::samples(const SampleBlock &block, Eigen::Index count)
{
    const Flow flow = m_recorder->samples(block, count);
    while (m_mayWait && flow == Flow::Continue) {
        const RecorderStats stats = m_recorder->stats();
        if (stats.failing || stats.queuedBytes < kMostWaitingBytes)
            break;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return flow;
}

Status SessionRecording::finish(const RecordingOutcome & /*outcome*/)
{
    const Status finished = m_recorder->finish();
    const Status read = m_session->refreshRuns();
    return finished ? read : finished;
}

std::string SessionRecording::asText(const RecordingOutcome &outcome) const
{
    const RunRecord *run = m_session->run(m_recorder->run());
    std::string text =
        m_session->path().string() + ", " + (run ? run->description.name : std::string("run")) + ": " +
        std::to_string(outcome.state.samples) + " samples in " + fixed(outcome.state.durationS(), 1) +
        " s, " + std::to_string(outcome.state.lostSamples) + " lost";
    if (run && run->samples != outcome.state.samples)
        text += "; " + std::to_string(run->samples) + " in the run";
    return text + "\n";
}

nlohmann::ordered_json SessionRecording::asJson(const RecordingOutcome &outcome) const
{
    nlohmann::ordered_json json = outcomeAsJson(outcome);
    const RunRecord *run = m_session->run(m_recorder->run());
    json["session"] = m_session->path().string();
    json["run"] = run ? run->description.name : std::string();
    json["samples_in_run"] = run ? run->samples : 0;
    return json;
}

} // namespace driftbench::cli
