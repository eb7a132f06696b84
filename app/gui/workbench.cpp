#include "app/gui/workbench.h"

#include <utility>

namespace driftbench {

Result<std::unique_ptr<Workbench>> Workbench::create(WorkbenchOptions options, const Settings &settings)
{
    auto session = Session::createUnnamed(options.sessionFolder);
    if (!session)
        return session.error();
    return std::unique_ptr<Workbench>(new Workbench(std::move(options), settings, *std::move(session)));
}

Workbench::Workbench(WorkbenchOptions options, Settings settings, std::unique_ptr<Session> session)
    : m_options(std::move(options)), m_settings(std::move(settings)), m_session(std::move(session))
{
    // The simulated bridge is there without a look.
    m_devices = listDevices({}, [](UsbId) { return KernelDriverReport{}; }, {});
    connectSession();
    connectJobs();
    if (m_options.watchDevices)
        startWatch();
}

Workbench::~Workbench()
{
    m_watch.reset();
    m_acquisition.disconnect(this);
}

void Workbench::connectSession()
{
    const Session *from = m_session.get();
    connect(from, &Session::nameChanged, this, &Workbench::nameChanged);
    connect(from, &Session::sourceChanged, this, &Workbench::sourceChanged);
    connect(from, &Session::testPlanChanged, this, &Workbench::testPlanChanged);
    connect(from, &Session::runsChanged, this, &Workbench::runsChanged);
    connect(from, &Session::planChanged, this, &Workbench::planChanged);
    connect(from, &Session::preparedChanged, this, &Workbench::preparedChanged);
    connect(from, &Session::resultChanged, this, &Workbench::resultChanged);
    connect(from, &Session::exportChoiceChanged, this, &Workbench::exportChoiceChanged);
    connect(from, &Session::exportsChanged, this, &Workbench::exportsChanged);
    connect(from, &Session::uploadsChanged, this, &Workbench::uploadsChanged);
    connect(from, &Session::notesChanged, this, &Workbench::notesChanged);
    connect(from, &Session::eventAdded, this, &Workbench::eventAdded);
    connect(from, &Session::savedAgain, this, &Workbench::savedChanged);
    connect(from, &Session::savingFailed, this, [this](const QString &sentence) {
        emit problem({Errc::OutputNotWritable, sentence.toStdString()});
        emit savedChanged();
    });
}

void Workbench::connectJobs()
{
    connect(&m_acquisition, &Acquisition::stateChanged, this, [this](Acquisition::State state) {
        if (state != Acquisition::State::Idle)
            return;
        if (m_watch)
            m_watch->setInUse({});
        if (std::exchange(m_startPending, false))
            openNow();
    });
    connect(&m_acquisition, &Acquisition::finished, this, [this](const Result<SourceStats> &outcome) {
        if (!outcome)
            emit problem(outcome.error());
    });
    connect(&m_acquisition, &Acquisition::recordingFinished, this, [this](RunId, const Status &outcome) {
        if (!outcome)
            emit problem(outcome.error());
        if (const Status read = m_session->refreshRuns(); !read)
            emit problem(read.error());
    });
    connect(&m_acquisition, &Acquisition::recordingStarted, this, [this](RunId) {
        if (const Status read = m_session->refreshRuns(); !read)
            emit problem(read.error());
    });
    connect(&m_loading, &LoadJob::finished, this, [this](const std::vector<LoadedLog> &logs) {
        for (const LoadedLog &log : logs) {
            if (!log.run)
                tellUnlessCancelled(log.run.error());
        }
        if (const Status read = m_session->refreshRuns(); !read)
            emit problem(read.error());
    });
    // A job that was started for a session that is gone has nothing to say to the next one.
    connect(&m_training, &TrainingJob::prepared, this,
            [this](const std::shared_ptr<const PreparedCampaign> &campaign) {
                if (m_trainedFor == m_session.get())
                    m_session->setPrepared(campaign);
            });
    connect(&m_training, &TrainingJob::trained, this,
            [this](const Result<std::shared_ptr<const CalibrationResult>> &outcome) {
                if (m_trainedFor != m_session.get())
                    return;
                const Status taken = outcome ? m_session->setResult(*outcome) : Status(outcome.error());
                if (!taken)
                    tellUnlessCancelled(taken.error());
            });
    connect(&m_training, &TrainingJob::failed, this, &Workbench::tellUnlessCancelled);
}

// A cancel is what was wanted.
void Workbench::tellUnlessCancelled(const Error &error)
{
    if (error.code != Errc::Cancelled)
        emit problem(error);
}

static Error beingRecorded()
{
    return {Errc::SessionInUse, "A run is being recorded into this session; stop it first."};
}

Status Workbench::newSession()
{
    if (m_acquisition.isRecording())
        return beingRecorded();
    auto made = Session::createUnnamed(m_options.sessionFolder);
    if (!made)
        return made.error();
    take(*std::move(made));
    return {};
}

Status Workbench::openSession(const std::filesystem::path &file)
{
    std::error_code code;
    if (std::filesystem::equivalent(file, m_session->path(), code))
        return {};
    if (m_acquisition.isRecording())
        return beingRecorded();
    auto opened = Session::open(file);
    if (!opened)
        return opened.error();
    take(*std::move(opened));
    if (!m_session->isUnnamed())
        rememberSession();
    return {};
}

void Workbench::rememberSession()
{
    const QString path = QString::fromStdString(m_session->path().string());
    changeSettings([&](Settings &settings) {
        addRecent(settings.recentSessions, path);
        settings.lastSession = path;
    });
}

Status Workbench::saveSessionAs(const std::filesystem::path &file)
{
    if (m_acquisition.isRecording())
        return beingRecorded();
    if (Status saved = m_session->saveAs(file); !saved)
        return saved;
    rememberSession();
    return {};
}

void Workbench::take(std::unique_ptr<Session> session)
{
    m_training.cancel();
    m_loading.cancel();
    m_trainedFor = nullptr;
    stopSource();
    m_session->disconnect(this);
    m_session = std::move(session);
    connectSession();
    m_choice = m_session->source();
    emit sessionReplaced();
    emit nameChanged();
    emit sourceChanged();
    emit testPlanChanged();
    emit runsChanged();
    emit planChanged();
    emit preparedChanged();
    emit resultChanged();
    emit exportChoiceChanged();
    emit exportsChanged();
    emit uploadsChanged();
    emit notesChanged();
    emit savedChanged();
}

void Workbench::changeSettings(const std::function<void(Settings &)> &change)
{
    Settings changed = m_settings;
    change(changed);
    if (changed == m_settings)
        return;
    m_settings = std::move(changed);
    emit settingsChanged();
}

Status Workbench::importLogs(const std::vector<std::filesystem::path> &files, const LoadInput &how)
{
    if (m_loading.isRunning())
        return Error{Errc::InvalidOption, "Other logs are being read; wait for them, or cancel."};
    LoadInput input = how;
    input.files = files;
    const auto file = m_session->anotherFile();
    if (!file)
        return file.error();
    input.file = *file;
    m_loading.start(std::move(input));
    return {};
}

Status Workbench::startTraining(bool train)
{
    if (m_training.isRunning())
        return Error{Errc::InvalidOption, "Models are being trained; wait for them, or cancel."};
    auto input = m_session->trainingInput(train);
    if (!input)
        return input.error();
    m_trainedFor = m_session.get();
    m_training.start(*std::move(input));
    return {};
}

Status Workbench::prepare()
{
    return m_session->prepared() ? Status() : startTraining(false);
}

Status Workbench::train()
{
    return startTraining(true);
}

} // namespace driftbench
