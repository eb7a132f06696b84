// A recording that goes into a session: a new run, or the interrupted one continued.
#pragma once

#include "app/recording/record.h"
#include "app/session/run_recorder.h"
#include "app/session/session.h"
#include "device/source_choice.h"
#include "engine/base/result.h"
#include "engine/physics/test_plan.h"

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace driftbench::cli {

struct SessionRecordingOptions
{
    std::filesystem::path file; // made if it is not there
    std::string runName{};      // empty: "run" and its number
    bool goOn = false;          // with the run that was interrupted last
    bool mayWait = false;       // the source is no device whose samples would be lost meanwhile
    SourceChoice choice{};      // kept in the session
    std::optional<TestPlan> plan{};
};

class SessionRecording final : public SampleSink
{
public:
    // Errors: those of Session and RunRecorder; SessionReadOnly; NoSuchRun where none was interrupted.
    static Result<std::unique_ptr<SessionRecording>> begin(const SourceInfo &info,
                                                           const SessionRecordingOptions &options);

    Flow samples(const SampleBlock &block, Eigen::Index count) override;
    void gap(const SampleGap &gap) override { m_recorder->gap(gap); }
    void event(const std::string &sentence) override { m_recorder->event(sentence); }

    // All that waits is written. The error says what could not be.
    Status finish(const RecordingOutcome &outcome);
    std::string asText(const RecordingOutcome &outcome) const;
    nlohmann::ordered_json asJson(const RecordingOutcome &outcome) const;

private:
    SessionRecording(std::unique_ptr<Session> session, std::unique_ptr<RunRecorder> recorder, bool mayWait)
        : m_session(std::move(session)), m_recorder(std::move(recorder)), m_mayWait(mayWait)
    {
    }

    std::unique_ptr<Session> m_session;
    std::unique_ptr<RunRecorder> m_recorder;
    bool m_mayWait;
};

} // namespace driftbench::cli
