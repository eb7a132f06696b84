#include "app/gui/main_window.h"

#include "app/gui/main_window_menus.h"
#include "app/gui/pages/page_list.h"
#include "app/gui/pages/source_page.h"
#include "app/gui/source_status.h"
#include "app/gui/start/coach_strip.h"
#include "app/gui/start/guided_tour.h"
#include "app/gui/start/simulated_tour.h"
#include "app/gui/start/start_page.h"
#include "app/gui/status_line.h"
#include "app/gui/step_rail.h"
#include "app/gui/workbench.h"
#include "widgets/style/theme.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QScrollArea>
#include <QStackedWidget>
#include <QUndoStack>

namespace driftbench {

// What is left for a page in a window of 1280 x 720 beside rail, menu bar, status bar, scroll bar and the
// tour's strip; in a smaller one it scrolls.
static constexpr QSize kLeastPage(1096 - 14, 624);
static constexpr int kUsualHeight = 670; // without that strip

MainWindow::MainWindow(AppContext &context, Language &language, QWidget *parent)
    : QMainWindow(parent)
    , m_context(context)
    , m_bench(*context.workbench)
    , m_language(language)
    , m_menus(std::make_unique<Menus>())
    , m_rail(new StepRail(this))
    , m_stack(new QStackedWidget(this))
    , m_scroll(new QScrollArea(this))
    , m_status(new StatusLine(this))
    , m_sourceStatus(new SourceStatus(m_bench, this))
    , m_corner(new TextLabel(TextRole::Note, this))
{
    setAcceptDrops(true);
    buildCentre();
    buildMenus();
    buildEventLog();
    buildPages();
    buildStart();
    connectBench();
    logEvents();
    retranslate();
    showSession();
    restoreWindow();
    qApp->installEventFilter(this);
    page(m_step)->entered();
    m_rail->setCurrentStep(m_step);
    m_menus->steps[static_cast<std::size_t>(m_step)]->setChecked(true);
    showStatus();
}

// What pages and session say while they go has nobody to hear it any more.
MainWindow::~MainWindow()
{
    for (Page *page : m_pages) {
        page->disconnect(this);
        if (QUndoStack *undo = page->undoStack())
            undo->disconnect(this);
    }
    m_bench.disconnect(this);
    m_sourceStatus->disconnect(this);
    m_tour->disconnect();
}

namespace {

// Holds the pages at what size there is, and the one that is shown at no less than it needs: a layout would
// ask each of them for its height at that width, and the scroll area would follow the tallest.
class PageFrame : public QWidget
{
public:
    explicit PageFrame(QStackedWidget *pages) : m_pages(pages)
    {
        pages->setParent(this);
        connect(pages, &QStackedWidget::currentChanged, this, [this] { updateGeometry(); });
    }

    QSize minimumSizeHint() const override
    {
        const QWidget *page = m_pages->currentWidget();
        const int needed = page ? page->minimumSizeHint().height() : 0;
        return {kLeastPage.width(), std::clamp(needed, kLeastPage.height(), kUsualHeight)};
    }

protected:
    void resizeEvent(QResizeEvent *) override { m_pages->setGeometry(rect()); }

