#include "widgets/controls/origin_chip.h"

#include "widgets/controls/icon.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/fonts.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QPainter>

namespace driftbench {

static constexpr int kChipHeight = 20;
static constexpr int kMargin = 6;

OriginChip::OriginChip(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setFont(noteFont());
    setOrigin(Origin::None);
}

QString OriginChip::words(Origin origin)
{
    switch (origin) {
    case Origin::Simulated:
        return tr("Simulated data");
    case Origin::Device:
        return tr("Real device");
    case Origin::Real:
        return tr("Real log");
    case Origin::None:
        break;
    }
    return {};
}

void OriginChip::setOrigin(Origin origin)
{
    m_origin = origin;
    setVisible(origin != Origin::None);
    setAccessibleName(words(origin));
    updateGeometry();
    update();
}

QSize OriginChip::sizeHint() const
{
    const QFontMetrics metrics(noteFont());
    return {kMargin + kSmallIcon + 6 + metrics.horizontalAdvance(words(m_origin)) + kMargin + 1,
            std::max(kChipHeight, metrics.height() + 2)};
}

static QString iconOf(Origin origin)
{
    return origin == Origin::Simulated ? QStringLiteral("sim")
           : origin == Origin::Device  ? QStringLiteral("usb")
                                       : QStringLiteral("file");
}

void OriginChip::paintEvent(QPaintEvent *)
{
    const Palette &look = lookOf(palette());
    QPainter painter(this);
    paintBox(painter, rect(), {look.base, look.border});
    paintIcon(painter, QRect(kMargin, (height() - kSmallIcon) / 2, kSmallIcon, kSmallIcon), iconOf(m_origin),
              look.mutedText);
    painter.setFont(noteFont());
    painter.setPen(look.mutedText);
    painter.drawText(rect().adjusted(kMargin + kSmallIcon + 6, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     words(m_origin));
}

void OriginChip::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        setOrigin(m_origin);
}

} // namespace driftbench
