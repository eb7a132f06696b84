#include "widgets/plot/tick_room.h"

#include <qcustomplot.h>

#include <cmath>

namespace driftbench {

static constexpr int kBetweenLabels = 8; // px, left to right

static bool labelsFit(const QCPAxis &axis)
{
    const QFontMetrics metrics(axis.tickLabelFont());
    const bool across = axis.orientation() == Qt::Horizontal;
    const QVector<double> ticks = axis.tickVector();
    const QVector<QString> labels = axis.tickVectorLabels();
    for (qsizetype i = 1; i < std::min(ticks.size(), labels.size()); ++i) {
        const int both = metrics.horizontalAdvance(labels[i - 1]) + metrics.horizontalAdvance(labels[i]);
        const double needed = across ? 0.5 * both + kBetweenLabels : metrics.height();
        if (std::abs(axis.coordToPixel(ticks[i]) - axis.coordToPixel(ticks[i - 1])) < needed)
            return false;
    }
    return true;
}

// Whether the step is another one than before.
bool TickRoom::fitAxis(QCPAxisRect &rect, QCPAxis &axis)
{
    const auto ticker = axis.ticker();
    if (!axis.visible() || !axis.tickLabels() || axis.scaleType() != QCPAxis::stLinear ||
        ticker.dynamicCast<QCPAxisTickerText>())
        return false;
    const int before = ticker->tickCount();
    const int wanted = m_wanted.try_emplace(&axis, before).first->second;
    int ticks = wanted;
    if (ticks == before && labelsFit(axis))
        return false;
    for (; ticks > 0; --ticks) {
        ticker->setTickCount(ticks);
        rect.update(QCPLayoutElement::upPreparation);
        if (labelsFit(axis))
            break;
    }
    return ticker->tickCount() != before;
}

void TickRoom::fit(QCustomPlot &plot)
{
    bool changed = false;
    for (QCPAxisRect *rect : plot.axisRects()) {
        for (QCPAxis *axis : rect->axes())
            changed |= fitAxis(*rect, *axis);
    }
    if (!changed)
        return;
    for (const auto phase :
         {QCPLayoutElement::upPreparation, QCPLayoutElement::upMargins, QCPLayoutElement::upLayout})
        plot.plotLayout()->update(phase);
}

} // namespace driftbench
