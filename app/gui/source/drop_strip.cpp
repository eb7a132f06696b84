#include "app/gui/source/drop_strip.h"

#include "widgets/controls/icon.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/fonts.h"
#include "widgets/style/theme.h"

#include <QPainter>

namespace driftbench {

static constexpr int kIconGap = 10;

DropStrip::DropStrip(QWidget *parent) : QAbstractButton(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFont(noteFont());
    setCursor(Qt::PointingHandCursor);
}

void DropStrip::paintEvent(QPaintEvent *)
{
    const Palette &look = lookOf(palette());
    QPainter painter(this);
    if (hasFocus()) {
        paintBox(painter, rect(), {QColor(), look.accent, 2});
    } else {
        QPen dashed(look.axisLine, 1.0);
        dashed.setDashPattern({3, 3});
        painter.setPen(dashed);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCornerRadius, kCornerRadius);
    }
    const QFontMetrics metrics(noteFont());
    const QString words = metrics.elidedText(text(), Qt::ElideRight, width() - 2 * 16 - kIcon - kIconGap);
    const int left = (width() - kIcon - kIconGap - metrics.horizontalAdvance(words)) / 2;
    paintIcon(painter, QRect(left, (height() - kIcon) / 2, kIcon, kIcon), QStringLiteral("drop"),
              look.mutedText);
    painter.setFont(noteFont());
    painter.setPen(look.mutedText);
    painter.drawText(QRect(left + kIcon + kIconGap, 0, width(), height()), Qt::AlignLeft | Qt::AlignVCenter,
                     words);
}

} // namespace driftbench
