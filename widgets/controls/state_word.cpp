#include "widgets/controls/state_word.h"

#include "widgets/controls/icon.h"
#include "widgets/style/theme.h"

#include <QPainter>

namespace driftbench {

static constexpr int kIconGap = 6;

QString iconOfTone(Tone tone)
{
    switch (tone) {
    case Tone::Good:
        return QStringLiteral("check");
    case Tone::Caution:
        return QStringLiteral("warn");
    case Tone::Bad:
        return QStringLiteral("cross");
    case Tone::Plain:
    case Tone::Accent:
        return QStringLiteral("info");
    }
    return {};
}

StateWord::StateWord(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void StateWord::setState(Tone tone, const QString &word, const QString &iconName)
{
    m_tone = tone;
    m_word = word;
    m_icon = iconName.isEmpty() ? iconOfTone(tone) : iconName;
    setAccessibleName(word);
    updateGeometry();
    update();
}

void StateWord::setRole(TextRole role)
{
    m_role = role;
    updateGeometry();
    update();
}

QSize StateWord::sizeHint() const
{
    const QFontMetrics metrics(textFont(m_role));
    if (m_word.isEmpty())
        return {0, metrics.height()};
    return {kSmallIcon + kIconGap + metrics.horizontalAdvance(m_word) + 1,
            std::max(kSmallIcon, metrics.height())};
}

void StateWord::paintEvent(QPaintEvent *)
{
    if (m_word.isEmpty())
        return;
    QPainter painter(this);
    const QColor color = textColor(TextRole::NoteText, m_tone, lookOf(palette()));
    paintIcon(painter, QRect(0, (height() - kSmallIcon) / 2, kSmallIcon, kSmallIcon), m_icon, color);
    painter.setFont(textFont(m_role));
    painter.setPen(color);
    painter.drawText(rect().adjusted(kSmallIcon + kIconGap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     m_word);
}

} // namespace driftbench
