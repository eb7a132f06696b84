// The Plan page against the figures of the paper and of the engine.
#include "support/gui_window.h"

#include "app/gui/plan/control_panels.h"
#include "engine/physics/control_figures.h"
#include "engine/physics/plan_file.h"
#include "widgets/controls/duration_field.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/readout_grid.h"
#include "widgets/views/profile_view.h"
#include "widgets/views/transient_view.h"

#include <QFile>
#include <QTest>
#include <QUndoStack>

using namespace driftbench;
using namespace driftbench::test;

class TestGuiPlan : public QObject
{
    Q_OBJECT

private slots:
    void figures_ofThePaper_areShown();
    void fields_edited_changeThePlan();
    void plan_wrongRange_isRefusedAtTheField();
    void stillAir_slowerThanTheStep_isSaid();
    void plan_used_becomesTheSessions();
    void plan_savedAndOpened_isTheSame();
    void controller_files_areTheEngines();
    void duration_anySpelling_isRead();
};

namespace {

struct PlanWindow : GuiWindow
{
    PlanWindow() { main().showStep(Step::Plan); }
    PlanPage &page() { return static_cast<PlanPage &>(*main().page(Step::Plan)); }
    template <class Field>
    Field &field(const QString &name)
    {
        for (Field *found : page().findChildren<Field *>()) {
            if (found->accessibleName() == name)
                return *found;
        }
        qFatal("no field %s", qPrintable(name));
    }
};

} // namespace

void TestGuiPlan::figures_ofThePaper_areShown()
{
    PlanWindow window;
    // Sections 2.2.1 and 4.1 of the paper: 8.75 mdps, 4.90 mdps/C, 10.9375 mdps/C, 0.5525 C, 25.766 s.
    const ReadoutGrid &interval = window.page().interval().figures();
    QCOMPARE(interval.value(0), QString("8.75 mdps"));
    QCOMPARE(interval.value(1), QString("4.90 mdps/°C"));
    QCOMPARE(interval.value(2), QString("10.94 mdps/°C"));
    const ReadoutGrid &period = window.page().period().figures();
    QCOMPARE(period.value(0), QString("25.766 s"));
    QCOMPARE(period.value(1), QString("25\u2009766 s; 6\u2009115 s"));
    QCOMPARE(period.value(2), QString("592 s"));
    QCOMPARE(window.page().plan().samplesPerRun(), 111000);
    QVERIFY(!window.page().profile().isEmpty());
    QVERIFY(!window.page().period().transient().isEmpty());
}

void TestGuiPlan::fields_edited_changeThePlan()
{
    PlanWindow window;
    window.field<NumberField>("Step").setValue(2.0);
    QCOMPARE(window.page().plan().stepC, 2.0);
    window.field<NumberField>("Highest temperature").setValue(60.0);
    QCOMPARE(window.page().plan().highestC, 60.0);
    window.field<DurationField>("Hold at the ends").setValueS(600.0);
    QCOMPARE(window.page().plan().holdS, 600.0);
    const auto interval = controlInterval(window.page().plan().sensor, -40.0, 60.0);
    QCOMPARE(window.page().interval().figures().value(2),
             QString("%1 mdps/°C").arg(interval->sensitivityMdpsPerC, 0, 'f', 2));
    window.page().undoStack()->undo();
    QCOMPARE(window.page().plan().holdS, 1800.0);
    QCOMPARE(window.field<DurationField>("Hold at the ends").valueS(), 1800.0);
}

void TestGuiPlan::plan_wrongRange_isRefusedAtTheField()
{
    PlanWindow window;
    NumberField &lowest = window.field<NumberField>("Lowest temperature");
    lowest.setValue(90.0);
    QVERIFY(lowest.property("invalid").toBool());
    QVERIFY(!lowest.accessibleDescription().isEmpty());
    QVERIFY(window.page().profile().isEmpty());
    QTest::keyClick(&window.page(), Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(window.main().currentStep(), Step::Plan);
    QVERIFY(!window.bench->session().testPlan());
    lowest.setValue(-40.0);
    QVERIFY(!lowest.property("invalid").toBool());
}

void TestGuiPlan::stillAir_slowerThanTheStep_isSaid()
{
    PlanWindow window;
    QVERIFY(window.page().banners().holds("stillAir"));
    QVERIFY(window.page().banners().banner().content().what.contains("35 min"));
    window.field<NumberField>("Every").setValue(7200.0);
    QVERIFY(!window.page().banners().holds("stillAir"));
}

void TestGuiPlan::plan_used_becomesTheSessions()
{
    PlanWindow window;
    window.field<NumberField>("Runs").setValue(3.0);
    QTest::keyClick(&window.page(), Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(window.main().currentStep(), Step::Record);
    QVERIFY(window.bench->session().testPlan().has_value());
    QCOMPARE(window.bench->session().testPlan()->runs, 3);
}

void TestGuiPlan::plan_savedAndOpened_isTheSame()
{
    PlanWindow window;
    window.field<NumberField>("Step").setValue(1.25);
    const auto file = window.folder() / "plan.json";
    QVERIFY(window.page().savePlan(file).ok());
    window.field<NumberField>("Step").setValue(0.5);
    QVERIFY(window.page().openPlan(file).ok());
    QCOMPARE(window.page().plan().stepC, 1.25);
    QCOMPARE(planToJson(window.page().plan()), planToJson(*readPlan(file)));
    QVERIFY(!window.page().openPlan(window.folder() / "none.json").ok());
}

void TestGuiPlan::controller_files_areTheEngines()
{
    PlanWindow window;
    for (const bool ramps : {false, true}) {
        const auto file = window.folder() / "controller.csv";
        QVERIFY(window.page().saveControllerFile(file, ramps).ok());
        QFile written(QString::fromStdString(file.string()));
        QVERIFY(written.open(QIODevice::ReadOnly));
        const TestPlan plan = window.page().plan();
        QCOMPARE(written.readAll().toStdString(), ramps ? planSegmentsToCsv(plan) : planStepsToCsv(plan));
    }
}

void TestGuiPlan::duration_anySpelling_isRead()
{
    DurationField field("length", 0.0, 100000.0, 60.0);
    const std::pair<const char *, double> spellings[] = {
        {"1:30", 5400.0}, {"0:00:45", 45.0}, {"1800 s", 1800.0}, {"90", 90.0}};
    for (const auto &[text, seconds] : spellings) {
        field.clear();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(field.valueS(), seconds);
    }
    QCOMPARE(durationText(11100.0), QString("3:05:00"));
}

QTEST_MAIN(TestGuiPlan)
#include "tst_gui_plan.moc"
