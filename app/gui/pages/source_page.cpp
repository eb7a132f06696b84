#include "app/gui/pages/source_page.h"

#include "app/gui/event_log.h"
#include "app/gui/source/bridge_list.h"
#include "app/gui/source/drop_strip.h"
#include "app/gui/source/source_form.h"
#include "app/gui/workbench.h"
#include "widgets/controls/loading_state.h"
#include "widgets/controls/section_head.h"
#include "widgets/style/number_text.h"
#include "widgets/views/strip_view.h"

#include <QFileInfo>
#include <QTableView>

namespace driftbench {

static constexpr int kEditsTogetherMs = 300;
static const QString kPermission = QStringLiteral("permission");
static const QString kProblem = QStringLiteral("problem");

SourcePage::SourcePage(AppContext &context, QWidget *parent)
    : Page(context, parent)
    , m_bench(*context.workbench)
    , m_bridges(new BridgeModel(this))
    , m_recent(new RecentFilesModel(this))
{
    buildActions();
    buildBody();
    m_apply.setSingleShot(true);
    m_apply.setInterval(kEditsTogetherMs);
    connect(&m_apply, &QTimer::timeout, this, &SourcePage::applyChoice);
    connectBench();
    connectLoading();
    showDevices();
    showRecent();
    showUse();
}

SourcePage::~SourcePage() = default;

void SourcePage::connectBench()
{
    connect(&m_bench, &Workbench::devicesChanged, this, &SourcePage::showDevices);
    connect(&m_bench, &Workbench::settingsChanged, this, &SourcePage::showRecent);
    connect(&m_bench, &Workbench::sourceChanged, this, [this] {
        showUse();
        emit stateChanged();
    });
    connect(&m_bench, &Workbench::runsChanged, this, &SourcePage::showUse);
    connect(&m_bench, &Workbench::sessionReplaced, this, [this] {
        if (const auto &source = m_bench.session().source())
            m_form->simulated().setChoice(*source);
        m_strips->clear();
        m_chosenFile.clear();
        chooseRow(-1);
    });
    Acquisition &acquisition = m_bench.acquisition();
    connect(&acquisition, &Acquisition::batch, this,
            [this](const std::shared_ptr<const SampleBlock> &samples) {
                m_strips->append(*samples);
                showRunning();
            });
    connect(&acquisition, &Acquisition::started, this, [this] {
        m_dropped = 0;
        m_strips->clear();
        banners().withdraw(kProblem);
        showRunning();
    });
    connect(&acquisition, &Acquisition::gap, this,
            [this](const SampleGap &gap) { m_dropped += std::max<std::int64_t>(0, gap.lostSamples); });
    connect(&acquisition, &Acquisition::stateChanged, this, &SourcePage::showRunning);
    connect(&acquisition, &Acquisition::finished, this, [this](const Result<SourceStats> &outcome) {
        if (!outcome)
            tell(outcome.error());
    });
}

void SourcePage::connectLoading()
{
    LoadJob &loading = m_bench.loading();
    connect(&loading, &Job::progress, this,
            [this](const QString &stage, double fraction) { m_loadingState->setProgress(stage, fraction); });
    connect(m_loadingState, &LoadingState::cancelled, &loading, &Job::cancel);
    connect(&loading, &Job::runningChanged, this, [this](bool running) {
        if (running)
            m_loadingState->setProgress(tr("Reading"), -1.0);
        showFilesPlace();
        showUse();
        emit stateChanged();
    });
    connect(&loading, &LoadJob::finished, this, &SourcePage::takeLoaded);
}

StepState SourcePage::stepState() const
{
    if (m_bench.loading().isRunning())
        return {tr("Reading logs"), true, StepMark::Working};
    const auto &runs = m_bench.session().runs();
    if (const auto &source = m_bench.session().source()) {
        const auto *file = source->as<FileChoice>();
        const QString name = file ? QString::fromStdString(file->path.filename().string())
                             : source->as<SimulatedChoice>() ? tr("Simulated bridge")
                             : source->as<NativeChoice>()    ? tr("Gyro bridge")
                                                             : tr("I2C bridge");
        return {name, true, StepMark::Done};
    }
    if (!runs.empty()) {
        const QString first = QFileInfo(QString::fromStdString(runs.front().description.source)).fileName();
        const bool one = runs.size() == 1;
        return {one ? first : tr("%n logs", nullptr, static_cast<int>(runs.size())), true, StepMark::Done};
    }
    return {};
}

QString SourcePage::hints() const
{
    return tr("Up, Down choose · Enter use · F5 look again · Ctrl+O open files · Alt+1 to 7 steps");
}

std::vector<StatusPart> SourcePage::statusParts() const
{
    const int plugged = m_bridges->pluggedIn();
    return {{tr("%n bridges plugged in, %1 usable", nullptr, plugged).arg(m_bridges->usable())}};
}

// The session's own source, if it is there; a session of logs has none. A new one begins with the simulated
// bridge.
int SourcePage::rowAtFirst() const
{
    const Session &session = m_bench.session();
    if (const auto &source = session.source(); source && !source->as<SimulatedChoice>())
        return m_bridges->rowOf(sourceChoiceText(*source));
    return session.source() || session.runs().empty() ? 0 : -1;
}

void SourcePage::entered()
{
    showRecent();
    if (m_chosenSource.empty() && m_chosenFile.empty())
        chooseRow(rowAtFirst());
    else if (m_bench.acquisition().state() == Acquisition::State::Idle)
        applyChoice();
}

void SourcePage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    entered();
}

