// What can go wrong in the middle of each step: the bridge is unplugged, the disk is full, a training is
// cancelled. Each time the window must stay usable, say what is the matter, and work again afterwards.
#include "support/gui_window.h"

#include "app/gui/pages/compare_page.h"
#include "app/gui/start/guided_tour.h"
#include "device/simulated_board.h"
#include "support/fault_vfs.h"
#include "support/session_runs.h"

#include <QAction>
#include <QSignalSpy>

#include <csignal>
#include <sys/resource.h>

using namespace driftbench;
using namespace driftbench::test;

class TestGuiFaults : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanup() { clearFaults(); }
    void unplugged_onEachStep_windowStaysUsable_data() { addSteps(); }
    void unplugged_onEachStep_windowStaysUsable();
    void diskFull_onEachStep_isSaidAndSavedLater_data() { addSteps(); }
    void diskFull_onEachStep_isSaidAndSavedLater();
    void diskFull_forTheReport_leavesNoHalfReport();
    void cancelledTraining_onEachStep_windowStaysUsable_data() { addSteps(); }
    void cancelledTraining_onEachStep_windowStaysUsable();
    void tour_trainingCancelled_doesNotHang();

private:
    static void addSteps();
};

namespace {

constexpr int kPatienceMs = 60'000;
const char *const kStepNames[] = {"source", "plan", "record", "inspect", "train", "compare", "export"};

TestPlan shortPlan()
{
    TestPlan plan;
    plan.sensor = *namedSensor("I3G4250D");
    plan.chamber = *namedChamber("SET-Z-021");
    plan.lowestC = 20.0;
    plan.highestC = 32.0;
    plan.stepC = 0.5;
    plan.periodS = 5.0;
    plan.holdS = 60.0;
    plan.runs = 2;
    return plan;
}

// A window over the simulated bridge, with runs and a result if they are asked for.
class FaultyWindow : public GuiWindow
{
public:
    explicit FaultyWindow(int runs) : GuiWindow({}, noDevices(), false)
    {
        SimulatedChoice simulated;
        simulated.speed = 20.0;
        simulated.sensor = "L3GD20H";
        simulated.serial = "T-1";
        bench->setSourceChoice({simulated});
        if (!bench->session().setTestPlan(shortPlan()))
            qFatal("no plan");
        if (runs > 0)
            addRuns(bench->session(), runs);
        CalibrationPlan plan = bench->session().plan();
        plan.models = {"constant", "linear", "cubic"};
        if (!bench->session().editPlan(plan, QStringLiteral("models")))
            qFatal("no models");
    }
    ~FaultyWindow() { bench->stopSource(); }

    Session &session() const { return bench->session(); }
    bool idle() const { return !bench->training().isRunning(); }
    bool train()
    {
        return QTest::qWaitFor([this] { return idle(); }, kPatienceMs) && bench->train().ok() &&
               QTest::qWaitFor([this] { return idle() && session().result(); }, kPatienceMs);
    }

    // Nothing in the way, and every step comes by its key.
    void expectUsable()
    {
        QVERIFY(QApplication::activeModalWidget() == nullptr);
        QVERIFY(main().isEnabled() && main().isVisible());
        for (const Step step : kSteps) {
            QTest::keyClick(&main(), Qt::Key(Qt::Key_1 + int(step)), Qt::AltModifier);
            QCOMPARE(main().currentStep(), step);
            QVERIFY(main().page(step)->isVisible() && main().page(step)->isEnabled());
            QVERIFY(!main().page(step)->hints().isEmpty());
        }
    }
};

} // namespace

void TestGuiFaults::initTestCase()
{
    registerFaultVfs(true);
}

void TestGuiFaults::addSteps()
{
    QTest::addColumn<int>("step");
    for (const Step step : kSteps)
        QTest::newRow(kStepNames[int(step)]) << int(step);
}

void TestGuiFaults::unplugged_onEachStep_windowStaysUsable()
{
    QFETCH(int, step);
    FaultyWindow window(1);
    QVERIFY(window.bench->startSource(SourceUse::Watch));
    QTRY_VERIFY_WITH_TIMEOUT(window.bench->simulatedBoard() != nullptr, kPatienceMs);
    window.main().showStep(static_cast<Step>(step));
    QTRY_VERIFY_WITH_TIMEOUT(window.bench->simulatedBoard() != nullptr, kPatienceMs);
    QSignalSpy said(&window.bench->acquisition(), &Acquisition::sourceSaid);
    window.bench->simulatedBoard()->unplug();
    QTRY_VERIFY_WITH_TIMEOUT(!said.isEmpty(), kPatienceMs);
    QVERIFY(said.first().first().toString().contains(QStringLiteral("unplugged")));
    window.expectUsable();
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    // And again with a bridge that is there.
    window.bench->stopSource();
    QTRY_COMPARE_WITH_TIMEOUT(window.bench->acquisition().state(), Acquisition::State::Idle, kPatienceMs);
    QSignalSpy samples(&window.bench->acquisition(), &Acquisition::batch);
    QVERIFY(window.bench->startSource(SourceUse::Watch));
    QTRY_VERIFY_WITH_TIMEOUT(!samples.isEmpty(), kPatienceMs);
}

