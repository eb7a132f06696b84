// One page of the window: head, the one banner, body. A page reads values of the session and shows them; what
// it changes goes through the session.
//
// A page sets all its texts in retranslate(), which is called once by initialise() and again whenever the
// language changes; it repaints by role on its own when light and dark change (PaletteChange).
//
// Keys: an action made with addPageAction() works while the page is shown, appears in the Session menu and in
// the overview of shortcuts, and can be shown by an ActionButton. Plain Enter is not a shortcut: give the
// primary action to setPrimaryAction(), the page triggers it when no control wants the key for itself.
#pragma once

#include "app/gui/app_context.h"
#include "app/gui/page_head.h"
#include "widgets/controls/banner_slot.h"
#include "widgets/controls/text_label.h"

#include <QKeySequence>
#include <QWidget>

#include <functional>
#include <vector>

class QUndoStack;

namespace driftbench {

struct StatusPart
{
    QString text;
    Tone tone = Tone::Plain;
    int yields = 0; // where room is short the part with the highest is left out first; 0: never
};

class Page : public QWidget
{
    Q_OBJECT

public:
    Page(AppContext &context, QWidget *parent = nullptr);

    virtual StepState stepState() const = 0; // for the rail
    virtual QString hints() const = 0;       // keys of this page, for the status bar: "F5 look again · …"
    // For the status bar, between what the frame says of the source and of the origin.
    virtual std::vector<StatusPart> statusParts() const { return {}; }
    // What Ctrl+S does here; nothing: it saves the session. Its own shortcut stays empty (see "shownShortcut"
    // of action_button.h).
    virtual QAction *saveAction() const { return nullptr; }
    void initialise(); // once, after construction; showing it does it as well
    // What Ctrl+Z takes back here; nothing: edits of the session's calibration plan.
    virtual QUndoStack *undoStack() const { return nullptr; }
    virtual void entered() {} // became the page that is shown
    virtual void left() {}

    Origin origin() const { return m_head->origin(); }
    const std::vector<QAction *> &pageActions() const { return m_actions; }
    PageHead &head() const { return *m_head; }
    BannerSlot &banners() const { return *m_banners; }

signals:
    void stateChanged(); // the rail and the status bar must be read again

protected:
    AppContext &context() const { return m_context; }
    void setBody(QWidget *body);
    virtual void retranslate() = 0;

    // iconName may be empty. Its text is set in retranslate().
    QAction *addPageAction(const QKeySequence &keys, const QString &iconName, std::function<void()> slot);
    void setPrimaryAction(QAction *action) { m_primary = action; }

    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    AppContext &m_context;
    PageHead *m_head;
    BannerSlot *m_banners;
    QWidget *m_body = nullptr;
    QAction *m_primary = nullptr;
    std::vector<QAction *> m_actions;
    bool m_translated = false;
};

} // namespace driftbench
