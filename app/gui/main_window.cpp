#include "app/gui/main_window.h"

#include "app/gui/main_window_menus.h"
#include "app/gui/pages/page_list.h"
#include "app/gui/shortcut_overview.h"
#include "app/gui/status_line.h"
#include "app/gui/step_rail.h"
#include "widgets/style/theme.h"

#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>

namespace driftbench {

// What a page needs beside rail, menu bar and status bar in a window of 1280 x 720; in a smaller one it
// scrolls.
static constexpr QSize kLeastPage(1096, 660);
static constexpr QSize kFirstSize(1280, 720);

MainWindow::MainWindow(AppContext &context, QWidget *parent)
    : QMainWindow(parent)
    , m_context(context)
    , m_menus(std::make_unique<Menus>())
    , m_rail(new StepRail(this))
    , m_stack(new QStackedWidget(this))
    , m_scroll(new QScrollArea(this))
    , m_status(new StatusLine(this))
{
    auto *centre = new QWidget(this);
    auto *columns = new QHBoxLayout(centre);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(0);
    columns->addWidget(m_rail);
    m_stack->setMinimumSize(kLeastPage);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setWidget(m_stack);
    columns->addWidget(m_scroll, 1);
    setCentralWidget(centre);
    setStatusBar(m_status);

    buildMenus();
    buildEventLog();
    for (const Step step : kSteps)
        addPage(step, makePage(step, m_context));
    connect(m_rail, &StepRail::stepChosen, this, &MainWindow::showStep);
    connect(&m_context.navigator, &Navigator::stepRequested, this, &MainWindow::showStep);
    connect(&m_context.theme, &Theme::changed, this, [this] { showStatus(); });
    retranslate();
    restoreWindow();
    showStep(Step::Source);
}

MainWindow::~MainWindow() = default;

void MainWindow::addPage(Step step, Page *page)
{
    m_pages[static_cast<std::size_t>(step)] = page;
    m_stack->addWidget(page);
    page->initialise();
    connect(page, &Page::stateChanged, this, [this, step] {
        showStateOf(step);
        if (step == m_step)
            showStatus();
    });
    showStateOf(step);
}

void MainWindow::showStep(Step step)
{
    Page *next = page(step);
    if (m_stack->currentWidget() == next && m_rail->currentIndex().isValid() && m_step == step)
        return;
    Page *before = page(m_step);
    if (before != next)
        before->left();
    m_step = step;
    m_stack->setCurrentWidget(next);
    m_rail->setCurrentStep(step);
    next->entered();
    m_menus->steps[static_cast<std::size_t>(step)]->setChecked(true);
    showStatus();
}

void MainWindow::showStateOf(Step step)
{
    m_rail->steps().setState(step, page(step)->stepState());
}

void MainWindow::showStatus()
{
    const Page &current = *page(m_step);
    m_status->setHints(current.hints());
    std::vector<StatusPart> parts = current.statusParts();
    if (current.origin() != Origin::None)
        parts.push_back({OriginChip::words(current.origin()), Tone::Plain});
    m_status->setParts(parts);
    showSaveAction();
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
    saveWindow();
    QMainWindow::closeEvent(event);
}

void MainWindow::restoreWindow()
{
    const QSettings settings;
    resize(kFirstSize);
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/state")).toByteArray());
}

void MainWindow::saveWindow() const
{
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/state"), saveState());
}

} // namespace driftbench
