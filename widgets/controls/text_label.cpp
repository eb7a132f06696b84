#include "widgets/controls/text_label.h"

#include "widgets/style/fonts.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QFontDatabase>
#include <QPainter>

namespace driftbench {

QFont textFont(TextRole role)
{
    switch (role) {
    case TextRole::Body:
    case TextRole::Muted:
        return bodyFont();
    case TextRole::Note:
    case TextRole::NoteText:
        return noteFont();
    case TextRole::StrongNote:
        return strongNoteFont();
    case TextRole::Section:
        return sectionFont();
    case TextRole::Result:
        return resultFont();
    case TextRole::Title:
        return pageTitleFont();
    case TextRole::Code: {
        QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
        font.setPointSize(noteFont().pointSize());
        return font;
    }
    }
    return bodyFont();
}

QColor textColor(TextRole role, Tone tone, const Palette &look)
{
    switch (tone) {
    case Tone::Accent:
        return look.accent;
    case Tone::Good:
        return look.good;
    case Tone::Caution:
        return look.caution;
    case Tone::Bad:
        return look.bad;
    case Tone::Plain:
        break;
    }
    return role == TextRole::Muted || role == TextRole::Note ? look.mutedText : look.text;
}

TextLabel::TextLabel(TextRole role, const QString &text, QWidget *parent) : QLabel(text, parent), m_role(role)
{
    setFont(textFont(role));
    setTextFormat(Qt::PlainText);
    recolor();
}

void TextLabel::setRole(TextRole role)
{
    m_role = role;
    setFont(textFont(role));
    recolor();
}

void TextLabel::setTone(Tone tone)
{
    if (tone == m_tone)
        return;
    m_tone = tone;
    recolor();
}

void TextLabel::setElided(bool elided)
{
    m_elided = elided;
    updateGeometry();
    update();
}

QSize TextLabel::minimumSizeHint() const
{
    const QSize usual = QLabel::minimumSizeHint();
    return m_elided ? QSize(std::min(usual.width(), 24), usual.height()) : usual;
}

void TextLabel::changeEvent(QEvent *event)
{
    QLabel::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        recolor();
}

void TextLabel::paintEvent(QPaintEvent *event)
{
    const QString shown =
        m_elided ? fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()) : text();
    if (!m_elided || shown == text()) {
        if (m_elided && !toolTip().isEmpty())
            setToolTip({});
        return QLabel::paintEvent(event);
    }
    if (toolTip() != text())
        setToolTip(text());
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(contentsRect(), int(alignment()) | Qt::TextSingleLine, shown);
}

void TextLabel::recolor()
{
    const QColor color = textColor(m_role, m_tone, lookOf(palette()));
    QPalette own = palette();
    // Setting a palette ends in another PaletteChange: only where it changes something.
    if (own.color(QPalette::Active, QPalette::WindowText) == color)
        return;
    // Window stays the inherited one, by which lookOf() tells light from dark.
    QPalette only;
    only.setResolveMask(0);
    only.setColor(QPalette::Active, QPalette::WindowText, color);
    only.setColor(QPalette::Inactive, QPalette::WindowText, color);
    setPalette(only);
}

} // namespace driftbench
