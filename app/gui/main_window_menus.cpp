#include "app/gui/main_window_menus.h"

#include "app/gui/event_log.h"
#include "app/gui/shortcut_overview.h"
#include "app/gui/step_rail.h"
#include "app/gui/workbench.h"
#include "app/language/language.h"
#include "widgets/controls/action_button.h"
#include "widgets/style/theme.h"
#include "widgets/tables/table_paint.h"

#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QFileInfo>
#include <QHeaderView>
#include <QMenuBar>
#include <QMessageBox>
#include <QTableView>
#include <QUndoStack>

namespace driftbench {

QAction *MainWindow::addWindowAction(const QKeySequence &keys, std::function<void()> slot)
{
    auto *action = new QAction(this);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, [slot = std::move(slot)] { slot(); });
    addAction(action);
    m_menus->everywhere.push_back(action);
    return action;
}

void MainWindow::buildMenus()
{
    Menus &m = *m_menus;
    for (QMenu **menu : {&m.file, &m.edit, &m.view, &m.session, &m.help})
        *menu = menuBar()->addMenu(QString());
    buildFileMenu();
    buildEditMenu();
    buildViewMenu();
    buildStepActions();
    buildHelpMenu();
    m_context.actions = {m.open, m.undo, m.redo};
}

void MainWindow::buildFileMenu()
{
    Menus &m = *m_menus;
    m.newSession = addWindowAction(QKeySequence::New, [this] { newSession(); });
    m.open = addWindowAction(QKeySequence::Open, [this] { askOpen(); });
    setActionIcon(*m.open, QStringLiteral("open"));
    m.save = addWindowAction(QKeySequence(Qt::CTRL | Qt::Key_S), [this] { save(); });
    m.saveAs = addWindowAction(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), [this] { askSaveSession(); });
    m.quit = addWindowAction(QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { close(); });
    m.quit->setMenuRole(QAction::QuitRole);
    m.file->addActions({m.newSession, m.open});
    m.recent = m.file->addMenu(QString());
    connect(m.recent, &QMenu::aboutToShow, this, &MainWindow::showRecentMenu);
    m.file->addSeparator();
    m.file->addActions({m.save, m.saveAs});
    m.file->addSeparator();
    m.file->addAction(m.quit);
}

void MainWindow::buildEditMenu()
{
    Menus &m = *m_menus;
    m.undo = addWindowAction(QKeySequence(Qt::CTRL | Qt::Key_Z), [this] { undo(true); });
    m.redo = addWindowAction(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), [this] { undo(false); });
    setActionIcon(*m.undo, QStringLiteral("undo"));
    setActionIcon(*m.redo, QStringLiteral("redo"));
    m.edit->addActions({m.undo, m.redo});
    m.edit->addSeparator();
    m.copyLog =
        addWindowAction({}, [this] { QApplication::clipboard()->setText(m_context.events.asText()); });
    m.edit->addAction(m.copyLog);
}

void MainWindow::buildStepActions()
{
    Menus &m = *m_menus;
    auto *group = new QActionGroup(this);
    for (const Step step : kSteps) {
        const int number = static_cast<int>(step) + 1;
        QAction *action = addWindowAction(QKeySequence(Qt::ALT | Qt::Key(Qt::Key_0 + number)),
                                          [this, step] { showStep(step); });
        action->setCheckable(true);
        group->addAction(action);
        m.steps[static_cast<std::size_t>(step)] = action;
    }
    connect(m.session, &QMenu::aboutToShow, this, &MainWindow::showSessionMenu);
}

// The steps, and what can be done on the page that is shown.
void MainWindow::showSessionMenu()
{
    QMenu *menu = m_menus->session;
    menu->clear();
    for (QAction *step : m_menus->steps)
        menu->addAction(step);
    if (page(m_step)->pageActions().empty())
        return;
    menu->addSeparator();
    for (QAction *action : page(m_step)->pageActions())
        menu->addAction(action);
}

