// What takes long is cancelled in the middle: the window stays usable, what is finished is kept, and the next
// run of the same work comes to its end.
#include "support/fault_window.h"

#include "app/gui/compare/report_writer.h"
#include "app/gui/pages/compare_page.h"
#include "app/gui/pages/inspect_page.h"
#include "app/gui/start/guided_tour.h"
#include "engine/formats/csv_writer.h"
#include "widgets/controls/loading_state.h"

#include <QAbstractButton>

using namespace driftbench;
using namespace driftbench::test;

class TestGuiFaultsCancel : public QObject
{
    Q_OBJECT

private slots:
    void cancelledTraining_onEachStep_windowStaysUsable_data() { addStepRows(); }
    void cancelledTraining_onEachStep_windowStaysUsable();
    void tour_trainingCancelled_doesNotHang();
    void cancelledJudging_onCompare_windowStaysUsable();
    void cancelledReading_onSource_leavesNoHalfRun();
    void cancelledReading_onInspect_isReadWhenComeBack_data();
    void cancelledReading_onInspect_isReadWhenComeBack();
    void cancelledReport_onCompare_isWrittenTheNextTime();
};

// The button of what is being read or computed, on that page.
static QAbstractButton *cancelOf(const Page &page)
{
    const auto *loading = page.findChild<LoadingState *>();
    return loading->isVisible() ? loading->findChild<QAbstractButton *>() : nullptr;
}

void TestGuiFaultsCancel::cancelledReading_onInspect_isReadWhenComeBack_data()
{
    QTest::addColumn<bool>("prepared");
    QTest::newRow("the runs") << false;
    QTest::newRow("what is shown of them") << true;
}

void TestGuiFaultsCancel::cancelledTraining_onEachStep_windowStaysUsable()
{
    QFETCH(int, step);
    FaultyWindow window(3);
    window.setModels({"constant", "linear", "cubic", "rbf", "bpnn"});
    window.main().showStep(static_cast<Step>(step));
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    QVERIFY(window.bench->train().ok());
    QSignalSpy trained(&window.bench->training(), &TrainingJob::modelTrained);
    QTRY_VERIFY_WITH_TIMEOUT(!trained.isEmpty(), kPatienceMs);
    QVERIFY(!window.idle()); // in the middle
    window.bench->training().cancel();
    window.expectUsable();
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    window.setModels({"constant", "linear"});
    QVERIFY(window.train());
    QVERIFY(window.session().result()->model("linear") != nullptr);
    window.expectUsable();
}

void TestGuiFaultsCancel::tour_trainingCancelled_doesNotHang()
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

void TestGuiFaultsCancel::cancelledJudging_onCompare_windowStaysUsable()
{
    FaultyWindow window(2);
    window.setModels({"constant", "linear", "bpnn"}); // which takes a moment
    QVERIFY(window.train());
    window.main().showStep(Step::Compare);
    auto &compare = window.page<ComparePage>(Step::Compare);
    const auto judge = [&compare](const char *text) {
        for (QAbstractButton *button : compare.findChildren<QAbstractButton *>()) {
            if (button->text() == QLatin1String(text))
                return button->click();
        }
        QFAIL(text);
    };
    QVERIFY(cancelOf(compare) == nullptr);
    judge("Anchored");
    QTRY_VERIFY_WITH_TIMEOUT(cancelOf(compare) != nullptr || window.idle(), kPatienceMs);
    QVERIFY(cancelOf(compare) != nullptr);
    cancelOf(compare)->click();
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    QTRY_VERIFY(cancelOf(compare) == nullptr); // nothing is being judged any more
    window.expectUsable();
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    window.setModels({"constant", "linear"});
    QVERIFY(window.train());
    QCOMPARE(window.session().result()->figures.judging, std::string("anchored"));
    QVERIFY(cancelOf(compare) == nullptr);
    judge("Absolute");
    QTRY_VERIFY_WITH_TIMEOUT(window.idle() && window.session().result(), kPatienceMs);
    QCOMPARE(window.session().result()->figures.judging, std::string("absolute"));
}