void SourcePage::showDevices()
{
    const std::string before = m_chosenSource;
    m_bridges->setDevices(m_bench.devices());
    m_list->updateGeometry();
    const int row = m_bridges->rowOf(before);
    if (row >= 0 && m_list->currentIndex().row() != row)
        m_list->setCurrentIndex(m_bridges->index(row));
    else if (before.empty() && m_chosenFile.empty() && rowAtFirst() >= 0)
        chooseRow(rowAtFirst());
    showPermission();
    showUse();
    emit stateChanged();
}

// The first bridge that is there but may not be opened.
void SourcePage::showPermission()
{
    for (int row = 0; row < m_bridges->rowCount(); ++row) {
        const DeviceEntry &device = m_bridges->device(row);
        if (device.status.ok() || device.status.error().code != Errc::DeviceNotPermitted)
            continue;
        m_permissionLine = udevLine(device);
        const QString id = bridgePlace(device).section(QStringLiteral(" · "), 0, 0);
        banners().post(kPermission,
                       {BannerKind::Caution,
                        tr("%1 %2 is plugged in, but you may not open it.").arg(bridgeName(device), id),
                        tr("Save this line as 70-driftbench.rules in /etc/udev/rules.d, then unplug the "
                           "bridge and plug it in again:"),
                        m_permissionLine,
                        QStringLiteral("lock"),
                        {m_copyLine, m_lookAgain},
                        false});
        return;
    }
    banners().withdraw(kPermission);
}

void SourcePage::showRecent()
{
    QStringList files = m_bench.settings().recentSessions;
    files += m_bench.settings().recentLogs;
    QStringList shown;
    for (int row = 0; row < m_recent->rowCount(); ++row)
        shown << QString::fromStdString(m_recent->survey(row).path.string());
    if (shown != files)
        m_recent->setFiles(files);
    showFilesPlace();
}

void SourcePage::chooseSimulated()
{
    chooseRow(0);
}

void SourcePage::chooseRow(int row)
{
    if (row >= m_bridges->rowCount())
        return;
    if (row < 0) {
        m_chosenSource.clear();
        m_list->clearSelection();
        m_list->setCurrentIndex({});
        m_form->showNothing();
        return showUse();
    }
    const DeviceEntry &device = m_bridges->device(row);
    m_chosenSource = device.source;
    m_chosenFile.clear();
    m_table->clearSelection();
    if (m_list->currentIndex().row() != row)
        m_list->setCurrentIndex(m_bridges->index(row));
    m_form->showDevice(device);
    m_now->show();
    applyChoice();
}