void MainWindow::buildViewMenu()
{
    Menus &m = *m_menus;
    buildThemeMenu();
    buildLanguageMenu();
    m.view->addSeparator();
    m.fullScreen =
        addWindowAction(Qt::Key_F11, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    m.view->addAction(m.fullScreen);
}

void MainWindow::buildThemeMenu()
{
    Menus &m = *m_menus;
    m.theme = m.view->addMenu(QString());
    auto *group = new QActionGroup(this);
    const auto add = [&](ThemeMode mode, ThemeChoice kept) {
        QAction *action = addWindowAction({}, [this, mode, kept] {
            m_context.theme.setMode(mode);
            m_bench.changeSettings([kept](Settings &settings) { settings.theme = kept; });
        });
        action->setCheckable(true);
        action->setChecked(m_context.theme.mode() == mode);
        group->addAction(action);
        m.theme->addAction(action);
        return action;
    };
    m.themeSystem = add(ThemeMode::System, ThemeChoice::System);
    m.themeLight = add(ThemeMode::Light, ThemeChoice::Light);
    m.themeDark = add(ThemeMode::Dark, ThemeChoice::Dark);
}

void MainWindow::buildLanguageMenu()
{
    Menus &m = *m_menus;
    m.language = m.view->addMenu(QString());
    auto *group = new QActionGroup(this);
    const auto add = [&](const QString &code, const QString &name) {
        auto *action = new QAction(name, this);
        connect(action, &QAction::triggered, this, [this, code] {
            m_bench.changeSettings([&](Settings &settings) { settings.language = code; });
            m_language.set(code);
        });
        action->setCheckable(true);
        action->setChecked(m_language.code() == code);
        group->addAction(action);
        m.language->addAction(action);
        return action;
    };
    m.systemLanguage = add(QString(), QString());
    for (const QString &code : Language::available())
        add(code, Language::nativeName(code));
}

void MainWindow::buildHelpMenu()
{
    Menus &m = *m_menus;
    m.shortcuts = addWindowAction(Qt::Key_F1, [this] { showShortcuts(); });
    m.about = addWindowAction({}, [this] { showAbout(); });
    m.about->setMenuRole(QAction::AboutRole);
    m.aboutQt = addWindowAction({}, [] { QApplication::aboutQt(); });
    m.aboutQt->setMenuRole(QAction::AboutQtRole);
    m.start = addWindowAction({}, [this] { showStart(); });
    m.tour = addWindowAction({}, [this] { startTour(); });
    m.help->addActions({m.start, m.tour, m.shortcuts});
    m.help->addSeparator();
    m.help->addActions({m.about, m.aboutQt});
}

void MainWindow::buildEventLog()
{
    m_eventDock = new QDockWidget(this);
    m_eventDock->setObjectName(QStringLiteral("eventLog"));
    m_eventDock->setAllowedAreas(Qt::BottomDockWidgetArea | Qt::RightDockWidgetArea);
    auto *table = new QTableView(m_eventDock);
    dressTable(*table);
    table->setModel(&m_context.events);
    table->horizontalHeader()->setStretchLastSection(true);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_eventDock->setWidget(table);
    addDockWidget(Qt::BottomDockWidgetArea, m_eventDock);
    m_eventDock->hide();
    connect(&m_context.events, &QAbstractItemModel::rowsInserted, table, &QTableView::scrollToBottom);
    m_menus->eventLog = m_eventDock->toggleViewAction();
    m_menus->eventLog->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_L));
    addAction(m_menus->eventLog);
    m_menus->everywhere.push_back(m_menus->eventLog);
    m_menus->view->insertAction(m_menus->theme->menuAction(), m_menus->eventLog);
}

void MainWindow::retranslate()
{
    retranslateMenus();
    m_eventDock->setWindowTitle(tr("Event log"));
    m_eventDock->widget()->setAccessibleName(tr("Event log"));
    m_rail->setAccessibleName(tr("Steps"));
    m_rail->steps().retranslate();
    for (const Step step : kSteps)
        showStateOf(step);
    showSession();
    showSessionMenu();
    showUndo();
    showStatus();
    if (m_shortcuts)
        m_shortcuts->close();
}

