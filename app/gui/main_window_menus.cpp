#include "app/gui/main_window_menus.h"

#include "app/gui/event_log.h"
#include "app/gui/shortcut_overview.h"
#include "app/gui/step_rail.h"
#include "widgets/controls/action_button.h"
#include "widgets/style/theme.h"

#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QTableView>

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
    QMenuBar *bar = menuBar();
    for (QMenu **menu : {&m.file, &m.edit, &m.view, &m.session, &m.help})
        *menu = bar->addMenu(QString());

    m.save = addWindowAction(QKeySequence::Save, [this] {
        if (QAction *own = page(m_step)->saveAction())
            own->trigger();
    });
    m.quit = addWindowAction(QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { close(); });
    m.quit->setMenuRole(QAction::QuitRole);
    m.file->addActions({m.save});
    m.file->addSeparator();
    m.file->addAction(m.quit);

    buildStepActions();
    buildViewMenu();

    m.shortcuts = addWindowAction(Qt::Key_F1, [this] { showShortcuts(); });
    m.about = addWindowAction({}, [this] { showAbout(); });
    m.about->setMenuRole(QAction::AboutRole);
    m.aboutQt = addWindowAction({}, [] { QApplication::aboutQt(); });
    m.aboutQt->setMenuRole(QAction::AboutQtRole);
    m.help->addAction(m.shortcuts);
    m.help->addSeparator();
    m.help->addActions({m.about, m.aboutQt});
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
    showSessionMenu();
}

// The steps, and what can be done on the page that is shown.
void MainWindow::showSessionMenu()
{
    QMenu *menu = m_menus->session;
    menu->clear();
    for (QAction *step : m_menus->steps)
        menu->addAction(step);
    if (!page(m_step) || page(m_step)->pageActions().empty())
        return;
    menu->addSeparator();
    for (QAction *action : page(m_step)->pageActions())
        menu->addAction(action);
}

void MainWindow::buildViewMenu()
{
    Menus &m = *m_menus;
    m.theme = m.view->addMenu(QString());
    auto *group = new QActionGroup(this);
    const auto add = [&](ThemeMode mode) {
        QAction *action = addWindowAction({}, [this, mode] { m_context.theme.setMode(mode); });
        action->setCheckable(true);
        action->setChecked(m_context.theme.mode() == mode);
        group->addAction(action);
        m.theme->addAction(action);
        return action;
    };
    m.themeSystem = add(ThemeMode::System);
    m.themeLight = add(ThemeMode::Light);
    m.themeDark = add(ThemeMode::Dark);
    m.fullScreen =
        addWindowAction(Qt::Key_F11, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    m.view->addSeparator();
    m.view->addAction(m.fullScreen);
}

void MainWindow::buildEventLog()
{
    m_eventDock = new QDockWidget(this);
    m_eventDock->setObjectName(QStringLiteral("eventLog"));
    m_eventDock->setAllowedAreas(Qt::BottomDockWidgetArea | Qt::RightDockWidgetArea);
    auto *table = new QTableView(m_eventDock);
    table->setModel(&m_context.events);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(24);
    table->horizontalHeader()->setStretchLastSection(true);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setShowGrid(false);
    table->setFrameShape(QFrame::NoFrame);
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
    Menus &m = *m_menus;
    m.file->setTitle(tr("&File"));
    m.edit->setTitle(tr("&Edit"));
    m.view->setTitle(tr("&View"));
    m.session->setTitle(tr("&Session"));
    m.help->setTitle(tr("&Help"));
    m.quit->setText(tr("&Quit"));
    for (const Step step : kSteps)
        m.steps[static_cast<std::size_t>(step)]->setText(stepName(step));
    m.theme->setTitle(tr("&Colours"));
    m.themeSystem->setText(tr("As the &system"));
    m.themeLight->setText(tr("&Light"));
    m.themeDark->setText(tr("&Dark"));
    m.fullScreen->setText(tr("&Full screen"));
    m.eventLog->setText(tr("&Event log"));
    m.shortcuts->setText(tr("&Keyboard shortcuts"));
    m.about->setText(tr("&About Driftbench"));
    m.aboutQt->setText(tr("About &Qt"));
    m_eventDock->setWindowTitle(tr("Event log"));
    setWindowTitle(tr("Driftbench"));
    m_rail->steps().retranslate();
    for (const Step step : kSteps)
        showStateOf(step);
    showStatus();
    if (m_shortcuts)
        m_shortcuts->close();
}

void MainWindow::showSaveAction()
{
    const QAction *own = page(m_step)->saveAction();
    m_menus->save->setText(own ? own->text() : tr("&Save"));
    m_menus->save->setEnabled(own && own->isEnabled());
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
    box->setInformativeText(
        tr("Calibrates the temperature drift of MEMS gyros. Free software under the GNU General "
           "Public License, version 3 or later."));
    box->show();
}

} // namespace driftbench
