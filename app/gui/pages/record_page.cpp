#include "app/gui/pages/record_page.h"

#include "app/gui/record/live_run.h"
#include "app/gui/record/record_readouts.h"
#include "app/gui/workbench.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/panel.h"
#include "widgets/controls/segmented_buttons.h"
#include "widgets/live/live_trace_view.h"
#include "widgets/plot/legend_row.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/number_text.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kFiguresMs = 250;

RecordPage::RecordPage(AppContext &context, QWidget *parent)
    : Page(context, parent)
    , m_view(new LiveTraceView(context.theme.palette()))
    , m_run(new LiveRun(*context.workbench, *m_view, this))
    , m_readouts(new RecordReadouts(*m_run, *m_view))
    , m_legend(new LegendRow)
    , m_span(new SegmentedButtons(tr("Span of the traces"), ButtonSize::Small))
    , m_quantity(new SegmentedButtons(tr("Quantity of the traces"), ButtonSize::Small))
    , m_panelStack(new QStackedWidget)
    , m_empty(new EmptyState(stepIcon(Step::Record)))
{
    addActions();
    setBody(makeBody());
    connectWork();
    m_figures.setInterval(kFiguresMs);
    connect(&m_figures, &QTimer::timeout, this, &RecordPage::showFigures);
    m_figures.start();
}

void RecordPage::addActions()
{
    m_pause = addPageAction({}, QStringLiteral("pause"), [this] { setViewPaused(!m_view->isPaused()); });
    m_stop = addPageAction(Qt::CTRL | Qt::Key_Period, QStringLiteral("stop"), [this] { stopRecording(); });
    m_start = addPageAction(Qt::CTRL | Qt::SHIFT | Qt::Key_R, QStringLiteral("record"),
                            [this] { startRecording(); });
    m_goToSource = new QAction(this);
    m_goToInspect = new QAction(this);
    m_writeAgain = new QAction(this);
    m_saveRest = new QAction(this);
    connect(m_goToSource, &QAction::triggered, this, [this] { context().navigator.go(Step::Source); });
    connect(m_goToInspect, &QAction::triggered, this, [this] { context().navigator.go(Step::Inspect); });
    connect(m_writeAgain, &QAction::triggered, this, [this] {
        banners().withdraw(QStringLiteral("recorder"));
        context().workbench->acquisition().finishAgain();
    });
    connect(m_saveRest, &QAction::triggered, this, &RecordPage::saveUnwritten);
    connect(&m_savingRest, &TaskJob::finished, this, &RecordPage::restWritten);
    setPrimaryAction(m_start);

    m_pauseButton = new ActionButton(m_pause, ButtonSize::Head);
    m_stopButton = new ActionButton(m_stop, ButtonSize::Head);
    m_stopButton->setShortcutShown(false);
    m_startButton = new ActionButton(m_start, ButtonSize::Head);
    m_startButton->setPrimary(true);
    m_startButton->setShortcutShown(false);
    for (ActionButton *button : {m_pauseButton, m_stopButton, m_startButton})
        head().addControl(button);
}

QWidget *RecordPage::makeTraces()
{
    auto *left = new QWidget;
    auto *rows = new QVBoxLayout(left);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(5);
    auto *choices = new QHBoxLayout;
    choices->setSpacing(kLabelGap);
    choices->addWidget(m_legend, 1);
    choices->addWidget(m_span);
    choices->addWidget(m_quantity);
    rows->addLayout(choices);
    auto *panel = new Panel;
    panel->setFlush();
    panel->rows()->addWidget(m_panelStack);
    m_panelStack->addWidget(m_empty);
    m_panelStack->addWidget(m_view);
    rows->addWidget(panel, 1);
    return left;
}

QWidget *RecordPage::makeBody()
{
    auto *body = new QWidget;
    auto *columns = new QHBoxLayout(body);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(kWideGap);
    columns->addWidget(makeTraces(), 1);
    columns->addWidget(m_readouts);
    return body;
}

