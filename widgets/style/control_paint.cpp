#include "widgets/style/control_paint.h"

#include <QPainter>
#include <QPainterPath>

namespace driftbench {

void paintBox(QPainter &painter, const QRect &rect, const BoxPaint &box, int radius)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double half = box.borderWidth / 2.0;
    const QRectF inner = QRectF(rect).adjusted(half, half, -half, -half);
    painter.setPen(box.border.isValid() ? QPen(box.border, box.borderWidth) : QPen(Qt::NoPen));
    painter.setBrush(box.fill.isValid() ? QBrush(box.fill) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(inner, radius - half, radius - half);
    painter.restore();
}

static QColor blended(const QColor &color, const QColor &other, double share)
{
    const auto mix = [share](int a, int b) { return static_cast<int>(a + (b - a) * share + 0.5); };
    return {mix(color.red(), other.red()), mix(color.green(), other.green()),
            mix(color.blue(), other.blue())};
}

BoxPaint buttonBox(const Palette &look, const ControlState &state)
{
    BoxPaint box{look.button, look.border};
    if (!state.enabled)
        box.fill = QColor();
    else if (state.primary)
        box = {look.accent, look.accent};
    else if (state.checked)
        box.fill = look.selection;
    if (state.enabled && (state.hovered || state.pressed))
        box.fill =
            blended(box.fill, state.primary ? look.textOnAccent : look.text, state.pressed ? 0.12 : 0.05);
    if (state.focused && state.enabled)
        box = {box.fill, state.primary ? look.text : look.accent, 2};
    return box;
}

QColor buttonTextColor(const Palette &look, const ControlState &state)
{
    if (!state.enabled)
        return look.disabledText;
    if (state.primary)
        return look.textOnAccent;
    return state.checked ? look.accent : look.text;
}

BoxPaint fieldBox(const Palette &look, const ControlState &state)
{
    BoxPaint box{state.enabled ? look.base : QColor(), look.border};
    if (state.invalid)
        box.border = look.bad;
    else if (state.focused && state.enabled)
        box.border = look.accent;
    if (state.focused && state.enabled)
        box.borderWidth = 2;
    return box;
}

static QPen roundPen(const QColor &color, double width)
{
    return {color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

void paintCheckMark(QPainter &painter, const QRect &rect, const QColor &color)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(roundPen(color, 1.6));
    painter.setBrush(Qt::NoBrush);
    const QPointF origin = rect.topLeft();
    const double w = rect.width();
    const double h = rect.height();
    QPainterPath path(origin + QPointF(0.24 * w, 0.52 * h));
    path.lineTo(origin + QPointF(0.43 * w, 0.70 * h));
    path.lineTo(origin + QPointF(0.77 * w, 0.32 * h));
    painter.drawPath(path);
    painter.restore();
}

void paintChevron(QPainter &painter, const QRect &rect, const QColor &color)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(roundPen(color, 1.3));
    const QPointF centre = QRectF(rect).center();
    painter.drawPolyline(
        QPolygonF{centre + QPointF(-5, -2.5), centre + QPointF(0, 2.5), centre + QPointF(5, -2.5)});
    painter.restore();
}

void paintArrow(QPainter &painter, const QRect &rect, bool up, const QColor &color)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    const QPointF centre = QRectF(rect).center();
    const double tip = up ? -2.5 : 2.5;
    painter.drawPolygon(
        QPolygonF{centre + QPointF(-4.5, -tip), centre + QPointF(0, tip), centre + QPointF(4.5, -tip)});
    painter.restore();
}

} // namespace driftbench