void TestGuiFaultsCancel::cancelledReading_onSource_leavesNoHalfRun()
{
    FaultyWindow window(0);
    const std::filesystem::path log = window.folder() / "heating.csv";
    QVERIFY(writeCsv(log, shortRun(0)).ok());
    auto &source = window.page<SourcePage>(Step::Source);
    QSignalSpy problems(window.bench.get(), &Workbench::problem);
    window.main().openFiles({log});
    QVERIFY(window.bench->loading().isRunning());
    QVERIFY(cancelOf(source) != nullptr);
    cancelOf(source)->click();
    QTRY_VERIFY_WITH_TIMEOUT(!window.bench->loading().isRunning(), kPatienceMs);
    QVERIFY(problems.isEmpty()); // it was wanted
    // None, unless all of it was read before the click.
    const std::size_t read = window.session().runs().size();
    QCOMPARE(window.session().file().runs()->size(), read);
    QCOMPARE(window.main().currentStep(), read == 0 ? Step::Source : Step::Inspect);
    window.expectUsable();
    window.main().openFiles({log});
    QTRY_COMPARE_WITH_TIMEOUT(window.session().runs().size(), read + 1, kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(window.main().currentStep(), Step::Inspect, kPatienceMs);
}

// While the runs are read, and while what is shown of them is made.
void TestGuiFaultsCancel::cancelledReading_onInspect_isReadWhenComeBack()
{
    QFETCH(bool, prepared);
    FaultyWindow window(2);
    auto &inspect = window.page<InspectPage>(Step::Inspect);
    bool clicked = false;
    const auto cancel = [&] {
        if (QAbstractButton *button = clicked ? nullptr : cancelOf(inspect)) {
            clicked = true;
            button->click();
        }
    };
    if (prepared) // the page begins to look at them then
        connect(window.bench.get(), &Workbench::preparedChanged, &inspect, cancel);
    window.main().showStep(Step::Inspect);
    if (!prepared)
        cancel();
    QTRY_VERIFY_WITH_TIMEOUT(clicked && window.idle(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(cancelOf(inspect) == nullptr, kPatienceMs);
    if (prepared) // else they may have been read before the click
        QVERIFY(inspect.seen() == nullptr && window.session().prepared() != nullptr);
    window.main().showStep(Step::Plan);
    window.main().showStep(Step::Inspect);
    QTRY_VERIFY_WITH_TIMEOUT(inspect.seen() != nullptr, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    window.expectUsable();
}

void TestGuiFaultsCancel::cancelledReport_onCompare_isWrittenTheNextTime()
{
    FaultyWindow window(2);
    QVERIFY(window.train());
    window.main().showStep(Step::Compare);
    auto &compare = window.page<ComparePage>(Step::Compare);
    QTRY_VERIFY_WITH_TIMEOUT(window.session().prepared() != nullptr, kPatienceMs);
    const std::filesystem::path file = window.folder() / "report.html";
    compare.writeReport(file);
    QVERIFY(compare.reports().isRunning());
    QTest::keyClick(&compare, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(!compare.reports().isRunning(), kPatienceMs);
    QCOMPARE(compare.banners().banner().content().what, QString("The report was cancelled."));
    QCOMPARE(compare.banners().banner().content().kind, BannerKind::Info);
    QVERIFY(!std::filesystem::exists(file));
    window.expectUsable();
    compare.writeReport(file);
    QTRY_COMPARE_WITH_TIMEOUT(compare.banners().banner().content().what, QString("The report is written."),
                              kPatienceMs);
    QVERIFY(std::filesystem::file_size(file) > 1000);
}

QTEST_MAIN(TestGuiFaultsCancel)
#include "tst_gui_faults_cancel.moc"
