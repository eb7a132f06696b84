#include "widgets/plot/plot_view.h"

#include "widgets/plot/empty_element.h"
#include "widgets/plot/legend_element.h"
#include "widgets/plot/plot_interaction.h"
#include "widgets/plot/plot_style.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kRowSpacing = 8;
static constexpr int kColumnSpacing = 8;
static constexpr int kSideMargin = 12;
static constexpr int kPlotMargin = 6;
static constexpr double kFirstColumnStretch = 1.13; // room for the numbers left of the first column

PlotView::PlotView(std::function<QString()> name, const Palette &look, QWidget *parent)
    : QWidget(parent), m_name(std::move(name)), m_look(look), m_plot(new QCustomPlot(this))
{
    showName();
    connect(m_plot, &QCustomPlot::afterLayout, this, [this] { m_tickRoom.fit(*m_plot); });
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
}

PlotView::~PlotView() = default;

void PlotView::showName()
{
    setAccessibleName(m_name());
    m_plot->setAccessibleName(m_name());
}

void PlotView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_followsTheme)
        followTheme();
    if (event->type() != QEvent::LanguageChange)
        return;
    showName();
    rebuild();
}

void PlotView::setLook(const Palette &look)
{
    m_look = look;
    if (m_interaction)
        m_interaction->setLook(look);
    rebuild();
}

void PlotView::followTheme()
{
    m_followsTheme = true;
    if (lookOf(palette()).dark != m_look.dark)
        setLook(lookOf(palette()));
}

PlotInteraction &PlotView::enableInteraction()
{
    if (!m_interaction) {
        m_interaction = new PlotInteraction(m_plot, m_look);
        m_interaction->rememberHome();
        followTheme();
    }
    return *m_interaction;
}

void PlotView::setLegendInside(bool inside)
{
    m_legendInside = inside;
    rebuild();
}

void PlotView::setOrigin(const QString &origin)
{
    m_origin = origin;
    rebuild();
}

void PlotView::clearPlot()
{
    m_plot->clearPlottables();
    m_plot->clearItems();
    m_plot->plotLayout()->clear();
    m_plot->plotLayout()->simplify();
    for (QCPMarginGroup *group : m_marginGroups)
        delete group;
    m_marginGroups.clear();
}

void PlotView::rebuild()
{
    const bool moved = m_interaction && m_interaction->isMoved();
    const auto before = moved ? m_interaction->view() : PlotInteraction::View{};
    clearPlot();
    m_tickRoom.forget();
    m_legend.clear();
    applyPlotStyle(*m_plot, m_look);
    m_plot->plotLayout()->setMargins(QMargins(kSideMargin, kPlotMargin, kSideMargin, kPlotMargin));
    m_plot->plotLayout()->setRowSpacing(kRowSpacing);
    m_empty = false;
    build();
    if (m_interaction) {
        m_interaction->rememberHome();
        if (moved)
            m_interaction->putBack(before);
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
    emit rebuilt();
}

void PlotView::showEmpty(const QString &headline, const QString &sentence)
{
    m_empty = true;
    QCPLayoutGrid *rows = m_plot->plotLayout();
    rows->addElement(rows->rowCount(), 0, new EmptyElement(m_plot, headline, sentence, m_look));
}

void PlotView::addLegend(std::vector<LegendEntry> entries)
{
    QCPLayoutGrid *rows = m_plot->plotLayout();
    if (m_legendInside && rows->elementCount() == 0 && !m_origin.isEmpty())
        entries.push_back({LegendEntry::Kind::Heading, m_origin, QPen(Qt::NoPen), {}});
    m_legend.insert(m_legend.end(), entries.begin(), entries.end());
    if (m_legendInside)
        rows->addElement(rows->rowCount(), 0, new LegendElement(m_plot, std::move(entries), m_look));
}

QCPLayoutGrid &PlotView::addPanels(bool sharedValues)
{
    m_sharedValues = sharedValues;
    QCPLayoutGrid *rows = m_plot->plotLayout();
    auto *grid = new QCPLayoutGrid;
    rows->addElement(rows->rowCount(), 0, grid);
    grid->setRowSpacing(kRowSpacing);
    grid->setColumnSpacing(kColumnSpacing);
    m_marginGroups.push_back(new QCPMarginGroup(m_plot));
    return *grid;
}

QCPAxisRect &PlotView::addPanel(QCPLayoutGrid &grid, int row, int column)
{
    auto *rect = new QCPAxisRect(m_plot);
    grid.addElement(row, column, rect);
    applyPlotStyle(*rect, m_look);
    if (!m_sharedValues || column == 0)
        rect->setMarginGroup(QCP::msLeft, m_marginGroups.back());
    if (m_sharedValues && column == 0)
        grid.setColumnStretchFactor(0, kFirstColumnStretch);
    rect->setMarginGroup(QCP::msRight, m_marginGroups.back());
    return *rect;
}

} // namespace driftbench
