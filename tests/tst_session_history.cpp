// Undo and redo of plan edits, the plan and its companions as text, and the settings.
#include "app/session/export_choice.h"
#include "app/session/plan_history.h"
#include "app/session/session_source.h"
#include "app/session/settings.h"
#include "engine/base/random.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

using namespace driftbench;

class TestSessionHistory : public QObject
{
    Q_OBJECT

private slots:
    void edit_sequence_undoneAndRedoneGivesEachPlan();
    void edit_samePlan_leavesNoStep();
    void edit_afterUndo_dropsRedo();
    void edit_tooMany_forgetsTheOldest();
    void fitToRuns_runGone_stepsFollow();
    void fittedToRuns_newRun_takesPartAtItsRate();
    void plan_asText_comesBack();
    void plan_damagedText_isAnError();
    void exportChoice_asText_comesBack();
    void sourceChoice_asText_comesBack_data();
    void sourceChoice_asText_comesBack();
    void settings_stored_comeBack();
    void settings_damaged_areDefaults();
    void recent_files_areUniqueAndFew();
};

namespace {

RunRecord runNumber(RunId id, const Eigen::Vector3d &rateDps = Eigen::Vector3d::Zero())
{
    RunRecord run;
    run.id = id;
    run.description.name = "run " + std::to_string(id);
    run.description.referenceRateDps = rateDps;
    return run;
}

CalibrationPlan planOf(const std::vector<RunRecord> &runs)
{
    return fittedToRuns({}, runs);
}

CalibrationPlan changed(CalibrationPlan plan, Random &random)
{
    switch (random.below(6)) {
    case 0:
        plan.runs[random.below(plan.runs.size())].excluded.push_back(
            {{random.uniform(0.0, 10.0), random.uniform(10.0, 20.0)}, "moved"});
        break;
    case 1:
        plan.runs[random.below(plan.runs.size())].takesPart ^= true;
        break;
    case 2:
        plan.seed += 1;
        break;
    case 3:
        plan.limitRmsDps = random.uniform();
        break;
    case 4:
        plan.runs[random.below(plan.runs.size())].referenceRateDps[1] = random.normal();
        break;
    default:
        plan.rbf.largestNumberOfCentres += 1;
    }
    return plan;
}

} // namespace

void TestSessionHistory::edit_sequence_undoneAndRedoneGivesEachPlan()
{
    Random random(11);
    PlanHistory history(planOf({runNumber(1), runNumber(2), runNumber(3)}));
    std::vector<CalibrationPlan> plans{history.plan()};
    for (int i = 0; i < 60; ++i) {
        const CalibrationPlan next = changed(history.plan(), random);
        if (history.edit(next, QString::number(plans.size())))
            plans.push_back(next);
    }
    QVERIFY(plans.size() > 50);
    for (std::size_t i = plans.size() - 1; i > 0; --i) {
        QVERIFY(history.plan() == plans[i]);
        QCOMPARE(history.undoText(), QString::number(i));
        QVERIFY(history.undo());
    }
    QVERIFY(history.plan() == plans.front());
    QVERIFY(!history.undo());
    for (std::size_t i = 1; i < plans.size(); ++i) {
        QCOMPARE(history.redoText(), QString::number(i));
        QVERIFY(history.redo());
        QVERIFY(history.plan() == plans[i]);
    }
    QVERIFY(!history.canRedo());
}

void TestSessionHistory::edit_samePlan_leavesNoStep()
{
    PlanHistory history(planOf({runNumber(1)}));
    QVERIFY(!history.edit(history.plan(), "nothing"));
    QVERIFY(!history.canUndo());
    QVERIFY(history.undoText().isEmpty());
}

void TestSessionHistory::edit_afterUndo_dropsRedo()
{
    PlanHistory history;
    CalibrationPlan plan;
    plan.seed = 2;
    QVERIFY(history.edit(plan, "seed 2"));
    QVERIFY(history.undo());
    plan.seed = 3;
    QVERIFY(history.edit(plan, "seed 3"));
    QVERIFY(!history.canRedo());
    QVERIFY(history.undo());
    QCOMPARE(history.plan().seed, 1u);
}

