// A push button that shows an action: icon, text, and its shortcut in muted letters behind. In the head of a
// page it is 32 px high, elsewhere 24. One button a page is primary.
//
// Text, icon, enabled state and tooltip follow the action; the shortcut that is shown is the action's first,
// or its dynamic property "shownShortcut" where the key is handled by the page itself (Enter, Space).
#pragma once

#include <QAction>
#include <QPushButton>

namespace driftbench {

enum class ButtonSize
{
    Head,
    Small
};

class ActionButton : public QPushButton
{
    Q_OBJECT

public:
    ActionButton(QAction *action, ButtonSize size, QWidget *parent = nullptr);
    // Without an action: text and icon are set by hand.
    explicit ActionButton(ButtonSize size, QWidget *parent = nullptr);

    void setPrimary(bool primary);
    bool isPrimary() const { return m_primary; }
    void setIconName(const QString &name); // for one without an action
    void setShortcutShown(bool shown);     // on unless told otherwise

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void follow();
    QString shownText() const;
    QString shownShortcut() const;
    int iconRoom() const;

    QAction *m_action = nullptr;
    QString m_iconName;
    ButtonSize m_size;
    bool m_primary = false;
    bool m_shortcutShown = true;
};

// The icon that an ActionButton shows for its action.
void setActionIcon(QAction &action, const QString &name);
QString actionIcon(const QAction &action);

// The keys of an action as people read them; empty if it has none.
QString shortcutText(const QAction &action);

} // namespace driftbench
