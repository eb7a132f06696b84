#include "widgets/plot/legend_element.h"

namespace driftbench {

static constexpr int kSideMargin = 16; // of the plot's layout, both sides

LegendElement::LegendElement(QCustomPlot *plot, std::vector<LegendEntry> entries, const Palette &palette)
    : QCPLayoutElement(plot), m_legend(std::move(entries), palette)
{
}

QSize LegendElement::minimumOuterSizeHint() const
{
    return {0, m_legend.heightFor(mParentPlot->viewport().width() - 2 * kSideMargin)};
}

QSize LegendElement::maximumOuterSizeHint() const
{
    return {QWIDGETSIZE_MAX, minimumOuterSizeHint().height()};
}

void LegendElement::applyDefaultAntialiasingHint(QCPPainter *painter) const
{
    painter->setAntialiasing(true);
}

void LegendElement::draw(QCPPainter *painter)
{
    m_legend.paint(*painter, mOuterRect);
}

} // namespace driftbench
