// What every page is given: the session and the services of the window. All of it outlives the pages.
#pragma once

#include "app/gui/step.h"

#include <QObject>

class QAction;

namespace driftbench {

class EventLog;
class Theme;
class Workbench;

// Actions of the frame that pages show as buttons too. Their keys work on every page.
struct SharedActions
{
    QAction *openFiles = nullptr; // Ctrl+O
    QAction *undo = nullptr;      // Ctrl+Z
    QAction *redo = nullptr;      // Ctrl+Shift+Z
};

// The way from page to page.
class Navigator : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;
    void go(Step step) { emit stepRequested(step); }

signals:
    void stepRequested(Step step);
};

struct AppContext
{
    Theme &theme;
    EventLog &events;
    Navigator &navigator;
    Workbench *workbench = nullptr; // the session and the work on it; there as soon as pages are made
    SharedActions actions{};
};

} // namespace driftbench
