#include "widgets/plot/legend_painter.h"

#include "widgets/style/fonts.h"

#include <QFontMetrics>
#include <QPainter>

namespace driftbench {

static constexpr int kMarkWidth = 20;
static constexpr int kDotMarkWidth = 8;
static constexpr int kMarkGap = 6;
static constexpr int kEntryGap = 16;
static constexpr int kRowHeight = 20;
static constexpr int kRangeHeight = 9;

LegendPainter::LegendPainter(std::vector<LegendEntry> entries, const Palette &palette)
    : m_entries(std::move(entries))
    , m_textColor(palette.mutedText)
    , m_headingColor(palette.text)
    , m_baseColor(palette.base)
{
}

static int markWidth(LegendEntry::Kind kind)
{
    switch (kind) {
    case LegendEntry::Kind::Heading:
        return 0;
    case LegendEntry::Kind::Dot:
    case LegendEntry::Kind::Diamond:
    case LegendEntry::Kind::Triangle:
        return kDotMarkWidth + kMarkGap;
    default:
        return kMarkWidth + kMarkGap;
    }
}

static QFont fontOf(const LegendEntry &entry)
{
    return entry.kind == LegendEntry::Kind::Heading ? strongNoteFont() : noteFont();
}

int LegendPainter::widthOf(const LegendEntry &entry) const
{
    return markWidth(entry.kind) + QFontMetrics(fontOf(entry)).horizontalAdvance(entry.text) + 2;
}

int LegendPainter::widthInOneRow() const
{
    int width = 0;
    for (const LegendEntry &entry : m_entries)
        width += widthOf(entry) + kEntryGap;
    return std::max(width - kEntryGap, 0);
}

std::vector<QPoint> LegendPainter::places(int width) const
{
    std::vector<QPoint> places;
    QPoint at(0, 0);
    for (const LegendEntry &entry : m_entries) {
        const int entryWidth = widthOf(entry);
        if (at.x() > 0 && at.x() + entryWidth > width)
            at = QPoint(0, at.y() + kRowHeight);
        places.push_back(at);
        at.rx() += entryWidth + kEntryGap;
    }
    return places;
}

int LegendPainter::heightFor(int width) const
{
    const auto all = places(width);
    return all.empty() ? 0 : all.back().y() + kRowHeight;
}

void LegendPainter::paintMark(QPainter &painter, const LegendEntry &entry, const QPoint &topLeft) const
{
    const double middle = topLeft.y() + kRowHeight / 2;
    const double left = topLeft.x();
    const QPointF dot(left + kDotMarkWidth / 2, middle);
    painter.setPen(Qt::NoPen);
    painter.setBrush(entry.fill);
    if (entry.kind == LegendEntry::Kind::Dot) {
        painter.drawEllipse(dot, 2.75, 2.75);
    } else if (entry.kind == LegendEntry::Kind::Diamond) {
        painter.setPen(entry.pen);
        painter.setBrush(m_baseColor);
        painter.drawPolygon(QPolygonF{dot + QPointF(0, -3.5), dot + QPointF(3.5, 0), dot + QPointF(0, 3.5),
                                      dot + QPointF(-3.5, 0)});
    } else if (entry.kind == LegendEntry::Kind::Triangle) {
        painter.drawPolygon(QPolygonF{dot + QPointF(-3.5, -3), dot + QPointF(3.5, -3), dot + QPointF(0, 3)});
    } else if (entry.kind != LegendEntry::Kind::Heading) {
        if (entry.kind == LegendEntry::Kind::Range)
            painter.drawRect(QRectF(left, middle - kRangeHeight / 2, kMarkWidth, kRangeHeight));
        painter.setPen(entry.pen);
        painter.setBrush(Qt::NoBrush);
        if (entry.pen.style() != Qt::NoPen)
            painter.drawLine(QLineF(left, middle + 0.5, left + kMarkWidth, middle + 0.5));
    }
}

void LegendPainter::paint(QPainter &painter, const QRect &place) const
{
    const auto all = places(place.width());
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        const LegendEntry &entry = m_entries[i];
        const QPoint topLeft = place.topLeft() + all[i];
        paintMark(painter, entry, topLeft);
        painter.setFont(fontOf(entry));
        painter.setPen(entry.kind == LegendEntry::Kind::Heading ? m_headingColor : m_textColor);
        const int indent = markWidth(entry.kind);
        painter.drawText(QRect(topLeft.x() + indent, topLeft.y(), widthOf(entry) - indent, kRowHeight),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, entry.text);
    }
}

} // namespace driftbench