    bool event(QEvent *event) override
    {
        if (event->type() == QEvent::LayoutRequest)
            updateGeometry();
        return QWidget::event(event);
    }

private:
    QStackedWidget *m_pages;
};

} // namespace

void MainWindow::buildCentre()
{
    auto *centre = new QWidget(this);
    auto *columns = new QHBoxLayout(centre);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(0);
    columns->addWidget(m_rail);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setWidget(new PageFrame(m_stack));
    m_places = new QVBoxLayout;
    m_places->setSpacing(0);
    m_places->addWidget(m_scroll, 1);
    columns->addLayout(m_places, 1);
    setCentralWidget(centre);
    setStatusBar(m_status);
    m_corner->setContentsMargins(0, 0, 16, 1);
    menuBar()->setCornerWidget(m_corner, Qt::TopRightCorner);
    m_corner->setFixedHeight(24);
    m_corner->setRole(TextRole::Note);
}

void MainWindow::buildPages()
{
    for (const Step step : kSteps) {
        Page *page = makePage(step, m_context);
        m_pages[static_cast<std::size_t>(step)] = page;
        m_stack->addWidget(page);
        page->initialise();
        connect(page, &Page::stateChanged, this, [this, step] {
            showStateOf(step);
            if (step == m_step)
                showStatus();
        });
        if (QUndoStack *undo = page->undoStack()) {
            connect(undo, &QUndoStack::indexChanged, this, &MainWindow::showUndo);
            connect(undo, &QUndoStack::cleanChanged, this, &MainWindow::showUndo);
        }
    }
    m_stack->setCurrentWidget(page(m_step));
}

void MainWindow::buildStart()
{
    m_start = new StartPage;
    m_stack->addWidget(m_start);
    m_tour = new GuidedTour(simulatedTour(*this, m_bench), this);
    m_coach = new CoachStrip(*m_tour);
    m_places->addWidget(m_coach);
    failWithTheWork(*m_tour, m_bench);
    for (QAction *action : m_coach->tourActions()) {
        addAction(action);
        m_menus->everywhere.push_back(action);
    }
    connect(m_start, &StartPage::tourChosen, this, &MainWindow::startTour);
    connect(m_start, &StartPage::bridgeChosen, this, [this] { showStep(Step::Source); });
    connect(m_start, &StartPage::filesChosen, this, &MainWindow::askOpen);
    connect(m_tour, &GuidedTour::pageWanted, this, &MainWindow::showStep);
}

bool MainWindow::isAtStart() const
{
    return m_stack->currentWidget() == m_start;
}

void MainWindow::showStart()
{
    if (isAtStart())
        return;
    page(m_step)->left();
    m_stack->setCurrentWidget(m_start);
    m_rail->clearCurrentStep();
    m_start->setFocus();
    showStatus();
}

void MainWindow::startTour()
{
    if (m_bench.acquisition().isRecording())
        return tell(Error{Errc::SessionInUse, "A run is being recorded; stop it before the tour."});
    const Session &session = m_bench.session();
    const bool fresh =
        session.isUnnamed() && session.runs().empty() && !session.testPlan() && !session.source();
    if (!fresh) {
        if (const Status made = m_bench.newSession(); !made)
            return tell(made);
    }
    m_tour->start();
}

void MainWindow::connectBench()
{
    connect(m_rail, &StepRail::stepChosen, this, &MainWindow::showStep);
    connect(&m_context.navigator, &Navigator::stepRequested, this, &MainWindow::showStep);
    connect(m_sourceStatus, &SourceStatus::changed, this, &MainWindow::showStatus);
    connect(&m_bench, &Workbench::planChanged, this, &MainWindow::showUndo);
    for (const auto signal : {&Workbench::nameChanged, &Workbench::savedChanged, &Workbench::runsChanged,
                              &Workbench::testPlanChanged, &Workbench::sessionReplaced})
        connect(&m_bench, signal, this, &MainWindow::showSession);
    // A stage that is set empties the later ones: the rail shows all of it at once.
    for (const auto signal :
         {&Workbench::sessionReplaced, &Workbench::sourceChanged, &Workbench::testPlanChanged,
          &Workbench::runsChanged, &Workbench::planChanged, &Workbench::preparedChanged,
          &Workbench::resultChanged, &Workbench::uploadsChanged, &Workbench::exportsChanged})
        connect(&m_bench, signal, this, [this] {
            for (const Step step : kSteps)
                showStateOf(step);
        });
}

SourcePage &MainWindow::sourcePage() const
{
    return static_cast<SourcePage &>(*page(Step::Source));
}

void MainWindow::showStep(Step step)
{
    if (m_step == step && !isAtStart())
        return;
    if (!isAtStart())
        page(m_step)->left();
    m_step = step;
    Page *next = page(step);
    m_stack->setCurrentWidget(next);
    m_scroll->ensureVisible(0, 0);
    m_rail->setCurrentStep(step);
    next->entered();
    m_menus->steps[static_cast<std::size_t>(step)]->setChecked(true);
    showSessionMenu();
    showUndo();
    showStatus();
}

void MainWindow::bringIntoView(QWidget &part)
{
    m_scroll->ensureWidgetVisible(&part, 0, 0);
}

void MainWindow::showStateOf(Step step)
{
    m_rail->steps().setState(step, page(step)->stepState());
}

void MainWindow::showStatus()
{
    const Page &current = *page(m_step);
    m_status->setHints(isAtStart() ? tr("Tab next · Enter choose · Ctrl+O open files · Alt+1 to 7 steps")
                                   : current.hints());
    std::vector<StatusPart> parts = m_sourceStatus->parts();
    for (const StatusPart &part : current.statusParts())
        parts.push_back(part);
    if (const StatusPart room = m_sourceStatus->room(); !room.text.isEmpty())
        parts.push_back(room);
    Origin origin = current.origin();
    if (origin == Origin::None && m_bench.isSourceSimulated())
        origin = Origin::Simulated;
    if (origin != Origin::None)
        parts.push_back({OriginChip::words(origin), Tone::Plain});
    m_status->setParts(parts);
    showSaveAction();
}

void MainWindow::openFiles(const std::vector<std::filesystem::path> &files)
{
    showStep(Step::Source);
    sourcePage().openFiles(files);
}

void MainWindow::paintEvent(QPaintEvent *event)
{
    QMainWindow::paintEvent(event);
    if (const auto call = std::exchange(m_onFirstPaint, nullptr))
        call();
}

void MainWindow::changeEvent(QEvent *event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!mayClose())
        return event->ignore();
    saveWindow();
    QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event)
{
    for (const QUrl &url : event->mimeData()->urls()) {
        if (url.isLocalFile())
            return event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent *event)
{
    std::vector<std::filesystem::path> files;
    for (const QUrl &url : event->mimeData()->urls()) {
        if (url.isLocalFile())
            files.emplace_back(url.toLocalFile().toStdString());
    }
    event->acceptProposedAction();
    openFiles(files);
}

// A control that has the focus keeps Space and Enter for itself, though a page may have an action on them.
bool MainWindow::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool own = key->key() == Qt::Key_Space &&
                         (qobject_cast<QAbstractButton *>(watched) || qobject_cast<QComboBox *>(watched));
        if (own && key->modifiers() == Qt::NoModifier) {
            event->accept();
            return true;
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

} // namespace driftbench