void SourcePage::chooseFile(int row)
{
    if (row < 0)
        return;
    m_chosenFile = m_recent->survey(row).path;
    m_chosenSource.clear();
    m_list->clearSelection();
    m_list->setCurrentIndex({});
    m_form->showFile(m_recent->survey(row));
    m_now->hide();
    if (!m_bench.acquisition().isRecording())
        m_bench.stopSource();
    m_strips->clear();
    showUse();
}

// A bridge that can be used is let run, with what the form says.
void SourcePage::applyChoice()
{
    m_apply.stop();
    ChoiceForm *form = m_form->current();
    const int row = m_bridges->rowOf(m_chosenSource);
    if (!form || m_chosenSource.empty() || row < 0 || !isVisible() || m_bench.acquisition().isRecording()) {
        showUse();
        return;
    }
    const DeviceEntry &device = m_bridges->device(row);
    if (device.usable() || device.inUse) {
        m_bench.setSourceChoice(form->choice());
        m_bench.startSource(SourceUse::Watch);
    } else {
        m_bench.stopSource();
        m_strips->clear();
    }
    showUse();
}

void SourcePage::showRunning()
{
    Acquisition &acquisition = m_bench.acquisition();
    const bool runs = acquisition.state() == Acquisition::State::Running ||
                      acquisition.state() == Acquisition::State::Opening;
    StreamingText text;
    text.settings = m_form->simulated().settingsText();
    text.hasSamples = acquisition.state() == Acquisition::State::Running && m_strips->latest(0).has_value();
    text.rateHz = m_strips->measuredRateHz();
    text.temperatureC = m_strips->latest(StripView::kStrips - 1).value_or(0.0);
    m_bridges->setStreaming(runs && !m_chosenSource.empty() ? std::optional(m_chosenSource) : std::nullopt,
                            text);
}

void SourcePage::use()
{
    if (!m_use->isEnabled())
        return;
    if (m_chosenFile.empty()) {
        if (m_apply.isActive() || !m_bench.sourceChoice())
            applyChoice();
        if (const Status used = m_bench.useSource(); !used)
            return tell(used.error());
        return context().navigator.go(Step::Plan);
    }
    if (m_form->isLog() && m_form->log().isPlayedBack()) {
        m_bench.setSourceChoice(m_form->log().choice());
        if (const Status used = m_bench.useSource(); !used)
            return tell(used.error());
        return context().navigator.go(Step::Record);
    }
    openFiles({m_chosenFile});
}

void SourcePage::openFiles(const std::vector<std::filesystem::path> &files)
{
    std::vector<std::filesystem::path> logs;
    for (const std::filesystem::path &file : files) {
        if (file.extension() != kSessionEnding)
            logs.push_back(file);
        else if (const Status opened = m_bench.openSession(file); !opened)
            tell(opened.error());
    }
    if (logs.empty())
        return;
    const bool asChosen = logs.size() == 1 && logs.front() == m_chosenFile;
    if (const Status started = m_bench.importLogs(logs, asChosen ? m_form->log().loadInput() : LoadInput());
        !started)
        tell(started.error());
}

void SourcePage::takeLoaded(const std::vector<LoadedLog> &logs)
{
    int read = 0;
    for (const LoadedLog &log : logs) {
        if (!log.run && log.run.error().code != Errc::Cancelled)
            tell(log.run.error());
        read += log.run.ok() ? 1 : 0;
    }
    m_bench.changeSettings([&](Settings &settings) {
        for (auto log = logs.rbegin(); log != logs.rend(); ++log) {
            if (log->run)
                addRecent(settings.recentLogs,
                          QString::fromStdString(std::filesystem::absolute(log->path).string()));
        }
    });
    if (read > 0 && read == static_cast<int>(logs.size()))
        context().navigator.go(Step::Inspect);
}

void SourcePage::tell(const Error &error)
{
    banners().post(kProblem, {BannerKind::Bad, QString::fromStdString(error.message), {}, {}, {}, {}, true});
}

} // namespace driftbench
