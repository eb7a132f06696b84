#include "widgets/plot/axis_moves.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr double kSmallestShare = 1e-6; // of the home span
static constexpr double kLargestShare = 100.0;
static constexpr double kSmallestBox = 2.0; // px

QCPAxisRect *panelAt(const QCustomPlot &plot, const QPointF &place)
{
    for (QCPAxisRect *panel : plot.axisRects()) {
        if (panel->visible() && panel->outerRect().contains(place.toPoint()))
            return panel;
    }
    return nullptr;
}

PanelPart panelPartAt(const QCPAxisRect &panel, const QPointF &place)
{
    const QRect inside = panel.rect();
    if (inside.contains(place.toPoint()))
        return PanelPart::Inside;
    const bool besideKeys = place.x() >= inside.left() && place.x() <= inside.right();
    const bool besideValues = place.y() >= inside.top() && place.y() <= inside.bottom();
    if (besideKeys && place.y() > inside.bottom())
        return PanelPart::KeyAxis;
    if (besideValues && place.x() < inside.left())
        return PanelPart::ValueAxis;
    return PanelPart::Margin;
}

static bool isLogarithmic(const QCPAxis &axis)
{
    return axis.scaleType() == QCPAxis::stLogarithmic;
}

static double spanOf(const QCPAxis &axis, const QCPRange &range)
{
    return isLogarithmic(axis) ? std::log(range.upper / range.lower) : range.size();
}

void zoomAxis(QCPAxis &axis, double factor, double at, const QCPRange &home)
{
    const double homeSpan = home.size() > 0.0 ? spanOf(axis, home) : 0.0;
    if (homeSpan > 0.0) {
        const double span = spanOf(axis, axis.range());
        factor = std::clamp(factor, kSmallestShare * homeSpan / span, kLargestShare * homeSpan / span);
    }
    axis.scaleRange(factor, axis.pixelToCoord(at));
}

void panAxis(QCPAxis &axis, double fromPixel, double toPixel)
{
    const double from = axis.pixelToCoord(fromPixel);
    const double to = axis.pixelToCoord(toPixel);
    axis.moveRange(isLogarithmic(axis) ? from / to : from - to);
}

bool zoomAxisTo(QCPAxis &axis, double pixelA, double pixelB)
{
    if (std::abs(pixelA - pixelB) < kSmallestBox)
        return false;
    const double a = axis.pixelToCoord(pixelA);
    const double b = axis.pixelToCoord(pixelB);
    axis.setRange(std::min(a, b), std::max(a, b));
    return true;
}

void linkAxes(const QList<QCPAxis *> &axes)
{
    for (QCPAxis *from : axes) {
        for (QCPAxis *to : axes) {
            if (from != to)
                QObject::connect(from, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), to,
                                 qOverload<const QCPRange &>(&QCPAxis::setRange));
        }
    }
}

} // namespace driftbench
