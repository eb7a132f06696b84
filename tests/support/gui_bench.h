// A workbench in a folder of its own, for tests of pages: no device is looked for.
#pragma once

#include "app/gui/app_context.h"
#include "app/gui/event_log.h"
#include "app/gui/page.h"
#include "app/gui/workbench.h"
#include "support/session_runs.h"
#include "widgets/style/theme.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace driftbench::test {

inline constexpr int kTrainingPatienceMs = 120000;

struct GuiBench
{
    QTemporaryDir folder;
    Theme theme;
    EventLog events;
    Navigator navigator;
    std::unique_ptr<Workbench> workbench;
    std::unique_ptr<AppContext> context;

    explicit GuiBench(int runs)
    {
        WorkbenchOptions options;
        options.sessionFolder = folder.path().toStdString();
        options.watchDevices = false;
        auto made = Workbench::create(std::move(options));
        if (!made)
            qFatal("%s", made.error().message.c_str());
        workbench = *std::move(made);
        context = std::make_unique<AppContext>(AppContext{theme, events, navigator, workbench.get()});
        if (runs > 0)
            addRuns(workbench->session(), runs);
    }

    Session &session() const { return workbench->session(); }

    void setModels(const std::vector<std::string> &models) const
    {
        CalibrationPlan plan = session().plan();
        plan.models = models;
        if (!session().editPlan(plan, QStringLiteral("models")))
            qFatal("edit");
    }

    // To its end; false if there is no result then.
    bool train() const
    {
        if (!workbench->train())
            return false;
        return QTest::qWaitFor([this] { return !workbench->training().isRunning(); }, kTrainingPatienceMs) &&
               session().result() != nullptr;
    }
};

// Shows the page alone at the size that it has in the smallest window.
inline void showPage(Page &page)
{
    page.resize(1096, 648);
    page.show();
    page.initialise();
    page.entered();
}

} // namespace driftbench::test
