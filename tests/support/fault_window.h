// The whole window for tests of what goes wrong in it: runs that are quick to train on, the simulated bridge
// as source, and the question that follows every fault: is it still usable?
#pragma once

#include "support/gui_window.h"
#include "support/session_runs.h"
#include "support/short_plan.h"

#include <QAction>
#include <QSignalSpy>

namespace driftbench::test {

inline constexpr int kPatienceMs = 60'000;

inline void addStepRows()
{
    static constexpr const char *kNames[] = {"source", "plan",    "record", "inspect",
                                             "train",  "compare", "export"};
    QTest::addColumn<int>("step");
    for (const Step step : kSteps)
        QTest::newRow(kNames[int(step)]) << int(step);
}

class FaultyWindow : public GuiWindow
{
public:
    explicit FaultyWindow(int runs, HidAccess devices = noDevices(), bool watch = false)
        : GuiWindow({}, std::move(devices), watch)
    {
        if (!watch)
            chooseSimulated(20.0);
        if (!session().setTestPlan(shortPlan()))
            qFatal("no plan");
        if (runs > 0)
            addRuns(session(), runs);
        setModels({"constant", "linear", "cubic"});
    }
    ~FaultyWindow() { bench->stopSource(); }

    Session &session() const { return bench->session(); }
    template <class P>
    P &page(Step step)
    {
        return static_cast<P &>(*main().page(step));
    }

    void chooseSimulated(double speed)
    {
        SimulatedChoice simulated;
        simulated.speed = speed;
        simulated.sensor = "L3GD20H";
        simulated.serial = "T-1";
        bench->setSourceChoice({simulated});
    }
    void setModels(const std::vector<std::string> &models)
    {
        CalibrationPlan plan = session().plan();
        plan.models = models;
        if (!session().editPlan(plan, QStringLiteral("models")))
            qFatal("no models");
    }

    // The line, on every axis, whatever is said of it: a table that is quick to make.
    bool exportLine()
    {
        ExportChoice choice = session().exportChoice();
        choice.model = "linear";
        choice.options.force = true;
        return session().setExportChoice(choice).ok();
    }

    bool idle() const { return !bench->training().isRunning(); }
    // To its end; false, with a warning, if it is refused.
    bool train()
    {
        QSignalSpy problems(bench.get(), &Workbench::problem);
        if (!QTest::qWaitFor([this] { return idle(); }, kPatienceMs) || !bench->train().ok())
            return false;
        const auto over = [&] { return idle() && (session().result() || !problems.isEmpty()); };
        const bool trained = QTest::qWaitFor(over, kPatienceMs) && session().result();
        if (!problems.isEmpty())
            qWarning("%s", problems.front().front().value<Error>().message.c_str());
        return trained;
    }

    // Nothing in the way, every step comes by its key, and the one that was shown is shown again.
    void expectUsable()
    {
        const Step before = main().currentStep();
        QVERIFY(QApplication::activeModalWidget() == nullptr);
        QVERIFY(main().isEnabled() && main().isVisible());
        for (int i = 0; i <= int(kSteps.size()); ++i) {
            const Step step = i < int(kSteps.size()) ? kSteps[std::size_t(i)] : before;
            QTest::keyClick(&main(), Qt::Key(Qt::Key_1 + int(step)), Qt::AltModifier);
            QCOMPARE(main().currentStep(), step);
            QVERIFY(main().page(step)->isVisible() && main().page(step)->isEnabled());
            QVERIFY(!main().page(step)->hints().isEmpty());
        }
    }
};

} // namespace driftbench::test
