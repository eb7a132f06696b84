#include "app/gui/pages/inspect_page.h"

#include "app/gui/inspect/inspect_side.h"
#include "app/gui/workbench.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/loading_state.h"
#include "widgets/controls/panel.h"
#include "widgets/controls/segmented_buttons.h"
#include "widgets/plot/legend_row.h"
#include "widgets/plot/plot_interaction.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/theme.h"
#include "widgets/views/coverage_view.h"
#include "widgets/views/exclusion_strip.h"
#include "widgets/views/tcq_scatter_view.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <qcustomplot.h>

namespace driftbench {

static constexpr int kLowerHeight = 152;
static constexpr int kUpperHeight = 368;
static constexpr int kStripShare = 504; // of the lower row's width, beside the coverage
static constexpr int kCoverageShare = 296;

InspectPage::InspectPage(AppContext &context, QWidget *parent)
    : Page(context, parent)
    , m_scatter(new TcqScatterView(context.theme.palette()))
    , m_time(new TcqTimeView(context.theme.palette()))
    , m_strip(new ExclusionStrip(context.theme.palette()))
    , m_coverage(new CoverageView(context.theme.palette()))
    , m_legend(new LegendRow)
    , m_choice(new SegmentedButtons(tr("What is plotted"), ButtonSize::Head))
    , m_states(new QStackedWidget)
    , m_upper(new QStackedWidget)
    , m_splitter(new QSplitter(Qt::Vertical))
    , m_empty(new EmptyState(stepIcon(Step::Inspect)))
    , m_loading(new LoadingState)
{
    addActions();
    m_side = new InspectSide(m_findings);
    for (PlotView *view : {static_cast<PlotView *>(m_scatter), static_cast<PlotView *>(m_time)}) {
        view->setLegendInside(false);
        view->enableInteraction();
    }
    m_scatter->interaction()->setBoxSelection(true);
    m_time->interaction()->setFreeAxes(Qt::Horizontal);
    setBody(makeBody());
    connectPlots();
    connectWork();
}

void InspectPage::addActions()
{
    m_exclude = addPageAction(Qt::Key_Delete, QStringLiteral("exclude"), [this] { excludeOrInclude(); });
    m_findings = new QAction(this);
    m_goToRecord = new QAction(this);
    connect(m_findings, &QAction::triggered, this, &InspectPage::showFindings);
    connect(m_goToRecord, &QAction::triggered, this, [this] { context().navigator.go(Step::Record); });
    head().addControl(m_choice);
    const SharedActions &shared = context().actions;
    for (QAction *action : {shared.undo, shared.redo}) {
        if (!action)
            continue;
        auto *button = new ActionButton(action, ButtonSize::Head);
        button->setShortcutShown(false);
        head().addControl(button);
    }
    head().addControl(new ActionButton(m_exclude, ButtonSize::Head));
}

QWidget *InspectPage::makePlots()
{
    const auto inPanel = [](QWidget *content) {
        auto *panel = new Panel;
        panel->setFlush();
        panel->rows()->addWidget(content);
        return panel;
    };
    m_upper->addWidget(m_scatter);
    m_upper->addWidget(m_time);
    auto *lower = new QWidget;
    auto *columns = new QHBoxLayout(lower);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(kWideGap);
    columns->addWidget(inPanel(m_strip), kStripShare);
    columns->addWidget(inPanel(m_coverage), kCoverageShare);
    m_splitter->setObjectName(QStringLiteral("inspect"));
    m_splitter->setHandleWidth(kGap);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->addWidget(inPanel(m_upper));
    m_splitter->addWidget(lower);
    m_splitter->setStretchFactor(0, 3);
    m_splitter->setStretchFactor(1, 0);
    m_splitter->setSizes({kUpperHeight, kLowerHeight});
    auto *plots = new QWidget;
    auto *rows = new QVBoxLayout(plots);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(4);
    rows->addWidget(m_legend);
    rows->addWidget(m_splitter, 1);
    return plots;
}

QWidget *InspectPage::makeBody()
{
    auto *plots = new QWidget;
    auto *columns = new QHBoxLayout(plots);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(kWideGap);
    columns->addWidget(makePlots(), 1);
    columns->addWidget(m_side);
    const auto inPanel = [](QWidget *content) {
        auto *panel = new Panel;
        panel->rows()->addWidget(content);
        return panel;
    };
    m_states->addWidget(inPanel(m_empty));
    m_states->addWidget(inPanel(m_loading));
    m_states->addWidget(plots);
    return m_states;
}

void InspectPage::connectPlots()
{
    connect(m_choice, &SegmentedButtons::currentChanged, this, [this](int at) {
        m_overTime = at == 1;
        m_upper->setCurrentIndex(at);
        showLegend();
    });
    connect(&m_side->axes(), &AxisList::axisChosen, this, &InspectPage::setAxis);
    connect(
        m_scatter->interaction(), &PlotInteraction::boxSelected, this,
        [this](QCPAxisRect *panel, const QRectF &box) {
            const auto [quantity, row] = m_scatter->placeOf(panel);
            const bool residuals = row == 1 && m_seen && m_seen->curve;
            if (!m_seen)
                return;
            select(selectionWhere(*m_seen, [&, q = quantity](double deltaT, const Eigen::Vector3d &tdeDps) {
                const double key = temperatureQuantities(deltaT)[q];
                const double value =
                    tdeDps[m_axis] - (residuals ? interpolated(*m_seen->curve, m_axis, deltaT) : 0.0);
                return key >= box.left() && key <= box.right() && value >= box.top() && value <= box.bottom();
            }));
        });
    connect(m_scatter->interaction(), &PlotInteraction::clicked, this, [this] { select({}); });
    connect(m_strip, &ExclusionStrip::selected, this, [this](double startS, double endS) {
        if (m_seen)
            m_dragged = selectionOfStrip(*m_seen, startS, endS);
    });
    // Not while dragging: the strip is built anew with the marked dots.
    connect(m_strip, &ExclusionStrip::selectionEnded, this, [this] { select(m_dragged); });
    connect(m_strip, &ExclusionStrip::rangeMoved, this, &InspectPage::moveExclusion);
    connect(m_strip, &ExclusionStrip::rangePicked, this, [this](std::size_t range) { pick(range); });
    connect(m_strip, &ExclusionStrip::pickedNothing, this, [this] {
        pick(std::nullopt);
        select({});
    });
    connect(m_coverage, &CoverageView::selected, this, [this](double lowestC, double highestC) {
        if (!m_seen)
            return;
        const double reference = m_seen->referenceTemperatureC;
        select(selectionWhere(*m_seen, [=](double deltaT, const Eigen::Vector3d &) {
            return deltaT + reference >= lowestC && deltaT + reference <= highestC;
        }));
    });
    connect(m_side->table().selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex &row) {
                for (std::size_t i = 0; i < m_rangeRows.size(); ++i) {
                    if (m_rangeRows[i] == static_cast<std::size_t>(row.row()) &&
                        m_strip->shown().ranges[i].own)
                        return pick(i);
                }
                pick(std::nullopt);
            });
    connect(&m_side->excluded(), &ExcludedModel::reasonWritten, this,
            [this](std::size_t run, std::size_t own, const QString &why) {
                CalibrationPlan plan = context().workbench->session().plan();
                RunInPlan *in = plan.find(m_seen->runs[run].id);
                if (!in || own >= in->excluded.size())
                    return;
                in->excluded[own].note = why.toStdString();
                edit(plan, tr("name the reason"));
            });
}

