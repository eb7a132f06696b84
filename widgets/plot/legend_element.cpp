#include "widgets/plot/legend_element.h"

#include "widgets/style/fonts.h"

namespace driftbench {

static constexpr int kMarkWidth = 20;
static constexpr int kDotMarkWidth = 8;
static constexpr int kMarkGap = 6;
static constexpr int kEntryGap = 16;
static constexpr int kRowHeight = 20;
static constexpr int kRangeHeight = 9;

LegendElement::LegendElement(QCustomPlot *plot, std::vector<LegendEntry> entries, const Palette &palette)
    : QCPLayoutElement(plot)
    , m_entries(std::move(entries))
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
        return kDotMarkWidth + kMarkGap;
    default:
        return kMarkWidth + kMarkGap;
    }
}

static QFont fontOf(const LegendEntry &entry)
{
    return entry.kind == LegendEntry::Kind::Heading ? strongNoteFont() : noteFont();
}

int LegendElement::widthOf(const LegendEntry &entry) const
{
    return markWidth(entry.kind) + QFontMetrics(fontOf(entry)).horizontalAdvance(entry.text) + 2;
}

std::vector<QPoint> LegendElement::place(int width) const
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

int LegendElement::heightFor(int width) const
{
    const auto places = place(width);
    return places.empty() ? 0 : places.back().y() + kRowHeight;
}

QSize LegendElement::minimumOuterSizeHint() const
{
    const int width = mParentPlot->viewport().width() - 2 * kEntryGap;
    return {0, heightFor(width)};
}

QSize LegendElement::maximumOuterSizeHint() const
{
    return {QWIDGETSIZE_MAX, minimumOuterSizeHint().height()};
}

void LegendElement::applyDefaultAntialiasingHint(QCPPainter *painter) const
{
    painter->setAntialiasing(true);
}

void LegendElement::drawMark(QCPPainter &painter, const LegendEntry &entry, const QPoint &topLeft) const
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
    } else if (entry.kind != LegendEntry::Kind::Heading) {
        if (entry.kind == LegendEntry::Kind::Range)
            painter.drawRect(QRectF(left, middle - kRangeHeight / 2, kMarkWidth, kRangeHeight));
        painter.setPen(entry.pen);
        painter.setBrush(Qt::NoBrush);
        if (entry.pen.style() != Qt::NoPen)
            painter.drawLine(QLineF(left, middle + 0.5, left + kMarkWidth, middle + 0.5));
    }
}

void LegendElement::draw(QCPPainter *painter)
{
    const auto places = place(mOuterRect.width());
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        const LegendEntry &entry = m_entries[i];
        const QPoint topLeft = mOuterRect.topLeft() + places[i];
        drawMark(*painter, entry, topLeft);
        painter->setFont(fontOf(entry));
        painter->setPen(entry.kind == LegendEntry::Kind::Heading ? m_headingColor : m_textColor);
        const int indent = markWidth(entry.kind);
        painter->drawText(QRect(topLeft.x() + indent, topLeft.y(), widthOf(entry) - indent, kRowHeight),
                          Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, entry.text);
    }
}

} // namespace driftbench
