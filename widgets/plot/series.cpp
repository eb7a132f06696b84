#include "widgets/plot/series.h"

#include <cmath>

namespace driftbench {

namespace {

class DotGraph : public QCPGraph
{
public:
    DotGraph(QCPAxis *keyAxis, QCPAxis *valueAxis, const QColor &color, double diameter)
        : QCPGraph(keyAxis, valueAxis), m_pen(color, diameter, Qt::SolidLine, Qt::RoundCap)
    {
        setLineStyle(lsNone);
        setScatterStyle(QCPScatterStyle::ssDisc);
    }

protected:
    void drawScatterPlot(QCPPainter *painter, const QVector<QPointF> &scatters,
                         const QCPScatterStyle &) const override
    {
        applyScattersAntialiasingHint(painter);
        QPainterPath path;
        for (const QPointF &place : scatters) {
            const QPointF rounded(std::round(place.x() * 10.0) / 10.0, std::round(place.y() * 10.0) / 10.0);
            path.moveTo(rounded);
            path.lineTo(rounded + QPointF(0.1, 0.0)); // a line of no length is not drawn by every viewer
        }
        painter->setPen(m_pen);
        painter->setBrush(Qt::NoBrush);
        painter->drawPath(path);
    }

private:
    QPen m_pen;
};

} // namespace

static QCPAxis *keyAxisOf(QCPAxisRect &rect)
{
    return rect.axis(QCPAxis::atBottom);
}

static QCPAxis *valueAxisOf(QCPAxisRect &rect)
{
    return rect.axis(QCPAxis::atLeft);
}

void addLine(QCPAxisRect &rect, const QVector<double> &keys, const QVector<double> &values, const QPen &pen)
{
    auto *graph = new QCPGraph(keyAxisOf(rect), valueAxisOf(rect));
    graph->setPen(pen);
    graph->setData(keys, values);
}

void addRange(QCPAxisRect &rect, const QVector<double> &keys, const QVector<double> &low,
              const QVector<double> &high, const QColor &fill)
{
    auto *lower = new QCPGraph(keyAxisOf(rect), valueAxisOf(rect));
    auto *upper = new QCPGraph(keyAxisOf(rect), valueAxisOf(rect));
    lower->setPen(Qt::NoPen);
    upper->setPen(Qt::NoPen);
    lower->setData(keys, low, true);
    upper->setData(keys, high, true);
    upper->setBrush(fill);
    upper->setChannelFillGraph(lower);
}

void addDots(QCPAxisRect &rect, const QVector<double> &keys, const QVector<double> &values,
             const QColor &color, double diameter)
{
    auto *graph = new DotGraph(keyAxisOf(rect), valueAxisOf(rect), color, diameter);
    graph->setData(keys, values);
}

static void addStraight(QCPAxisRect &rect, const QPointF &from, const QPointF &to, const QPen &pen)
{
    auto *line = new QCPItemStraightLine(rect.parentPlot());
    line->setClipAxisRect(&rect);
    line->setAntialiased(false);
    for (QCPItemPosition *position : {line->point1, line->point2}) {
        position->setAxisRect(&rect);
        position->setAxes(keyAxisOf(rect), valueAxisOf(rect));
        position->setType(QCPItemPosition::ptPlotCoords);
    }
    line->point1->setCoords(from);
    line->point2->setCoords(to);
    line->setPen(pen);
}

void addVertical(QCPAxisRect &rect, double key, const QPen &pen)
{
    const QCPRange range = valueAxisOf(rect)->range();
    addStraight(rect, QPointF(key, range.lower), QPointF(key, range.upper), pen);
}

void addHorizontal(QCPAxisRect &rect, double value, const QPen &pen)
{
    const QCPRange range = keyAxisOf(rect)->range();
    addStraight(rect, QPointF(range.lower, value), QPointF(range.upper, value), pen);
}

} // namespace driftbench
