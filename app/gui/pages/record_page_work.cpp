// The part of RecordPage that follows the recording: what is started and stopped, and what is said of it.
#include "app/gui/pages/record_page.h"
#include "app/gui/record/live_run.h"
#include "app/gui/record/record_readouts.h"
#include "app/gui/workbench.h"
#include "engine/formats/csv_writer.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/segmented_buttons.h"
#include "widgets/live/live_trace_view.h"
#include "widgets/plot/legend_row.h"
#include "widgets/style/number_text.h"

#include <QFileDialog>
#include <QStackedWidget>

#include <cmath>

namespace driftbench {

static QString sentenceOf(const Error &error)
{
    return QString::fromStdString(error.message);
}

void RecordPage::startRecording()
{
    Workbench &workbench = *context().workbench;
    if (workbench.acquisition().isRecording() || m_starting)
        return;
    banners().withdraw(QStringLiteral("ended"));
    banners().withdraw(QStringLiteral("source"));
    if (!workbench.sourceChoice()) {
        say(
            QStringLiteral("source"), BannerKind::Caution, [] { return tr("No source is chosen."); },
            [] { return tr("Choose the bridge or the file to record from."); }, {m_goToSource});
        return;
    }
    m_brokenOff = false;
    m_starting = workbench.startSource(SourceUse::Record);
    showState();
}

void RecordPage::sourceStarted()
{
    if (!m_starting)
        return;
    m_starting = false;
    Workbench &workbench = *context().workbench;
    const QString name = QStringLiteral("run%1").arg(workbench.session().runs().size() + 1);
    const Status started = workbench.acquisition().startRecording(workbench.session().file(), name);
    if (!started.ok()) {
        workbench.stopSource();
        say(
            QStringLiteral("source"), BannerKind::Bad, [] { return tr("The run can't be recorded."); },
            sentenceOf(started.error()));
        emit workbench.problem(started.error());
    }
    m_readouts->clearTrend();
    showState();
}

void RecordPage::sourceEnded(const Error &error)
{
    if (!m_starting && !m_run->isRecording() && !isVisible())
        return; // watched by another page, which says it
    m_starting = false;
    m_brokenOff = true;
    say(QStringLiteral("source"), BannerKind::Bad, [] { return tr("The source has ended."); },
        sentenceOf(error), {m_goToSource});
}

void RecordPage::stopRecording()
{
    m_brokenOff = true;
    endRun();
}

void RecordPage::endRun()
{
    Workbench &workbench = *context().workbench;
    if (m_run->isRecording())
        workbench.acquisition().stopRecording();
    m_starting = false;
    showState();
}

void RecordPage::recordingFinished(const Status &outcome)
{
    Workbench &workbench = *context().workbench;
    setViewPaused(false);
    banners().withdraw(QStringLiteral("absence"));
    banners().withdraw(QStringLiteral("recorder"));
    workbench.stopSource();
    const QString length = clockText(m_run->elapsedS());
    if (outcome.ok()) {
        const RunRecord *record = m_run->run() ? workbench.session().run(*m_run->run()) : nullptr;
        const QString samples = numberText(record ? static_cast<double>(record->samples) : 0.0, 0);
        const auto what = [run = runNumber(), length, complete = !m_brokenOff] {
            return complete ? tr("Run %1 is complete.").arg(run)
                            : tr("Run %1 was stopped at %2.").arg(run).arg(length);
        };
        say(QStringLiteral("ended"), BannerKind::Info, what,
            [samples] { return tr("%1 samples are in the session.").arg(samples); }, {m_goToInspect});
    } else {
        say(
            QStringLiteral("recorder"), BannerKind::Bad,
            [] { return tr("A part of the run is not on the disk."); },
            [sentence = sentenceOf(outcome.error())] {
                return sentence + QLatin1Char(' ') + tr("It is kept in memory.");
            },
            {m_writeAgain, m_saveRest}, false);
    }
    showState();
}

void RecordPage::recorderSays(const RecorderEvent &event)
{
    const QString key = QStringLiteral("recorder");
    const QString sentence = QString::fromStdString(event.sentence);
    switch (event.kind) {
    case RecorderEventKind::Slow:
        say(
            key, BannerKind::Caution, [] { return tr("The disk is slow."); }, sentence);
        break;
    case RecorderEventKind::Failing:
        say(
            key, BannerKind::Bad, [] { return tr("The disk takes no more."); },
            [sentence] {
                return sentence + QLatin1Char(' ') + tr("Make room on it; recording goes on in memory.");
            },
            {m_stop}, false);
        break;
    case RecorderEventKind::Recovered:
        say(key, BannerKind::Info, [] { return tr("All samples are on the disk again."); }, {});
        break;
    case RecorderEventKind::Full:
        say(
            key, BannerKind::Bad, [] { return tr("The memory for samples is full, the run has ended."); },
            sentence, {}, false);
        break;
    }
}

void RecordPage::saveUnwritten()
{
    auto *dialog = new QFileDialog(window(), tr("Save what is not on the disk"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("CSV log (*.csv)"));
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    connect(dialog, &QFileDialog::fileSelected, this, &RecordPage::writeRest);
    dialog->open();
}

// It is kept until it is on a disk.
void RecordPage::writeRest(const QString &file)
{
    if (auto rest = context().workbench->acquisition().takeUnwritten())
        m_rest = std::make_shared<const Recording>(*std::move(rest));
    if (!m_rest)
        return;
    const bool begun = m_savingRest.start(
        [rest = m_rest, path = file.toStdString()](const ProgressHook &) { return writeCsv(path, *rest); });
    if (begun) {
        m_restFile = file;
        banners().withdraw(QStringLiteral("recorder"));
    }
}

void RecordPage::restWritten(const Status &outcome)
{
    const QString key = QStringLiteral("rest");
    if (!outcome.ok())
        return say(key, BannerKind::Bad, sentenceOf(outcome.error()), {}, {m_saveRest}, false);
    m_rest.reset();
    say(key, BannerKind::Info, [file = m_restFile] { return tr("The rest of the run is in %1.").arg(file); },
        {});
}

void RecordPage::setViewPaused(bool paused)
{
    if (paused && !m_run->isRecording())
        return;
    m_view->setPaused(paused);
    if (!paused)
        banners().withdraw(QStringLiteral("paused"));
    showPauseBanner();
    showState();
}

void RecordPage::showPauseBanner()
{
    if (!m_view->isPaused())
        return;
    BannerContent content;
    content.kind = BannerKind::Info;
    content.icon = QStringLiteral("pause");
    content.what = tr("The view is paused at %1. Recording goes on.").arg(clockText(m_view->pausedAtS()));
    content.toDo = tr("%1 samples have arrived since. The figures on the right stay live.")
                       .arg(numberText(static_cast<double>(m_view->samplesSincePause()), 0));
    content.closable = false;
    banners().post(QStringLiteral("paused"), content);
}

void RecordPage::showAbsence()
{
    const QString key = QStringLiteral("absence");
    if (const auto awayS = m_run->unpluggedAtS())
        say(
            key, BannerKind::Caution,
            [at = clockText(*awayS)] { return tr("The bridge was unplugged at %1.").arg(at); },
            [] { return tr("Plug it in to go on with this run."); }, {m_stop}, false);
    else if (const auto silentS = m_run->silentForS())
        say(
            key, BannerKind::Caution,
            [seconds = numberText(std::floor(*silentS), 0)] {
                return tr("No samples have come for %1 s.").arg(seconds);
            },
            [] {
                return tr("Look at the cable and the bridge; the run goes on as soon as they come again.");
            },
            {m_stop}, false);
    else if (banners().holds(key))
        banners().withdraw(key);
}

void RecordPage::showFigures()
{
    if (m_run->isRecording())
        showAbsence();
    if (isVisible() && (m_run->isRecording() || m_run->hasSamples())) {
        m_readouts->showAll();
        showPauseBanner();
    }
    const auto progress = m_run->isRecording() ? m_run->progress() : std::nullopt;
    const auto percent =
        progress ? std::optional(static_cast<int>(100.0 * progress->fraction)) : std::nullopt;
    const bool moved = percent != m_percent;
    m_percent = percent;
    if (moved || (m_run->isRecording() && m_run->link().lost > 0))
        emit stateChanged();
}

int RecordPage::runNumber() const
{
    const auto &runs = context().workbench->session().runs();
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].id == m_run->run())
            return static_cast<int>(i) + 1;
    }
    return static_cast<int>(runs.size()) + (m_run->isRecording() ? 1 : 0);
}

