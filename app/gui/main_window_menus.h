// The menus of the main window and their actions, made in main_window_menus.cpp.
#pragma once

#include "app/gui/main_window.h"

#include <QAction>
#include <QMenu>

#include <array>
#include <vector>

namespace driftbench {

struct MainWindow::Menus
{
    QMenu *file = nullptr, *edit = nullptr, *view = nullptr, *session = nullptr, *help = nullptr;
    QMenu *recent = nullptr, *theme = nullptr, *language = nullptr;

    QAction *newSession = nullptr, *open = nullptr, *save = nullptr, *saveAs = nullptr, *quit = nullptr;
    QAction *undo = nullptr, *redo = nullptr;
    QAction *eventLog = nullptr, *copyLog = nullptr, *fullScreen = nullptr;
    QAction *themeSystem = nullptr, *themeLight = nullptr, *themeDark = nullptr;
    QAction *systemLanguage = nullptr;
    QAction *tour = nullptr, *start = nullptr;
    QAction *shortcuts = nullptr, *about = nullptr, *aboutQt = nullptr;
    std::array<QAction *, kSteps.size()> steps{};

    std::vector<QAction *> everywhere; // for the overview of shortcuts
};

} // namespace driftbench