void TestSessionHistory::edit_tooMany_forgetsTheOldest()
{
    PlanHistory history;
    CalibrationPlan plan;
    for (std::size_t i = 0; i < PlanHistory::kMostSteps + 10; ++i) {
        plan.seed += 1;
        QVERIFY(history.edit(plan, "seed"));
    }
    std::size_t undone = 0;
    while (history.undo())
        ++undone;
    QCOMPARE(undone, PlanHistory::kMostSteps);
    QCOMPARE(history.plan().seed, 11u);
}

void TestSessionHistory::fitToRuns_runGone_stepsFollow()
{
    PlanHistory history(planOf({runNumber(1), runNumber(2)}));
    CalibrationPlan plan = history.plan();
    plan.runs[1].takesPart = false;
    QVERIFY(history.edit(plan, "leave out run 2"));
    plan.seed = 9;
    QVERIFY(history.edit(plan, "seed"));
    history.fitToRuns({runNumber(1)});
    QCOMPARE(history.plan().runs.size(), std::size_t(1));
    QCOMPARE(history.undoText(), QString("seed"));
    QVERIFY(history.undo());
    QCOMPARE(history.plan().seed, 1u);
    QVERIFY2(!history.canUndo(), "leaving out a run that is gone is no step");
}

void TestSessionHistory::fittedToRuns_newRun_takesPartAtItsRate()
{
    CalibrationPlan plan = planOf({runNumber(4)});
    plan.runs[0].referenceRateDps = {9.0, 9.0, 9.0};
    plan.holdOut = {4, 77};
    plan = fittedToRuns(plan, {runNumber(3, {25.0, 5.0, 53.0}), runNumber(4)});
    QCOMPARE(plan.runs.size(), std::size_t(2));
    QVERIFY(plan.runs[0].takesPart);
    QCOMPARE(plan.runs[0].referenceRateDps, Eigen::Vector3d(25.0, 5.0, 53.0));
    QCOMPARE(plan.runs[1].referenceRateDps, Eigen::Vector3d(9.0, 9.0, 9.0));
    QCOMPARE(plan.holdOut, std::vector<RunId>{4});
}

void TestSessionHistory::plan_asText_comesBack()
{
    CalibrationPlan plan = planOf({runNumber(1), runNumber(2)});
    plan.runs[1].takesPart = false;
    plan.referenceFromHold = true;
    plan.referenceTemperatureC = -39.87654321;
    plan.quality.maskBadRows = true;
    plan.quality.allowShort = true;
    plan.models = {"linear", "rbf"};
    plan.holdOut = {2};
    plan.rbf.ridge = 0.1;
    plan.rbf.centres = 7;
    plan.bp.hiddenUnits = 4;
    plan.seed = 18446744073709551615u;
    plan.judging = Judging::Anchored;
    plan.limitRmsDps = 0.2;
    const auto back = calibrationPlanFromJson(calibrationPlanToJson(plan));
    QVERIFY(back);
    QVERIFY(*back == plan);
}

void TestSessionHistory::plan_damagedText_isAnError()
{
    for (const char *text : {"", "{", "[]", "{\"runs\": 3}"}) {
        const auto plan = calibrationPlanFromJson(text);
        QVERIFY(!plan);
        QCOMPARE(plan.error().code, Errc::SessionDamaged);
    }
}

void TestSessionHistory::exportChoice_asText_comesBack()
{
    ExportChoice choice;
    choice.model = "rbf";
    choice.options.axes = std::array<bool, 3>{true, false, true};
    choice.options.gyro = 2;
    choice.options.table.maxInterpolationErrorDps = 0.005;
    choice.formats = {ExportFormat::Px4};
    choice.deviceTable = DeviceTableKind::Float;
    const auto back = exportChoiceFromJson(exportChoiceToJson(choice));
    QVERIFY(back);
    QCOMPARE(exportChoiceToJson(*back), exportChoiceToJson(choice));
    QVERIFY(back->options.axes == choice.options.axes);
    QCOMPARE(exportChoiceFromJson("{}").error().code, Errc::SessionDamaged);
}