int RecordPage::runsWanted() const
{
    const auto &plan = context().workbench->session().testPlan();
    return std::max(plan ? plan->runs : 0, runNumber());
}

void RecordPage::showContext()
{
    const bool simulated =
        m_run->hasSamples() || m_run->isRecording()
            ? context().workbench->isSourceSimulated() || context().workbench->session().isSimulated()
            : context().workbench->session().isSimulated();
    if (!m_run->isRecording() && !m_run->hasSamples()) {
        head().setOrigin(Origin::None);
        head().setContext(context().workbench->sourceName());
        return;
    }
    head().setOrigin(simulated                                  ? Origin::Simulated
                     : context().workbench->isSourcePluggedIn() ? Origin::Device
                                                                : Origin::Real);
    const QString run = tr("Run %1 of %2").arg(runNumber()).arg(runsWanted());
    if (!m_run->model()) {
        head().setContext(tr("%1, no model yet").arg(run));
        return;
    }
    QStringList names;
    for (const std::string &name : m_run->model()->trainedOn)
        names.append(QString::fromStdString(name));
    const QString trainedOn = names.size() > 2    ? tr("%1 to %2").arg(names.front(), names.back())
                              : names.size() == 2 ? tr("%1 and %2").arg(names.front(), names.back())
                                                  : names.join(QString());
    head().setContext(tr("%1, compensated by the model of %2").arg(run, trainedOn));
}

