// What the window does with the session as a file, and what it keeps of itself.
#include "app/gui/banner_of.h"
#include "app/gui/event_log.h"
#include "app/gui/file_dialogs.h"
#include "app/gui/main_window.h"
#include "app/gui/pages/source_page.h"
#include "app/gui/workbench.h"
#include "widgets/style/number_text.h"

#include <QMenuBar>
#include <QMessageBox>
#include <QSplitter>
#include <QUndoStack>

namespace driftbench {

static constexpr QSize kFirstSize(1280, 720);
static const QString kRestored = QStringLiteral("restored");

void MainWindow::tell(const Status &outcome)
{
    if (outcome)
        return;
    const QString sentence = QString::fromStdString(outcome.error().message);
    m_context.events.add(EventKind::Bad, sentence);
    page(m_step)->banners().post(QStringLiteral("session"),
                                 {BannerKind::Bad, sentence, {}, {}, {}, {}, true});
}

void MainWindow::newSession()
{
    if (m_bench.acquisition().isRecording())
        return tell(Error{Errc::SessionInUse, "A run is being recorded into this session; stop it first."});
    tell(m_bench.newSession());
    showStep(Step::Source);
}

void MainWindow::askOpen()
{
    askOpenFiles(
        *this, m_bench, tr("Open logs or a session"),
        tr("Logs and sessions (*.csv *.tsv *.txt *.ulg *.bin *.BIN *.log *.driftbench);;All files (*)"),
        [this](const std::vector<std::filesystem::path> &files) { openFiles(files); });
}

void MainWindow::askSaveSession()
{
    askSaveFile(*this, m_bench, tr("Save session"), tr("Sessions (*.driftbench)"),
                m_bench.session().isUnnamed() ? QStringLiteral("campaign.driftbench")
                                              : m_bench.session().name() + QStringLiteral(".driftbench"),
                [this](const std::filesystem::path &file) { tell(m_bench.saveSessionAs(file)); });
}

void MainWindow::save()
{
    if (QAction *own = page(m_step)->saveAction())
        return own->trigger();
    if (m_bench.session().isUnnamed())
        return askSaveSession();
    tell(m_bench.session().saveAgain());
}

void MainWindow::undo(bool back)
{
    if (QUndoStack *own = page(m_step)->undoStack()) {
        if (back)
            own->undo();
        else
            own->redo();
        return;
    }
    tell(back ? m_bench.session().undo() : m_bench.session().redo());
}

QString MainWindow::sessionText() const
{
    const Session &session = m_bench.session();
    const bool empty = session.runs().empty() && !session.testPlan();
    if (session.isUnnamed() && empty)
        return tr("New session, not saved yet");
    const QString file =
        session.isUnnamed()
            ? tr("Unnamed session")
            : tr("Session: %1").arg(QString::fromStdString(session.path().filename().string()));
    if (session.isReadOnly())
        return tr("%1 · read-only").arg(file);
    return session.isSaved() ? tr("%1 · saved").arg(file) : tr("%1 · not saved").arg(file);
}

void MainWindow::showSession()
{
    const Session &session = m_bench.session();
    m_corner->setText(sessionText());
    m_corner->setTone(session.isSaved() ? Tone::Plain : Tone::Caution);
    m_corner->setToolTip(session.isReadOnly() ? session.readOnlyReason()
                                              : QString::fromStdString(session.path().string()));
    m_corner->adjustSize();
    menuBar()->setCornerWidget(m_corner, Qt::TopRightCorner); // which only then looks how wide it is
    setWindowTitle(session.isUnnamed() ? tr("Driftbench") : tr("%1 – Driftbench").arg(session.name()));
}

void MainWindow::logEvents()
{
    EventLog &log = m_context.events;
    connect(&m_bench, &Workbench::problem, &log,
            [&log](const Error &error) { log.add(EventKind::Bad, QString::fromStdString(error.message)); });
    connect(&m_bench, &Workbench::eventAdded, &log, [&log](const SessionEvent &event) {
        const EventSeverity severity = severityOf(event);
        log.add(severity == EventSeverity::Note      ? EventKind::Info
                : severity == EventSeverity::Warning ? EventKind::Caution
                                                     : EventKind::Bad,
                QString::fromStdString(event.text));
    });
    Acquisition &acquisition = m_bench.acquisition();
    connect(&acquisition, &Acquisition::started, &log, [this, &log] {
        //: %1 is the name of a source
        log.add(EventKind::Info, tr("%1 is running.").arg(m_bench.sourceName()));
    });
    connect(&acquisition, &Acquisition::sourceSaid, &log,
            [&log](const QString &sentence) { log.add(EventKind::Caution, sentence); });
    connect(&acquisition, &Acquisition::gap, &log, [&log](const SampleGap &gap) {
        log.add(EventKind::Caution, tr("Gap from %1 to %2 s: %3.")
                                        .arg(numberText(gap.startS, 2), numberText(gap.endS, 2),
                                             QString::fromUtf8(gapCauseText(gap.cause).data())));
    });
    connect(&acquisition, &Acquisition::recorderEvent, &log, [&log](const RecorderEvent &event) {
        log.add(event.kind == RecorderEventKind::Recovered ? EventKind::Info : EventKind::Bad,
                QString::fromStdString(event.sentence));
    });
}

void MainWindow::restoreSession()
{
    const QString last = m_bench.settings().lastSession;
    const std::filesystem::path folder = m_bench.session().path().parent_path();
    std::error_code code;
    const auto unnamed = Session::unnamedSessions(folder);
    // What was never named is nowhere else: it comes first.
    if (!unnamed.empty())
        tell(m_bench.openSession(unnamed.front()));
    else if (!last.isEmpty() && std::filesystem::exists(last.toStdString(), code))
        tell(m_bench.openSession(last.toStdString()));
    const Session &session = m_bench.session();
    const Settings &settings = m_bench.settings();
    const bool newcomer = settings.recentSessions.isEmpty() && settings.recentLogs.isEmpty() &&
                          settings.lastSource.isEmpty() && session.runs().empty();
    if (newcomer)
        showStart();
    if (!session.recoveredRuns().empty()) {
        const RunRecord *run = session.run(session.recoveredRuns().back());
        const QString samples = run ? numberText(static_cast<double>(run->samples), 0) : QString();
        page(m_step)->banners().post(
            kRestored,
            bannerOf(
                BannerKind::Info, [] { return tr("Session restored."); },
                [samples] {
                    return tr("Recording stopped when the program ended. %1 samples are safe.").arg(samples);
                }));
    } else if (!unnamed.empty()) {
        page(m_step)->banners().post(kRestored,
                                     bannerOf(
                                         BannerKind::Info, [] { return tr("Session restored."); },
                                         [] { return tr("It has no name yet; Save gives it one."); }));
    }
}

bool MainWindow::mayClose()
{
    const bool recording = m_bench.acquisition().isRecording();
    const auto recorder = m_bench.acquisition().recorderStats();
    const bool allWritten = m_bench.session().isSaved() && (!recorder || recorder->queued() == 0);
    if (!recording && allWritten)
        return true;
    QMessageBox box(this);
    box.setIcon(QMessageBox::Warning);
    box.setWindowTitle(tr("Quit Driftbench"));
    box.setText(recording ? tr("A run is being recorded.") : tr("The last changes are not on the disk."));
    box.setInformativeText(recording ? tr("Quit ends the run. What was recorded is kept.")
                                     : tr("Make room or permit the file to be written, then save again."));
    const auto *quit = box.addButton(recording ? tr("End the run and quit") : tr("Quit and lose them"),
                                     QMessageBox::DestructiveRole);
    box.addButton(tr("Go on"), QMessageBox::RejectRole);
    box.exec();
    return box.clickedButton() == quit;
}

void MainWindow::restoreWindow()
{
    const Settings &settings = m_bench.settings();
    resize(kFirstSize);
    restoreGeometry(settings.windowGeometry);
    restoreState(settings.windowState);
    for (QSplitter *splitter : findChildren<QSplitter *>()) {
        if (const QByteArray state = settings.splitters.value(splitter->objectName()); !state.isEmpty())
            splitter->restoreState(state);
    }
}

void MainWindow::saveWindow()
{
    m_bench.changeSettings([this](Settings &settings) {
        settings.windowGeometry = saveGeometry();
        settings.windowState = saveState();
        for (const QSplitter *splitter : findChildren<QSplitter *>()) {
            if (!splitter->objectName().isEmpty())
                settings.splitters[splitter->objectName()] = splitter->saveState();
        }
        settings.lastSession = m_bench.session().isUnnamed()
                                   ? QString()
                                   : QString::fromStdString(m_bench.session().path().string());
    });
}

} // namespace driftbench