void TestSessionHistory::sourceChoice_asText_comesBack_data()
{
    QTest::addColumn<QString>("text");
    for (const char *text : {"simulated", "simulated:L3GD20H:A7", "hid", "hid:SIM-0001",
                             "i2c:mcp2221a/l3gd20h+tmp117", "file:/tmp/a run.csv*20"})
        QTest::newRow(text) << text;
}

void TestSessionHistory::sourceChoice_asText_comesBack()
{
    QFETCH(QString, text);
    auto choice = parseSourceChoice(text.toStdString());
    QVERIFY2(choice, choice ? "" : choice.error().message.c_str());
    choice->rateHz = 100.0;
    choice->compensate = true;
    choice->thermometer = ThermometerChoice::Die;
    if (auto *simulated = choice->as<SimulatedChoice>()) {
        simulated->seed = 42;
        simulated->spread = 0.01;
        simulated->profile =
            *TemperatureProfile::build("own", -10.0, {HoldSegment{60.0}, RampSegment{20.0, 0.7, 5.0}});
    }
    if (auto *native = choice->as<NativeChoice>())
        native->ids = {{0x1209, 0x0001}, {0x04d8, 0xf000}};
    if (auto *i2c = choice->as<I2cChoice>())
        i2c->dieOffsetC = 31.5;
    if (auto *file = choice->as<FileChoice>())
        file->read.csv.rateUnit = rateUnitNamed("rad/s");
    const auto back = sourceChoiceFromJson(sourceChoiceToJson(*choice));
    QVERIFY2(back, back ? "" : back.error().message.c_str());
    QCOMPARE(sourceChoiceToJson(*back), sourceChoiceToJson(*choice));
    if (const auto *simulated = back->as<SimulatedChoice>()) {
        QCOMPARE(simulated->seed, 42u);
        QVERIFY(simulated->profile);
        const TemperatureProfile &before = *choice->as<SimulatedChoice>()->profile;
        QCOMPARE(simulated->profile->durationS(), before.durationS());
        for (double timeS = 1.0; timeS < before.durationS(); timeS += 2.5)
            QCOMPARE(simulated->profile->setpointC(timeS), before.setpointC(timeS));
    }
}

void TestSessionHistory::settings_stored_comeBack()
{
    QTemporaryDir folder;
    const QString file = folder.filePath("settings.ini");
    Settings settings;
    settings.theme = ThemeChoice::Dark;
    settings.language = "zh";
    addRecent(settings.recentSessions, "/a/b.driftbench");
    settings.lastFolder = "/a";
    settings.bridgeIds = QStringList{"1209:0001"};
    settings.chartHistoryS = 12.5;
    settings.windowGeometry = QByteArray("\0\1\2\xff", 4);
    settings.splitters["train"] = QByteArray("\x80", 1);
    {
        QSettings store(file, QSettings::IniFormat);
        saveSettings(settings, store);
    }
    const QSettings store(file, QSettings::IniFormat);
    QVERIFY(loadSettings(store) == settings);
}

void TestSessionHistory::settings_damaged_areDefaults()
{
    QTemporaryDir folder;
    QSettings store(folder.filePath("settings.ini"), QSettings::IniFormat);
    store.setValue("theme", "purple");
    store.setValue("source/history_s", "-3");
    QVERIFY(loadSettings(store) == Settings());
}

void TestSessionHistory::recent_files_areUniqueAndFew()
{
    QStringList recent;
    for (int i = 0; i < 30; ++i)
        addRecent(recent, "/f" + QString::number(i % 20));
    QCOMPARE(recent.size(), static_cast<qsizetype>(Settings::kMostRecent));
    QCOMPARE(recent.front(), QString("/f9"));
    addRecent(recent, "/f5");
    QCOMPARE(recent.front(), QString("/f5"));
    QCOMPARE(recent.count("/f5"), 1);
}

QTEST_APPLESS_MAIN(TestSessionHistory)
#include "tst_session_history.moc"