void InspectPage::connectWork()
{
    Workbench &workbench = *context().workbench;
    for (const auto change :
         {&Workbench::runsChanged, &Workbench::planChanged, &Workbench::sessionReplaced}) {
        connect(&workbench, change, this, [this] {
            m_failed = false;
            refresh();
        });
    }
    connect(&workbench, &Workbench::resultChanged, this, &InspectPage::refresh);
    connect(&workbench, &Workbench::preparedChanged, this, &InspectPage::refresh);
    connect(&workbench.training(), &TrainingJob::failed, this, &InspectPage::sayFailure);
    connect(&workbench, &Workbench::planChanged, this, &InspectPage::showButtons);
    // Queued: the outcome comes right after it.
    connect(
        &workbench.training(), &Job::runningChanged, this,
        [this](bool running) {
            if (!running)
                refresh();
        },
        Qt::QueuedConnection);
    connect(&workbench.training(), &Job::progress, this,
            [this](const QString &stage, double fraction) { m_loading->setProgress(stage, fraction); });
    connect(m_loading, &LoadingState::cancelled, this, [this] {
        m_job.cancel();
        context().workbench->training().cancel();
    });
    connect(&m_job, &InspectionJob::finished, this, &InspectPage::take);
}

void InspectPage::retranslate()
{
    head().setTitle(stepName(Step::Inspect));
    m_choice->setAccessibleName(tr("What is plotted"));
    m_choice->setTexts({tr("Against TCQ"), tr("Over time")});
    m_choice->setCurrent(m_overTime ? 1 : 0);
    m_findings->setText(tr("Findings"));
    m_goToRecord->setText(stepName(Step::Record));
    showEmptyTexts();
    std::vector<QAction *> actions{m_goToRecord};
    if (context().actions.openFiles)
        actions.push_back(context().actions.openFiles);
    m_empty->setActions(actions);
    m_side->retranslate();
    showAll();
}

void InspectPage::keyPressEvent(QKeyEvent *event)
{
    if (event->modifiers() == Qt::NoModifier) {
        for (const auto &[key, axis] :
             {std::pair(Qt::Key_X, 0), std::pair(Qt::Key_Y, 1), std::pair(Qt::Key_Z, 2)}) {
            if (event->key() == key)
                return setAxis(axis);
        }
        if (event->key() == Qt::Key_Escape && !m_selection.empty())
            return select({});
    }
    for (PlotView *view : {static_cast<PlotView *>(m_scatter), static_cast<PlotView *>(m_time),
                           static_cast<PlotView *>(m_strip), static_cast<PlotView *>(m_coverage)}) {
        if (view->isVisible() && view->interaction()->isUnderMouse() && view->interaction()->handleKey(event))
            return;
    }
    Page::keyPressEvent(event);
}

void InspectPage::changeEvent(QEvent *event)
{
    Page::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showLegend(); // the views have changed before their page
}

} // namespace driftbench
