// A legend as a row of marks and words; wraps where there is little room. Painted, so that a row of the
// window and a row inside a picture look the same.
#pragma once

#include "widgets/style/palette.h"

#include <QPen>
#include <QString>

#include <vector>

class QPainter;
class QPoint;
class QRect;

namespace driftbench {

struct LegendEntry
{
    enum class Kind
    {
        Heading, // semibold words, no mark
        Line,    // a piece of the line
        Range,   // the fill with the line in it (no line: NoPen)
        Dot,
        Diamond,
        Triangle // points down
    };
    Kind kind = Kind::Line;
    QString text;
    QPen pen = QPen(Qt::NoPen);
    QColor fill;
};

class LegendPainter
{
public:
    LegendPainter(std::vector<LegendEntry> entries, const Palette &palette);

    const std::vector<LegendEntry> &entries() const { return m_entries; }
    int widthInOneRow() const;
    int heightFor(int width) const;
    void paint(QPainter &painter, const QRect &place) const;

private:
    std::vector<QPoint> places(int width) const; // top left of each entry
    int widthOf(const LegendEntry &entry) const;
    void paintMark(QPainter &painter, const LegendEntry &entry, const QPoint &topLeft) const;

    std::vector<LegendEntry> m_entries;
    QColor m_textColor;
    QColor m_headingColor;
    QColor m_baseColor;
};

} // namespace driftbench
