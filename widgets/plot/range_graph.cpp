#include "widgets/plot/range_graph.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

void RangeGraph::setBand(const QVector<double> &keys, const QVector<double> &low, const QVector<double> &high)
{
    m_keys = keys;
    m_low = low;
    m_high = high;
    setData(keys, high, true); // what tables and searches for the nearest point see
}

RangeGraph::Edge RangeGraph::edgeAt(qsizetype index) const
{
    return {mKeyAxis->coordToPixel(m_keys[index]), mValueAxis->coordToPixel(m_low[index]),
            mValueAxis->coordToPixel(m_high[index])};
}

void RangeGraph::drawStretch(QCPPainter &painter, const QVector<Edge> &edges) const
{
    if (edges.size() < 2)
        return;
    const QRectF inside = clipRect();
    QPolygonF outline;
    outline.reserve(2 * edges.size());
    const auto add = [&](double x, double y) {
        outline.append({x, std::clamp(y, inside.top(), inside.bottom() + 1.0)});
    };
    // Ends outside the panel move to its edge along the lines.
    const auto cut = [&](const Edge &out, const Edge &in, double x) {
        const double share = (x - in.x) / (out.x - in.x);
        return Edge{x, in.low + share * (out.low - in.low), in.high + share * (out.high - in.high)};
    };
    QVector<Edge> shown = edges;
    if (shown[0].x < inside.left() && shown[1].x > inside.left())
        shown[0] = cut(shown[0], shown[1], inside.left());
    const qsizetype last = shown.size() - 1;
    if (shown[last].x > inside.right() && shown[last - 1].x < inside.right())
        shown[last] = cut(shown[last], shown[last - 1], inside.right());
    for (const Edge &edge : shown)
        add(edge.x, edge.high);
    for (auto edge = shown.crbegin(); edge != shown.crend(); ++edge)
        add(edge->x, edge->low);
    painter.drawPolygon(outline);
}

void RangeGraph::draw(QCPPainter *painter)
{
    if (!mKeyAxis || !mValueAxis || m_keys.isEmpty())
        return;
    const QCPRange range = mKeyAxis->range();
    auto first = std::lower_bound(m_keys.cbegin(), m_keys.cend(), range.lower) - m_keys.cbegin();
    auto end = std::upper_bound(m_keys.cbegin(), m_keys.cend(), range.upper) - m_keys.cbegin();
    first = std::max<qsizetype>(first - 1, 0);
    end = std::min<qsizetype>(end + 1, m_keys.size());
    painter->setAntialiasing(false);
    painter->setPen(Qt::NoPen);
    painter->setBrush(brush());
    QVector<Edge> edges;
    for (qsizetype i = first; i < end; ++i) {
        if (std::isfinite(m_low[i]) && std::isfinite(m_high[i])) {
            edges.append(edgeAt(i));
            continue;
        }
        drawStretch(*painter, edges);
        edges.clear();
    }
    drawStretch(*painter, edges);
}

} // namespace driftbench
