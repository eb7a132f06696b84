#include "app/session/acquisition.h"

#include "app/session/acquisition_sink.h"

#include <chrono>
#include <utility>

namespace driftbench {

namespace {

constexpr std::chrono::milliseconds kBatchEvery{40};

} // namespace

Acquisition::Acquisition(QObject *parent) : QObject(parent)
{
    m_timer.setInterval(kBatchEvery);
    connect(&m_timer, &QTimer::timeout, this, &Acquisition::drain);
    connect(&m_finishing, &TaskJob::finished, this, [this](const Status &outcome) {
        m_recording = false;
        const RunId run = m_recorder->run();
        if (outcome)
            m_recorder.reset();
        emit recordingFinished(run, outcome);
    });
}

Acquisition::~Acquisition()
{
    m_thread.request_stop();
    if (m_thread.joinable())
        m_thread.join();
    // The recorder's own destructor writes what waits.
}

void Acquisition::setState(State state)
{
    if (m_state == state)
        return;
    m_state = state;
    emit stateChanged(state);
}

bool Acquisition::start(OpenSource open)
{
    if (m_state != State::Idle)
        return false;
    if (m_thread.joinable())
        m_thread.join();
    m_info.reset();
    m_sink = std::make_shared<AcquisitionSink>();
    m_thread = std::jthread([this, sink = m_sink, open = std::move(open),
                             post = m_mailbox.sender()](const std::stop_token &stop) {
        auto source = open();
        if (!source) {
            post.post([this, error = source.error()] { sourceEnded(error); });
            return;
        }
        post.post([this, info = (*source)->info()] { sourceStarted(info); });
        auto outcome = (*source)->run(*sink, stop);
        source->reset(); // closed before anyone hears of it, so that it can be opened again
        post.post([this, outcome = std::move(outcome)] { sourceEnded(outcome); });
    });
    setState(State::Opening);
    return true;
}

void Acquisition::sourceStarted(const SourceInfo &info)
{
    if (m_state != State::Opening)
        return; // stopped meanwhile: who waits for the next source would take it for that
    m_info = info;
    setState(State::Running);
    m_timer.start();
    emit started(info);
}

void Acquisition::stop()
{
    if (m_state == State::Idle)
        return;
    m_thread.request_stop();
    setState(State::Stopping);
}

void Acquisition::drain()
{
    // A slot may start the next source.
    const std::shared_ptr<AcquisitionSink> sink = m_sink;
    for (const AcquisitionSink::Item &item : sink->take()) {
        if (const auto *samples = std::get_if<std::shared_ptr<const SampleBlock>>(&item))
            emit batch(*samples);
        else if (const auto *lost = std::get_if<SampleGap>(&item))
            emit gap(*lost);
        else
            emit sourceSaid(QString::fromStdString(std::get<std::string>(item)));
    }
    if (sink == m_sink && sink->isRefused())
        stopRecording();
}

void Acquisition::sourceEnded(const Result<SourceStats> &outcome)
{
    m_thread.join();
    m_timer.stop();
    drain();
    stopRecording();
    setState(State::Idle);
    emit finished(outcome);
}

Status Acquisition::mayRecord() const
{
    if (m_state != State::Running)
        return Error{Errc::InvalidOption, "No source is running that could be recorded; start one first."};
    if (m_recording)
        return Error{Errc::InvalidOption, "The source is being recorded already; stop that first."};
    if (m_recorder)
        return Error{Errc::InvalidOption,
                     "The run before could not be written; write it again, or save what of it "
                     "is in memory, first."};
    return {};
}

RecorderOptions Acquisition::forwarded(RecorderOptions options)
{
    options.onEvent = [this, also = options.onEvent, post = m_mailbox.sender()](const RecorderEvent &what) {
        if (also)
            also(what);
        post.post([this, what] { emit recorderEvent(what); });
    };
    return options;
}

Status Acquisition::startRecording(const SessionFile &file, const QString &runName,
                                   const RecorderOptions &options)
{
    if (Status may = mayRecord(); !may)
        return may;
    auto recorder =
        RunRecorder::start(file, describeSource(*m_info, runName.toStdString()), forwarded(options));
    if (!recorder)
        return recorder.error();
    record(*std::move(recorder));
    return {};
}

Status Acquisition::continueRecording(const SessionFile &file, RunId run, const RecorderOptions &options)
{
    if (Status may = mayRecord(); !may)
        return may;
    auto recorder = RunRecorder::resume(file, run, *m_info, forwarded(options));
    if (!recorder)
        return recorder.error();
    record(*std::move(recorder));
    return {};
}

void Acquisition::record(std::unique_ptr<RunRecorder> recorder)
{
    m_recorder = std::move(recorder);
    m_recording = true;
    m_sink->setRecorder(m_recorder);
    emit recordingStarted(m_recorder->run());
}

void Acquisition::stopRecording()
{
    if (!m_recording || m_finishing.isRunning())
        return;
    m_sink->setRecorder(nullptr);
    finishRecorder();
}

void Acquisition::finishRecorder()
{
    m_finishing.start([recorder = m_recorder](const ProgressHook &) { return recorder->finish(); });
}

bool Acquisition::isRecording() const
{
    return m_recording;
}

std::optional<RunId> Acquisition::recordingRun() const
{
    return m_recorder ? std::optional(m_recorder->run()) : std::nullopt;
}

std::optional<double> Acquisition::recordedFromS() const
{
    return m_recording && m_sink ? m_sink->recordedFromS() : std::nullopt;
}

std::optional<RecorderStats> Acquisition::recorderStats() const
{
    return m_recorder ? std::optional(m_recorder->stats()) : std::nullopt;
}

bool Acquisition::finishAgain()
{
    if (m_recording || !m_recorder)
        return false;
    m_recording = true;
    finishRecorder();
    return true;
}

std::optional<Recording> Acquisition::takeUnwritten()
{
    if (m_recording || !m_recorder)
        return std::nullopt;
    Recording rest = m_recorder->unwritten();
    m_recorder.reset();
    return rest;
}

} // namespace driftbench
