// A workbench in a folder of its own, without devices, and a page on it, as the window would make them.
#pragma once

#include "app/gui/app_context.h"
#include "app/gui/event_log.h"
#include "app/gui/workbench.h"
#include "widgets/style/theme.h"

#include <QAction>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>

namespace driftbench::test {

class PageBench
{
public:
    PageBench()
    {
        WorkbenchOptions options;
        options.sessionFolder = m_folder.path().toStdString();
        options.watchDevices = false;
        auto made = Workbench::create(options);
        if (!made.ok())
            qFatal("%s", made.error().message.c_str());
        workbench = *std::move(made);
        context.workbench = workbench.get();
        context.actions.openFiles = &m_open;
        context.actions.undo = &m_undo;
        context.actions.redo = &m_redo;
        QObject::connect(&m_undo, &QAction::triggered, workbench.get(),
                         [this] { (void)workbench->session().undo(); });
        QObject::connect(&m_redo, &QAction::triggered, workbench.get(),
                         [this] { (void)workbench->session().redo(); });
    }

    // As a run of the session that is open; its id.
    RunId importRun(const Recording &recording, const std::string &name)
    {
        auto file = workbench->session().anotherFile();
        if (!file.ok())
            qFatal("%s", file.error().message.c_str());
        const auto run = (*file)->importRun(recording, describeRecording(recording.info, name));
        if (!run.ok())
            qFatal("%s", run.error().message.c_str());
        if (!workbench->session().refreshRuns().ok())
            qFatal("the runs can't be read");
        return *run;
    }

    template <class P>
    std::unique_ptr<P> page(QSize size = {1096, 672})
    {
        auto made = std::make_unique<P>(context);
        made->initialise();
        made->resize(size);
        made->show();
        made->entered();
        return made;
    }

    Theme theme;
    EventLog events;
    Navigator navigator;
    AppContext context{theme, events, navigator};
    std::unique_ptr<Workbench> workbench;

private:
    QTemporaryDir m_folder;
    QAction m_open, m_undo, m_redo;
};

// 1 Hz, up from 0 to 40 degrees and down again, half an hour each; x reads hysteresisDps more on the way
// down.
inline Recording upAndDown(double hysteresisDps, double spanC = 40.0)
{
    constexpr Eigen::Index kHalf = 1800;
    Recording recording;
    recording.timeS = Eigen::VectorXd::LinSpaced(2 * kHalf, 0.0, 2.0 * kHalf - 1.0);
    recording.temperatureC.resize(2 * kHalf);
    recording.rateDps.resize(2 * kHalf, 3);
    Random random(77);
    for (Eigen::Index i = 0; i < 2 * kHalf; ++i) {
        const double up = i < kHalf ? double(i) / kHalf : double(2 * kHalf - i) / kHalf;
        const double temperature = spanC * up;
        recording.temperatureC[i] = temperature + 0.01 * random.normal();
        const double hysteresis = i < kHalf ? 0.0 : hysteresisDps * std::sin(3.14159265 * up);
        recording.rateDps(i, 0) = 0.02 * temperature + hysteresis + 0.01 * random.normal();
        recording.rateDps(i, 1) = 0.05 * temperature + 0.01 * random.normal();
        recording.rateDps(i, 2) = -0.01 * temperature + 0.01 * random.normal();
    }
    recording.info.source = "updown.csv";
    recording.info.format = "csv";
    return recording;
}

} // namespace driftbench::test
