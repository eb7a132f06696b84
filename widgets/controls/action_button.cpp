#include "widgets/controls/action_button.h"

#include "widgets/controls/icon.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/fonts.h"
#include "widgets/style/theme.h"

#include <QPainter>
#include <QRegularExpression>
#include <QStyleOptionButton>

namespace driftbench {

static constexpr char kIconProperty[] = "iconName";
static constexpr char kShownShortcut[] = "shownShortcut";

void setActionIcon(QAction &action, const QString &name)
{
    action.setProperty(kIconProperty, name);
    action.setIcon(themedIcon(name));
}

QString actionIcon(const QAction &action)
{
    return action.property(kIconProperty).toString();
}

QString shortcutText(const QAction &action)
{
    const QString shown = action.property(kShownShortcut).toString();
    return shown.isEmpty() ? action.shortcut().toString(QKeySequence::NativeText) : shown;
}

ActionButton::ActionButton(ButtonSize size, QWidget *parent) : QPushButton(parent), m_size(size)
{
    setAutoDefault(false);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAttribute(Qt::WA_Hover);
}

ActionButton::ActionButton(QAction *action, ButtonSize size, QWidget *parent) : ActionButton(size, parent)
{
    m_action = action;
    connect(action, &QAction::changed, this, &ActionButton::follow);
    connect(this, &QPushButton::clicked, action, &QAction::trigger);
    follow();
}

void ActionButton::follow()
{
    m_iconName = actionIcon(*m_action);
    setEnabled(m_action->isEnabled());
    setVisible(m_action->isVisible());
    setText(m_action->text());
    setToolTip(m_action->toolTip() == m_action->text().remove(QLatin1Char('&')) ? QString()
                                                                                : m_action->toolTip());
    setAccessibleName(shownText());
    updateGeometry();
    update();
}

void ActionButton::setPrimary(bool primary)
{
    m_primary = primary;
    setProperty("primary", primary);
    updateGeometry();
    update();
}

void ActionButton::setIconName(const QString &name)
{
    m_iconName = name;
    updateGeometry();
    update();
}

void ActionButton::setShortcutShown(bool shown)
{
    m_shortcutShown = shown;
    updateGeometry();
}

QString ActionButton::shownText() const
{
    QString text = m_action ? m_action->iconText() : QPushButton::text();
    if (m_action && m_action->text().endsWith(QStringLiteral("…")) && !text.endsWith(QStringLiteral("…")))
        text += QStringLiteral("…");
    // Chinese and Japanese have the letter of the menu behind the word, in brackets: "文件(&F)".
    static const QRegularExpression behind(QStringLiteral("\\(&(.)\\)"));
    if (const auto letter = behind.match(m_action ? m_action->text() : text); letter.hasMatch())
        text.remove(letter.captured()).remove(QLatin1Char('(') + letter.captured(1) + QLatin1Char(')'));
    return text.remove(QLatin1Char('&'));
}

QString ActionButton::shownShortcut() const
{
    return m_action && m_shortcutShown ? shortcutText(*m_action) : QString();
}

int ActionButton::iconRoom() const
{
    return m_iconName.isEmpty() ? 0 : kSmallIcon + (m_size == ButtonSize::Head ? 8 : 6);
}

QSize ActionButton::sizeHint() const
{
    const bool head = m_size == ButtonSize::Head;
    const QFont textFont = m_primary ? sectionFont() : (head ? bodyFont() : noteFont());
    int width = 2 * (head ? 12 : 10) + iconRoom() + QFontMetrics(textFont).horizontalAdvance(shownText());
    if (const QString keys = shownShortcut(); !keys.isEmpty())
        width += kGap + QFontMetrics(noteFont()).horizontalAdvance(keys);
    const int height = std::max(head ? kHeadHeight : kControlHeight, QFontMetrics(textFont).height() + 4);
    return {width + 1, height};
}

void ActionButton::paintEvent(QPaintEvent *)
{
    QStyleOptionButton option;
    initStyleOption(&option);
    const Palette &look = lookOf(palette());
    ControlState state;
    state.enabled = isEnabled();
    state.focused = hasFocus();
    state.hovered = option.state & QStyle::State_MouseOver;
    state.pressed = isDown();
    state.checked = isChecked();
    state.primary = m_primary;
    QPainter painter(this);
    paintBox(painter, rect(), buttonBox(look, state));

    const bool head = m_size == ButtonSize::Head;
    QRect content = rect().adjusted(head ? 12 : 10, 0, head ? -12 : -10, 0);
    const QColor color = buttonTextColor(look, state);
    if (!m_iconName.isEmpty()) {
        const QRect place(content.left(), (height() - kSmallIcon) / 2, kSmallIcon, kSmallIcon);
        paintIcon(painter, place, m_iconName, color);
        content.setLeft(content.left() + iconRoom());
    }
    const QString keys = shownShortcut();
    painter.setPen(color);
    painter.setFont(m_primary ? sectionFont() : (head ? bodyFont() : noteFont()));
    painter.drawText(content,
                     (keys.isEmpty() && m_iconName.isEmpty() ? Qt::AlignHCenter : Qt::AlignLeft) |
                         Qt::AlignVCenter | Qt::TextSingleLine,
                     shownText());
    if (keys.isEmpty())
        return;
    painter.setFont(noteFont());
    painter.setPen(!state.enabled ? look.disabledText : m_primary ? look.textOnAccent : look.mutedText);
    painter.drawText(content, Qt::AlignRight | Qt::AlignVCenter | Qt::TextSingleLine, keys);
}

} // namespace driftbench
