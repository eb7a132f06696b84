// An opaque fill between two lines over the same keys, without an outline. Drawn as one polygon for each
// stretch without a gap, cut at the panel's edges: QSvgGenerator of Qt 6.4 ignores clip paths.
#pragma once

#include <qcustomplot.h>

namespace driftbench {

class RangeGraph : public QCPGraph
{
    Q_OBJECT

public:
    using QCPGraph::QCPGraph; // setBrush for the fill

    // Keys ascending; a value that is not finite makes a gap.
    void setBand(const QVector<double> &keys, const QVector<double> &low, const QVector<double> &high);

protected:
    void draw(QCPPainter *painter) override;

private:
    struct Edge
    {
        double x, low, high; // pixels
    };
    Edge edgeAt(qsizetype index) const;
    void drawStretch(QCPPainter &painter, const QVector<Edge> &edges) const;

    QVector<double> m_keys, m_low, m_high;
};

} // namespace driftbench