void RecordPage::showState()
{
    Workbench &workbench = *context().workbench;
    const bool recording = m_run->isRecording();
    const bool paused = m_view->isPaused();
    m_pause->setText(paused ? tr("Resume view") : tr("Pause view"));
    setActionIcon(*m_pause, paused ? QStringLiteral("play") : QStringLiteral("pause"));
    m_pause->setEnabled(recording);
    m_stop->setEnabled(recording);
    m_start->setEnabled(!recording && !m_starting && !workbench.acquisition().isRecording());
    m_pauseButton->setVisible(recording);
    m_stopButton->setVisible(recording);
    m_startButton->setVisible(!recording);
    m_pauseButton->setPrimary(paused);
    const bool traces = recording || m_run->hasSamples();
    m_panelStack->setCurrentIndex(traces ? 1 : 0);
    for (QWidget *widget : {static_cast<QWidget *>(m_legend), static_cast<QWidget *>(m_span),
                            static_cast<QWidget *>(m_quantity)})
        widget->setEnabled(traces);
    const auto runs = static_cast<int>(workbench.session().runs().size());
    m_empty->setTexts(runs > 0 ? tr("%n run(s) in the session", nullptr, runs) : tr("No runs yet"),
                      workbench.sourceChoice()
                          ? tr("Record the next run from: %1.").arg(workbench.sourceName())
                          : tr("Choose a source, then record a run."));
    m_empty->setActions(workbench.sourceChoice() ? std::vector<QAction *>{m_start}
                                                 : std::vector<QAction *>{m_goToSource});
    showLegend();
    showContext();
    emit stateChanged();
}

StepState RecordPage::stepState() const
{
    const auto count = static_cast<int>(context().workbench->session().runs().size());
    if (m_run->isRecording()) {
        const QString run = tr("Run %1 of %2").arg(runNumber()).arg(runsWanted());
        return {m_percent ? tr("%1 · %2 %").arg(run).arg(*m_percent) : run, true, StepMark::Recording};
    }
    if (m_starting)
        return {tr("Opening the source"), true, StepMark::Working};
    if (count > 0)
        return {tr("%n run(s)", nullptr, count), true, StepMark::Done};
    return {stepPurpose(Step::Record), false, StepMark::None};
}

QString RecordPage::hints() const
{
    if (m_view->isPaused())
        return tr("Space resume the view · Wheel zoom · Drag pan · A, B set a cursor at the mouse");
    return tr(
        "Wheel zoom · Drag pan · Shift+drag box zoom · Double-click fit · A, B set a cursor at the mouse");
}

} // namespace driftbench
