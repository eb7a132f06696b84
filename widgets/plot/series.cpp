#include "widgets/plot/series.h"

#include "widgets/plot/range_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace driftbench {

// QSvgGenerator of Qt 6.4 ignores clip paths: what leaves the panel must be cut here. The part of a..b inside
// the rectangle (Liang & Barsky 1984); nothing if there is none.
static std::optional<QLineF> clipped(const QLineF &line, const QRectF &inside)
{
    double first = 0.0;
    double last = 1.0;
    const std::array<std::pair<double, double>, 4> edges{{{-line.dx(), line.x1() - inside.left()},
                                                          {line.dx(), inside.right() - line.x1()},
                                                          {-line.dy(), line.y1() - inside.top()},
                                                          {line.dy(), inside.bottom() - line.y1()}}};
    for (const auto &[step, distance] : edges) {
        if (step == 0.0 && distance < 0.0)
            return std::nullopt;
        if (step < 0.0)
            first = std::max(first, distance / step);
        else if (step > 0.0)
            last = std::min(last, distance / step);
    }
    if (!(first <= last))
        return std::nullopt;
    return QLineF(line.pointAt(first), line.pointAt(last));
}

namespace {

class LineGraph : public QCPGraph
{
public:
    using QCPGraph::QCPGraph;

protected:
    void drawLinePlot(QCPPainter *painter, const QVector<QPointF> &lines) const override
    {
        if (!painter->modes().testFlag(QCPPainter::pmVectorized)) {
            QCPGraph::drawLinePlot(painter, lines);
            return;
        }
        const QRectF inside(clipRect());
        QVector<QPointF> visible;
        for (qsizetype i = 1; i < lines.size(); ++i) {
            const auto piece = clipped(QLineF(lines[i - 1], lines[i]), inside);
            if (!piece || visible.isEmpty() || visible.last() != piece->p1()) {
                QCPGraph::drawLinePlot(painter, visible);
                visible.clear();
                if (piece)
                    visible.append(piece->p1());
            }
            if (piece)
                visible.append(piece->p2());
        }
        QCPGraph::drawLinePlot(painter, visible);
    }
};

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
        const QRectF inside(clipRect());
        if (!painter->modes().testFlag(QCPPainter::pmVectorized)) {
            stampDots(*painter, scatters, inside);
            return;
        }
        QPainterPath path;
        for (const QPointF &place : scatters) {
            if (!inside.contains(place))
                continue;
            const QPointF rounded(std::round(place.x() * 10.0) / 10.0, std::round(place.y() * 10.0) / 10.0);
            path.moveTo(rounded);
            path.lineTo(rounded + QPointF(0.1, 0.0)); // a line of no length is not drawn by every viewer
        }
        painter->setPen(m_pen);
        painter->setBrush(Qt::NoBrush);
        painter->drawPath(path);
    }

private:
    // On the screen a picture of one dot is stamped: thousands of stroked points take too long.
    void stampDots(QCPPainter &painter, const QVector<QPointF> &places, const QRectF &inside) const
    {
        const double ratio = painter.device()->devicePixelRatioF();
        const int side = static_cast<int>(std::ceil(m_pen.widthF() * ratio)) + 2;
        QPixmap dot(side, side);
        dot.fill(Qt::transparent);
        QPainter dotPainter(&dot);
        dotPainter.setRenderHint(QPainter::Antialiasing);
        dotPainter.setPen(Qt::NoPen);
        dotPainter.setBrush(m_pen.color());
        const double radius = m_pen.widthF() * ratio / 2.0;
        dotPainter.drawEllipse(QPointF(side / 2.0, side / 2.0), radius, radius);
        dotPainter.end();
        QVector<QPainter::PixmapFragment> stamps;
        stamps.reserve(places.size());
        for (const QPointF &place : places) {
            if (inside.contains(place))
                stamps.append(QPainter::PixmapFragment::create(place, QRectF(0, 0, side, side), 1.0 / ratio,
                                                               1.0 / ratio));
        }
        painter.drawPixmapFragments(stamps.constData(), static_cast<int>(stamps.size()), dot);
    }

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

void addLine(QCPAxisRect &rect, const QVector<double> &keys, const QVector<double> &values, const QPen &pen,
             const QString &name)
{
    auto *graph = new LineGraph(keyAxisOf(rect), valueAxisOf(rect));
    graph->setPen(pen);
    graph->setName(name);
    graph->setData(keys, values);
}

void addRange(QCPAxisRect &rect, const QVector<double> &keys, const QVector<double> &low,
              const QVector<double> &high, const QColor &fill, const QString &name)
{
    auto *graph = new RangeGraph(keyAxisOf(rect), valueAxisOf(rect));
    graph->setBand(keys, low, high);
    graph->setBrush(fill);
    graph->setName(name);
}

void addDots(QCPAxisRect &rect, const QVector<double> &keys, const QVector<double> &values,
             const QColor &color, double diameter, const QString &name)
{
    auto *graph = new DotGraph(keyAxisOf(rect), valueAxisOf(rect), color, diameter);
    graph->setName(name);
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
