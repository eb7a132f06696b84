// A source of samples that runs on a thread of its own, watched by the thread that owns this object, with or
// without being recorded. Recording starts and stops while the source goes on.
//
// Samples come as a batch about every 40 ms, in order with the gaps and events between them; the recorder
// gets each block at once, on the thread of the source. A recorded run's time starts at 0 with its first
// sample, whatever was watched before.
//
// Everything is delivered by the owner's event loop; nothing is once the object is gone. Destroying it stops
// the source, waits for it and finishes the recording.
#pragma once

#include "app/session/job.h"
#include "app/session/run_recorder.h"
#include "app/session/session_file.h"
#include "device/sample_source.h"
#include "engine/base/result.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <thread>

namespace driftbench {

class AcquisitionSink;

class Acquisition final : public QObject
{
    Q_OBJECT

public:
    enum class State
    {
        Idle,
        Opening,
        Running,
        Stopping,
    };
    Q_ENUM(State)

    // Called on the thread of the source, where opening may take its time.
    using OpenSource = std::function<Result<std::unique_ptr<SampleSource>>()>;

    explicit Acquisition(QObject *parent = nullptr);
    ~Acquisition() override;

    bool start(OpenSource open); // false unless idle
    void stop();                 // finished() follows

    State state() const { return m_state; }
    const std::optional<SourceInfo> &info() const { return m_info; } // of the running source

    // While the source runs. InvalidOption: it does not, or is recorded already; errors of the recorder.
    // A run that is begun or continued ends with recordingFinished, at the latest when the source ends.
    Status startRecording(const SessionFile &file, const QString &runName,
                          const RecorderOptions &options = {});
    Status continueRecording(const SessionFile &file, RunId run, const RecorderOptions &options = {});
    // What waits is written by a thread of its own.
    void stopRecording();

    bool isRecording() const; // until recordingFinished
    std::optional<RunId> recordingRun() const;
    // In the source's time: where the recorded run's time is 0; nothing before its first sample.
    std::optional<double> recordedFromS() const;
    std::optional<RecorderStats> recorderStats() const;
    // After recordingFinished with an error: tries again, or gives what could not be written and forgets it.
    bool finishAgain();
    std::optional<Recording> takeUnwritten();

signals:
    void stateChanged(driftbench::Acquisition::State state);
    void started(const driftbench::SourceInfo &info); // not of one that was stopped while it was opened
    void batch(const std::shared_ptr<const driftbench::SampleBlock> &samples);
    void gap(const driftbench::SampleGap &gap);
    void sourceSaid(const QString &sentence);
    void recordingStarted(driftbench::RunId run);
    void recorderEvent(const driftbench::RecorderEvent &event);
    void recordingFinished(driftbench::RunId run, const driftbench::Status &outcome);
    // The error of opening, or what the source's run() returned.
    void finished(const driftbench::Result<driftbench::SourceStats> &outcome);

private:
    void setState(State state);
    void drain();
    void sourceStarted(const SourceInfo &info);
    void sourceEnded(const Result<SourceStats> &outcome);
    Status mayRecord() const;
    RecorderOptions forwarded(RecorderOptions options);
    void record(std::unique_ptr<RunRecorder> recorder);
    void finishRecorder();

    std::shared_ptr<AcquisitionSink> m_sink; // shared with the thread of the source
    std::shared_ptr<RunRecorder> m_recorder; // in use, or being finished, or failed
    State m_state = State::Idle;
    std::optional<SourceInfo> m_info;
    QTimer m_timer;
    bool m_recording = false;
    TaskJob m_finishing;
    OwnerMailbox m_mailbox;
    std::jthread m_thread;
};

} // namespace driftbench
