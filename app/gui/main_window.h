// The window: menus, rail, the pages, status bar, event log. Pages are shown one at a time and none is ever
// locked.
#pragma once

#include "app/gui/app_context.h"
#include "app/gui/page.h"

#include <QMainWindow>

#include <array>
#include <functional>
#include <memory>

class QActionGroup;
class QDockWidget;
class QScrollArea;
class QStackedWidget;

namespace driftbench {

class ShortcutOverview;
class StatusLine;
class StepRail;

class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    explicit MainWindow(AppContext &context, QWidget *parent = nullptr);
    ~MainWindow() override;

    void showStep(Step step);
    Step currentStep() const { return m_step; }
    Page *page(Step step) const { return m_pages[static_cast<std::size_t>(step)]; }
    StepRail &rail() const { return *m_rail; }
    StatusLine &statusLine() const { return *m_status; }

    // What to call after the first paint of the window, once, with no events between.
    void onFirstPaint(std::function<void()> call) { m_onFirstPaint = std::move(call); }

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;

private:
    struct Menus;

    void buildMenus();
    void buildStepActions();
    void buildViewMenu();
    void buildEventLog();
    void retranslate();
    void addPage(Step step, Page *page);
    void showStateOf(Step step);
    void showStatus();
    void showSaveAction();
    void showSessionMenu();
    void showShortcuts();
    void showAbout();
    void restoreWindow();
    void saveWindow() const;
    QAction *addWindowAction(const QKeySequence &keys, std::function<void()> slot);

    AppContext &m_context;
    std::unique_ptr<Menus> m_menus;
    StepRail *m_rail;
    QStackedWidget *m_stack;
    QScrollArea *m_scroll;
    StatusLine *m_status;
    QDockWidget *m_eventDock = nullptr;
    ShortcutOverview *m_shortcuts = nullptr;
    std::array<Page *, kSteps.size()> m_pages{};
    Step m_step = Step::Source;
    std::function<void()> m_onFirstPaint;
};

} // namespace driftbench
