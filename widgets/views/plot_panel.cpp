#include "widgets/views/plot_panel.h"

#include "widgets/controls/panel.h"
#include "widgets/plot/legend_row.h"
#include "widgets/plot/plot_interaction.h"
#include "widgets/plot/plot_view.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kLegendHeight = 24;

PlotPanel::PlotPanel(PlotView *view, QWidget *parent)
    : QWidget(parent), m_view(view), m_legend(new LegendRow), m_head(new QHBoxLayout)
{
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(1);
    m_head->setContentsMargins(0, 0, 0, 0);
    m_head->setSpacing(16);
    m_head->addWidget(m_legend, 1);
    rows->addLayout(m_head);
    auto *panel = new Panel;
    panel->setFlush();
    panel->rows()->addWidget(view);
    rows->addWidget(panel, 1);
    m_legend->setMinimumHeight(kLegendHeight);
    m_legend->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    view->setLegendInside(false);
    view->enableInteraction();
    view->setMinimumHeight(96);
    view->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(view, &PlotView::rebuilt, this, &PlotPanel::showLegend);
}

void PlotPanel::addBeforeLegend(QWidget *control)
{
    m_head->insertWidget(m_head->indexOf(m_legend), control);
}

void PlotPanel::addAfterLegend(QWidget *control)
{
    m_head->addWidget(control);
}

void PlotPanel::showLegend()
{
    m_legend->setEntries(m_view->legend(), m_view->look());
}

} // namespace driftbench
