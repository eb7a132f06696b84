// The window: menus, rail, the pages, status bar, event log. Pages are shown one at a time and none is ever
// locked. Files that are dropped anywhere are opened as on the Source page.
#pragma once

#include "app/gui/app_context.h"
#include "app/gui/page.h"
#include "engine/base/result.h"

#include <QMainWindow>

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

class QDockWidget;
class QScrollArea;
class QStackedWidget;
class QVBoxLayout;

namespace driftbench {

class CoachStrip;
class GuidedTour;
class Language;
class ShortcutOverview;
class SourcePage;
class SourceStatus;
class StartPage;
class StatusLine;
class StepRail;
class Workbench;

class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    // The context's workbench must be set; its actions are made here.
    MainWindow(AppContext &context, Language &language, QWidget *parent = nullptr);
    ~MainWindow() override;

    void showStep(Step step);
    void bringIntoView(QWidget &part); // of the page that is shown, where that scrolls
    void showStart();                  // what a newcomer sees first
    void startTour();                  // in a new session
    GuidedTour &tour() const { return *m_tour; }
    StartPage &startPage() const { return *m_start; }
    bool isAtStart() const;
    Step currentStep() const { return m_step; }
    Page *page(Step step) const { return m_pages[static_cast<std::size_t>(step)]; }
    StepRail &rail() const { return *m_rail; }
    StatusLine &statusLine() const { return *m_status; }
    QString sessionText() const; // of the corner

    void openFiles(const std::vector<std::filesystem::path> &files);
    // The session of the last time, or one that a crash left without a name.
    void restoreSession();

    // What to call after the first paint of the window, once.
    void onFirstPaint(std::function<void()> call) { m_onFirstPaint = std::move(call); }

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Menus;

    void buildCentre();
    void buildPages();
    void buildStart();
    void connectBench();

    // main_window_menus.cpp
    void buildMenus();
    void buildFileMenu();
    void buildEditMenu();
    void buildStepActions();
    void buildViewMenu();
    void buildThemeMenu();
    void buildLanguageMenu();
    void buildHelpMenu();
    void buildEventLog();
    void retranslate();
    void retranslateMenus();
    void showSaveAction();
    void showUndo();
    void showRecentMenu();
    void showSessionMenu();
    void showShortcuts();
    void showAbout();
    QAction *addWindowAction(const QKeySequence &keys, std::function<void()> slot);

    // main_window_session.cpp
    void newSession();
    void askOpen();
    void askSaveSession();
    void save();
    void undo(bool back);
    void showSession();
    void logEvents();
    void tell(const Status &outcome);
    bool mayClose();
    void restoreWindow();
    void saveWindow();

    void showStateOf(Step step);
    void showStatus();
    SourcePage &sourcePage() const;

    AppContext &m_context;
    Workbench &m_bench;
    Language &m_language;
    std::unique_ptr<Menus> m_menus;
    StepRail *m_rail;
    QStackedWidget *m_stack;
    QScrollArea *m_scroll;
    QVBoxLayout *m_places = nullptr; // the pages, and under them the tour
    StatusLine *m_status;
    SourceStatus *m_sourceStatus;
    TextLabel *m_corner;
    StartPage *m_start = nullptr;
    GuidedTour *m_tour = nullptr;
    CoachStrip *m_coach = nullptr;
    QDockWidget *m_eventDock = nullptr;
    ShortcutOverview *m_shortcuts = nullptr;
    std::array<Page *, kSteps.size()> m_pages{};
    Step m_step = Step::Source;
    std::function<void()> m_onFirstPaint;
};

} // namespace driftbench