void MainWindow::retranslateMenus()
{
    Menus &m = *m_menus;
    m.file->setTitle(tr("&File"));
    m.edit->setTitle(tr("&Edit"));
    m.view->setTitle(tr("&View"));
    m.session->setTitle(tr("&Session"));
    m.help->setTitle(tr("&Help"));
    m.newSession->setText(tr("&New session"));
    m.open->setText(tr("&Open files…"));
    m.recent->setTitle(tr("Open &recent"));
    m.saveAs->setText(tr("Save session &as…"));
    m.quit->setText(tr("&Quit"));
    m.copyLog->setText(tr("Copy the event log"));
    for (const Step step : kSteps)
        m.steps[static_cast<std::size_t>(step)]->setText(stepName(step));
    m.theme->setTitle(tr("&Colours"));
    m.themeSystem->setText(tr("As the &system"));
    m.themeLight->setText(tr("&Light"));
    m.themeDark->setText(tr("&Dark"));
    m.language->setTitle(tr("&Language"));
    m.systemLanguage->setText(tr("As the &system"));
    m.fullScreen->setText(tr("&Full screen"));
    m.eventLog->setText(tr("&Event log"));
    m.start->setText(tr("&Start page"));
    m.tour->setText(tr("&Guided tour"));
    m.shortcuts->setText(tr("&Keyboard shortcuts"));
    m.about->setText(tr("&About Driftbench"));
    m.aboutQt->setText(tr("About &Qt"));
}

void MainWindow::showRecentMenu()
{
    QMenu *menu = m_menus->recent;
    menu->clear();
    for (const QString &file : m_bench.settings().recentSessions + m_bench.settings().recentLogs) {
        QAction *action = menu->addAction(QFileInfo(file).fileName(), this, [this, file] {
            openFiles({std::filesystem::path(file.toStdString())});
        });
        action->setToolTip(file);
    }
    if (menu->isEmpty())
        menu->addAction(tr("No files yet"))->setEnabled(false);
}

void MainWindow::showSaveAction()
{
    const QAction *own = page(m_step)->saveAction();
    m_menus->save->setText(own                             ? own->text()
                           : m_bench.session().isUnnamed() ? tr("&Save session…")
                                                           : tr("&Save session"));
    m_menus->save->setEnabled(!own || own->isEnabled());
}

void MainWindow::showUndo()
{
    const QUndoStack *own = page(m_step)->undoStack();
    const PlanHistory &history = m_bench.session().history();
    const QString undoText = own ? own->undoText() : history.undoText();
    const QString redoText = own ? own->redoText() : history.redoText();
    m_menus->undo->setEnabled(own ? own->canUndo() : history.canUndo());
    m_menus->redo->setEnabled(own ? own->canRedo() : history.canRedo());
    m_menus->undo->setText(undoText.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(undoText));
    m_menus->redo->setText(redoText.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(redoText));
    // Buttons have no room for what it is that they take back.
    m_menus->undo->setIconText(tr("Undo"));
    m_menus->redo->setIconText(tr("Redo"));
}

void MainWindow::showShortcuts()
{
    delete m_shortcuts;
    m_shortcuts = new ShortcutOverview(this);
    std::vector<ShortcutGroup> groups;
    groups.push_back({tr("Everywhere"), {m_menus->everywhere.begin(), m_menus->everywhere.end()}, {}});
    for (const Step step : kSteps) {
        const auto &actions = page(step)->pageActions();
        groups.push_back({stepName(step), {actions.begin(), actions.end()}, {}});
    }
    groups.push_back(
        {tr("Plots"),
         {},
         {tr("Wheel|Zoom at the mouse; over an axis, that axis"), tr("Drag|Move"),
          tr("Shift+Drag|Zoom to a box"), tr("Double-click, F|Fit"), tr("Arrows|Move"), tr("+, −|Zoom"),
          tr("A, B|Set a cursor at the mouse"), tr("Ctrl+E|Export what is visible")}});
    m_shortcuts->setGroups(groups);
    m_shortcuts->show();
}

void MainWindow::showAbout()
{
    auto *box = new QMessageBox(this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->setWindowTitle(tr("About Driftbench"));
    box->setText(tr("Driftbench %1").arg(QApplication::applicationVersion()));
    box->setInformativeText(tr("Calibrates the temperature drift of MEMS gyros. Free software under the GNU "
                               "General Public License, version 3 or later."));
    box->show();
}

} // namespace driftbench