void RecordPage::connectWork()
{
    Workbench &workbench = *context().workbench;
    const Acquisition &acquisition = workbench.acquisition();
    connect(m_span, &SegmentedButtons::currentChanged, this,
            [this](int at) { m_view->setSpan(static_cast<LiveSpan>(at)); });
    connect(m_quantity, &SegmentedButtons::currentChanged, this,
            [this](int at) { m_view->setQuantity(static_cast<LiveQuantity>(at)); });
    connect(m_view, &LiveTraceView::legendChanged, this, &RecordPage::showLegend);
    connect(m_view, &LiveTraceView::cursorsChanged, m_readouts, &RecordReadouts::showCursors);
    connect(&m_view->interaction(), &PlotInteraction::exportFailed, this, [this](const QString &sentence) {
        say(QStringLiteral("export"), BannerKind::Bad, sentence, {});
    });
    connect(m_run, &LiveRun::recordingChanged, this, &RecordPage::showState);
    connect(m_run, &LiveRun::scored, m_readouts, &RecordReadouts::addTrendPoint);
    connect(m_run, &LiveRun::deviceAway, this, &RecordPage::showAbsence);
    connect(m_run, &LiveRun::deviceBack, this, [this] { banners().withdraw(QStringLiteral("absence")); });
    connect(m_run, &LiveRun::planEnded, this, &RecordPage::endRun);
    connect(&acquisition, &Acquisition::started, this, &RecordPage::sourceStarted);
    connect(&acquisition, &Acquisition::finished, this, [this, &acquisition](const auto &outcome) {
        // By now the next one may be being opened.
        if (!outcome.ok() && acquisition.state() == Acquisition::State::Idle)
            sourceEnded(outcome.error());
        showState();
    });
    connect(&acquisition, &Acquisition::stateChanged, this, &RecordPage::showState);
    connect(&acquisition, &Acquisition::recorderEvent, this, &RecordPage::recorderSays);
    connect(&acquisition, &Acquisition::recordingFinished, this,
            [this](RunId, const Status &outcome) { recordingFinished(outcome); });
    connect(&workbench, &Workbench::runsChanged, this, &RecordPage::showState);
    connect(&workbench, &Workbench::testPlanChanged, this, &RecordPage::showState);
    connect(&workbench, &Workbench::resultChanged, this, &RecordPage::showState);
    connect(&workbench, &Workbench::sourceChanged, this, &RecordPage::showState);
    connect(&workbench, &Workbench::sessionReplaced, this, &RecordPage::showState);
}

void RecordPage::entered()
{
    showState();
    m_readouts->showAll();
}

void RecordPage::retranslate()
{
    head().setTitle(stepName(Step::Record));
    m_pause->setProperty("shownShortcut", QKeySequence(Qt::Key_Space).toString(QKeySequence::NativeText));
    m_start->setText(tr("Start recording"));
    m_stop->setText(tr("Stop recording"));
    m_goToSource->setText(tr("Choose a source"));
    m_goToInspect->setText(tr("Inspect"));
    m_writeAgain->setText(tr("Write again"));
    m_saveRest->setText(tr("Save it elsewhere…"));
    m_span->setAccessibleName(tr("Span of the traces"));
    m_quantity->setAccessibleName(tr("Quantity of the traces"));
    m_span->setTexts({tr("Run"), tr("10 min"), tr("1 min")});
    m_quantity->setTexts({tr("Rate"), tr("TDE")});
    m_span->setCurrent(static_cast<int>(m_view->span()));
    m_quantity->setCurrent(static_cast<int>(m_view->quantity()));
    m_view->retranslate();
    m_readouts->retranslate();
    showState();
}

void RecordPage::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Space && event->modifiers() == Qt::NoModifier && m_pause->isEnabled())
        return m_pause->trigger();
    // The keys of the traces work while the mouse is over them, whatever has the focus.
    if (m_view->isVisible() && m_view->interaction().isUnderMouse() && m_view->interaction().handleKey(event))
        return;
    Page::keyPressEvent(event);
}

void RecordPage::changeEvent(QEvent *event)
{
    Page::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        m_view->setLook(lookOf(palette()));
}

void RecordPage::showLegend()
{
    const bool traces = m_run->isRecording() || m_run->hasSamples();
    m_legend->setEntries(traces ? m_view->legend() : std::vector<LegendEntry>{}, lookOf(palette()));
}

void RecordPage::say(const QString &key, BannerKind kind, Words what, Words toDo,
                     std::vector<QAction *> actions, bool closable)
{
    banners().post(key, bannerOf(kind, std::move(what), std::move(toDo), std::move(actions), closable));
}

} // namespace driftbench