void TestGuiFaults::diskFull_onEachStep_isSaidAndSavedLater()
{
    QFETCH(int, step);
    FaultyWindow window(2);
    QVERIFY(window.train());
    window.main().showStep(static_cast<Step>(step));
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    QVERIFY(window.session().isSaved());
    QSignalSpy problems(window.bench.get(), &Workbench::problem);
    injectFault(Fault::DiskFull, 1, true);
    // What each step writes into the session.
    CalibrationPlan plan = window.session().plan();
    switch (static_cast<Step>(step)) {
    case Step::Source:
        (void)window.bench->useSource().ok();
        break;
    case Step::Plan: {
        TestPlan test = shortPlan();
        test.runs = 3;
        (void)window.session().setTestPlan(test).ok();
        break;
    }
    case Step::Inspect:
        plan.runs.front().excluded.push_back({{100.0, 200.0}, "a bump"});
        (void)window.session().editPlan(plan, QStringLiteral("exclude")).ok();
        break;
    case Step::Compare:
        static_cast<ComparePage &>(*window.main().page(Step::Compare)).setLimit(0.5);
        break;
    case Step::Export: {
        ExportChoice choice = window.session().exportChoice();
        choice.model = "linear";
        (void)window.session().setExportChoice(choice).ok();
        break;
    }
    default:
        plan.rbf.centres = 7;
        (void)window.session().editPlan(plan, QStringLiteral("take 7 centres")).ok();
        (void)window.bench->train().ok();
        QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    }
    QTRY_VERIFY_WITH_TIMEOUT(!problems.isEmpty(), kPatienceMs);
    QVERIFY(faultHappened());
    QVERIFY(!window.session().isSaved());
    QVERIFY2(window.main().sessionText().contains(QStringLiteral("not saved")),
             qPrintable(window.main().sessionText()));
    QVERIFY(window.events.rowCount() > 0);
    window.expectUsable();
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    clearFaults();
    QVERIFY(window.session().saveAgain().ok());
    QVERIFY(window.session().isSaved());
}

// Every file of this process ends after so many bytes, as on a disk that has no more room.
class NoRoom
{
public:
    explicit NoRoom(rlim_t bytes)
    {
        m_handler = std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &m_before);
        rlimit limit = m_before;
        limit.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~NoRoom()
    {
        ::setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }

private:
    rlimit m_before{};
    void (*m_handler)(int) = nullptr;
};

void TestGuiFaults::diskFull_forTheReport_leavesNoHalfReport()
{
    FaultyWindow window(2);
    QVERIFY(window.train());
    auto &compare = static_cast<ComparePage &>(*window.main().page(Step::Compare));
    window.main().showStep(Step::Compare);
    QTRY_VERIFY_WITH_TIMEOUT(window.session().prepared() != nullptr, kPatienceMs);
    const std::filesystem::path folder = window.folder() / "reports";
    std::filesystem::create_directory(folder);
    {
        const NoRoom full(1000);
        compare.writeReport(folder / "report.html");
        QTRY_VERIFY_WITH_TIMEOUT(compare.banners().holds(QStringLiteral("report")), kPatienceMs);
    }
    QCOMPARE(compare.banners().banner().content().kind, BannerKind::Bad);
    QVERIFY(std::filesystem::is_empty(folder));
    window.expectUsable();
    window.main().showStep(Step::Compare);
    compare.writeReport(folder / "report.html");
    QTRY_VERIFY_WITH_TIMEOUT(compare.banners().holds(QStringLiteral("report")), kPatienceMs);
    QCOMPARE(compare.banners().banner().content().kind, BannerKind::Info);
    QVERIFY(std::filesystem::file_size(folder / "report.html") > 1000);
}

void TestGuiFaults::cancelledTraining_onEachStep_windowStaysUsable()
{
    QFETCH(int, step);
    FaultyWindow window(3);
    CalibrationPlan plan = window.session().plan();
    plan.models = {"constant", "linear", "cubic", "rbf", "bp"};
    QVERIFY(window.session().editPlan(plan, QStringLiteral("models")).ok());
    window.main().showStep(static_cast<Step>(step));
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    QVERIFY(window.bench->train().ok());
    QSignalSpy trained(&window.bench->training(), &TrainingJob::modelTrained);
    QTRY_VERIFY_WITH_TIMEOUT(!trained.isEmpty() || window.idle(), kPatienceMs);
    window.bench->training().cancel();
    window.expectUsable();
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    plan.models = {"constant", "linear"};
    QVERIFY(window.session().editPlan(plan, QStringLiteral("models")).ok());
    QVERIFY(window.train());
    QVERIFY(window.session().result()->model("linear") != nullptr);
    window.expectUsable();
}

void TestGuiFaults::tour_trainingCancelled_doesNotHang()
{
    FaultyWindow window(3);
    GuidedTour &tour = window.main().tour();
    tour.start(); // in the session as it is
    for (int step = 0; step < int(Step::Train); ++step)
        tour.skip();
    QCOMPARE(window.main().currentStep(), Step::Train);
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    tour.next();
    QVERIFY(tour.isWorking());
    window.bench->training().cancel();
    QTRY_VERIFY_WITH_TIMEOUT(!tour.isWorking() || tour.at() != int(Step::Train), kPatienceMs);
    if (tour.at() == int(Step::Train)) {
        QVERIFY(!tour.trouble().isEmpty());
        tour.next();
    }
    QTRY_COMPARE_WITH_TIMEOUT(tour.at(), int(Step::Compare), kPatienceMs);
    QVERIFY(window.session().result() != nullptr);
}

QTEST_MAIN(TestGuiFaults)
#include "tst_gui_faults.moc"
