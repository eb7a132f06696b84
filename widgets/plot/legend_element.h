// A legend as a row of the plot's layout, above the panels and never over data; wraps where the plot is
// narrow. It is part of the plot, so that pictures of the plot carry it.
#pragma once

#include "widgets/style/palette.h"

#include <qcustomplot.h>

#include <vector>

namespace driftbench {

struct LegendEntry
{
    enum class Kind
    {
        Heading, // semibold words, no mark
        Line,    // a piece of the line
        Range,   // the fill with the line in it (no line: NoPen)
        Dot,
        Diamond
    };
    Kind kind = Kind::Line;
    QString text;
    QPen pen = QPen(Qt::NoPen);
    QColor fill;
};

class LegendElement : public QCPLayoutElement
{
    Q_OBJECT

public:
    LegendElement(QCustomPlot *plot, std::vector<LegendEntry> entries, const Palette &palette);

    QSize minimumOuterSizeHint() const override;
    QSize maximumOuterSizeHint() const override;

protected:
    void applyDefaultAntialiasingHint(QCPPainter *painter) const override;
    void draw(QCPPainter *painter) override;

private:
    std::vector<QPoint> place(int width) const; // top left of each entry
    int widthOf(const LegendEntry &entry) const;
    int heightFor(int width) const;
    void drawMark(QCPPainter &painter, const LegendEntry &entry, const QPoint &topLeft) const;

    std::vector<LegendEntry> m_entries;
    QColor m_textColor;
    QColor m_headingColor;
    QColor m_baseColor;
};

} // namespace driftbench
