// How the view of a plot moves: pure arithmetic on axes, the same for linear and logarithmic ones.
#pragma once

#include <QPointF>

class QCPAxis;
class QCPAxisRect;
class QCPRange;
class QCustomPlot;

namespace driftbench {

// The panel whose area or axes lie at this place of the plot; null if there is none.
QCPAxisRect *panelAt(const QCustomPlot &plot, const QPointF &place);

// What lies at a place: the inside of a panel, its axis of keys (below), its axis of values (left), or its
// other margins.
enum class PanelPart
{
    Inside,
    KeyAxis,
    ValueAxis,
    Margin
};
PanelPart panelPartAt(const QCPAxisRect &panel, const QPointF &place);

// factor < 1 zooms in. The value at the pixel `at` stays where it is. Where `home` has a size, the span stays
// between a millionth and a hundred times of it.
void zoomAxis(QCPAxis &axis, double factor, double at, const QCPRange &home);

// By pixels, as dragged: the values go with the mouse.
void panAxis(QCPAxis &axis, double fromPixel, double toPixel);

// Between two pixels, in any order. Less than two pixels apart: nothing happens.
bool zoomAxisTo(QCPAxis &axis, double pixelA, double pixelB);

// Axes that show the same thing move together from now on.
void linkAxes(const QList<QCPAxis *> &axes);

} // namespace driftbench
