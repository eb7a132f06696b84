#include "widgets/style/scroll_bar_paint.h"

#include "widgets/style/control_paint.h"

#include <QPainter>

namespace driftbench {

static constexpr int kShortestThumb = 24;

static QRect sliderOf(const QStyleOptionSlider &bar)
{
    const bool across = bar.orientation == Qt::Horizontal;
    const int length = across ? bar.rect.width() : bar.rect.height();
    const qint64 range = qint64(bar.maximum) - bar.minimum;
    int thumb = length;
    if (range > 0)
        thumb = static_cast<int>(qint64(bar.pageStep) * length / (range + std::max(1, bar.pageStep)));
    thumb = std::clamp(thumb, std::min(kShortestThumb, length), length);
    const int start = QStyle::sliderPositionFromValue(bar.minimum, bar.maximum, bar.sliderPosition,
                                                      length - thumb, bar.upsideDown);
    return across ? QRect(bar.rect.left() + start, bar.rect.top(), thumb, bar.rect.height())
                  : QRect(bar.rect.left(), bar.rect.top() + start, bar.rect.width(), thumb);
}

QRect scrollBarPart(const QStyleOptionSlider &bar, QStyle::SubControl part)
{
    const bool across = bar.orientation == Qt::Horizontal;
    const QRect slider = sliderOf(bar);
    switch (part) {
    case QStyle::SC_ScrollBarSlider:
        return slider;
    case QStyle::SC_ScrollBarGroove:
        return bar.rect;
    case QStyle::SC_ScrollBarSubPage:
        return across ? QRect(bar.rect.topLeft(), QPoint(slider.left() - 1, bar.rect.bottom()))
                      : QRect(bar.rect.topLeft(), QPoint(bar.rect.right(), slider.top() - 1));
    case QStyle::SC_ScrollBarAddPage:
        return across ? QRect(QPoint(slider.right() + 1, bar.rect.top()), bar.rect.bottomRight())
                      : QRect(QPoint(bar.rect.left(), slider.bottom() + 1), bar.rect.bottomRight());
    default:
        return {};
    }
}

void paintScrollBar(QPainter &painter, const QStyleOptionSlider &bar, const Palette &look)
{
    painter.fillRect(bar.rect, look.base);
    if (bar.maximum <= bar.minimum)
        return;
    const bool active = bar.state & (QStyle::State_MouseOver | QStyle::State_Sunken);
    const QRect thumb = sliderOf(bar).adjusted(2, 2, -2, -2);
    paintBox(painter, thumb, {active ? look.axisLine : look.border, QColor()}, 4);
}

} // namespace driftbench
