// The page Inspect over runs of a session: figures, linked selection, exclusions and their undo.
#include "app/gui/inspect/inspect_side.h"
#include "app/gui/pages/inspect_page.h"
#include "engine/formats/log_reader.h"
#include "engine/recording/block_means.h"
#include "support/test_data.h"
#include "support/workbench_pages.h"
#include "widgets/plot/plot_interaction.h"
#include "widgets/views/coverage_view.h"
#include "widgets/views/exclusion_strip.h"
#include "widgets/views/tcq_scatter_view.h"

#include <QDir>
#include <QStandardPaths>
#include <QTableView>
#include <qcustomplot.h>

using namespace driftbench;
using namespace driftbench::test;

namespace {

class InspectBench : public PageBench
{
public:
    bool show()
    {
        inspect = page<InspectPage>();
        return settled();
    }
    // The page shows what the session holds now.
    bool settled() const
    {
        return QTest::qWaitFor(
            [this] {
                const auto &prepared = workbench->session().prepared();
                return prepared && inspect->seen() && inspect->seen()->prepared == prepared;
            },
            60'000);
    }
    void drag(QCustomPlot &plot, const QPointF &from, const QPointF &to,
              Qt::KeyboardModifiers with = Qt::NoModifier)
    {
        QTest::mousePress(&plot, Qt::LeftButton, with, from.toPoint());
        for (const QPointF &place : {(from + to) / 2.0, to}) {
            QMouseEvent event(QEvent::MouseMove, place, plot.mapToGlobal(place), Qt::LeftButton,
                              Qt::LeftButton, with);
            QApplication::sendEvent(&plot, &event);
        }
        QTest::mouseRelease(&plot, Qt::LeftButton, with, to.toPoint());
    }
    void dragInStrip(double fromS, double toS)
    {
        ExclusionStrip &strip = inspect->strip();
        strip.plot().replot();
        const double y = strip.plot().axisRects().front()->center().y() + 14.0; // beside the grips
        drag(strip.plot(), {strip.pixelOf(fromS), y}, {strip.pixelOf(toS), y});
    }

    std::unique_ptr<InspectPage> inspect;
};

} // namespace

class TestGuiInspect : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void empty_noRuns_leadsToTheRecording();
    void run_withHysteresis_isSaidOfThatAxisAlone();
    void chamber_threeRuns_haveThePublishedFigures();
    void means_ofALongRun_showWhatTheSamplesDo();
    void strip_drag_selectsInAllPlots();
    void strip_deleteAndUndo_excludesAndGivesBack();
    void strip_grips_moveTheExclusion();
    void scatter_boxInTheResiduals_selectsItsStretches();
    void coverage_drag_selectsByTemperature();
    void table_reason_canBeWritten();
    void keys_xyz_chooseTheAxis();
    void refusal_constantTemperature_isSaidAndTheRunShown();
    void overTime_chosen_showsSixPanels();
};

void TestGuiInspect::empty_noRuns_leadsToTheRecording()
{
    InspectBench bench;
    bench.inspect = bench.page<InspectPage>();
    QVERIFY(!bench.inspect->seen());
    QVERIFY(!bench.inspect->stepState().holds);
    QVERIFY(!bench.inspect->hints().isEmpty());
}

void TestGuiInspect::run_withHysteresis_isSaidOfThatAxisAlone()
{
    InspectBench bench;
    bench.importRun(upAndDown(0.3), "run1");
    QVERIFY(bench.show());
    const auto &axes = bench.inspect->seen()->inspection->axes;
    QCOMPARE(axes[0].kind, CurveKind::Not);
    QCOMPARE(axes[1].kind, CurveKind::Curve);
    QVERIFY(std::abs(axes[0].spreadDps - 0.3) < 0.05);
    QVERIFY(std::abs(axes[1].noiseDps - 0.01) < 0.003);
    QVERIFY(bench.inspect->banners().banner().content().what.startsWith(QStringLiteral("x is not a curve")));
    QCOMPARE(bench.inspect->stepState().mark, StepMark::Warning);
    QCOMPARE(bench.inspect->stepState().note, QStringLiteral("x: hysteresis"));
    bench.inspect->setAxis(1);
    QVERIFY(!bench.inspect->banners().holds(QStringLiteral("shape")));
    QVERIFY(std::abs(bench.inspect->seen()->inspection->coverage.bothShare - 1.0) < 0.06);
}

void TestGuiInspect::chamber_threeRuns_haveThePublishedFigures()
{
    REQUIRE_SHARED_DATA(folder, "climate_chamber");
    InspectBench bench;
    for (const char *name : {"run1_cooling", "run2_heating", "run3_cooling"}) {
        const auto log = readLog(folder / (std::string(name) + ".csv"), {});
        QVERIFY2(log.ok(), log.ok() ? "" : log.error().message.c_str());
        bench.importRun(*log, name);
    }
    QVERIFY(bench.show());
    // The folder's README has these readings at 40 degrees.
    const QString words = bench.inspect->banners().banner().content().toDo;
    for (const char *reading : {"At 40 °C", "−3.99", "−4.21", "−3.42", "cooling again"})
        QVERIFY2(words.contains(QString::fromUtf8(reading)), qPrintable(words));
    const auto &axes = bench.inspect->seen()->inspection->axes;
    QCOMPARE(axes[0].kind, CurveKind::Not);
    QCOMPARE(axes[1].kind, CurveKind::Nearly);
    QCOMPARE(axes[2].kind, CurveKind::Not);
    QVERIFY(std::abs(axes[0].spreadDps - 0.79) < 0.01);
    QVERIFY(std::abs(axes[0].noiseDps - 0.015) < 0.003);
    const TemperatureCoverage &coverage = bench.inspect->seen()->inspection->coverage;
    QVERIFY(std::abs(coverage.lowestC + 17.6) < 0.1 && std::abs(coverage.highestC - 74.0) < 0.1);
    const QString folderName = qEnvironmentVariable("DRIFTBENCH_FIGURES");
    if (!folderName.isEmpty())
        bench.inspect->grab().save(QDir(folderName).filePath(QStringLiteral("inspect-chamber.png")));
}

static InspectionData inspected(Recording recording)
{
    LoadedRun run;
    run.record.id = 1;
    run.record.description.name = "long";
    run.recording = std::make_shared<const Recording>(std::move(recording));
    CalibrationPlan plan;
    plan.runs.push_back({1});
    plan.runs.back().excluded.push_back({{600.0, 799.0}, "a draught"});
    const auto prepared = prepareCampaign(plan, {run});
    auto seen = inspect(std::make_shared<const PreparedCampaign>(*prepared), nullptr);
    return *std::move(seen);
}

void TestGuiInspect::means_ofALongRun_showWhatTheSamplesDo()
{
    const Recording recording = upAndDown(0.3);
    const InspectionData samples = inspected(recording);
    const InspectionData means = inspected(shortened(recording, recording.size() / 4));
    QCOMPARE(samples.samplesAPoint, 1);
    QCOMPARE(means.samplesAPoint, 4);
    QCOMPARE(means.samples, samples.samples);
    QCOMPARE(means.excluded.front().samples, std::int64_t{200});
    QCOMPARE(means.excluded.front().samples, samples.excluded.front().samples);
    QVERIFY(std::abs(means.sampleRateHz - samples.sampleRateHz) < 0.01);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const AxisInspection &a = means.inspection->axes[axis];
        const AxisInspection &b = samples.inspection->axes[axis];
        QCOMPARE(a.kind, b.kind);
        QVERIFY(std::abs(a.noiseDps / b.noiseDps - 1.0) < 0.05);
        QVERIFY(std::abs(a.leftDps / b.leftDps - 1.0) < 0.05);
        // Of 40 cells of a degree, the first and the last are hardly reached.
        QVERIFY(std::abs(a.swingDps / b.swingDps - 1.0) < 2.0 / 40.0 + 0.02);
    }
}

void TestGuiInspect::strip_drag_selectsInAllPlots()
{
    InspectBench bench;
    bench.importRun(upAndDown(0.3), "run1");
    bench.importRun(upAndDown(0.3), "run2");
    QVERIFY(bench.show());
    bench.dragInStrip(3400.0, 3900.0); // over the border between the runs
    const Selection &selection = bench.inspect->selection();
    QCOMPARE(selection.size(), std::size_t{2});
    QVERIFY(std::abs(selection[0].startS - 3400.0) < 20.0 && std::abs(selection[0].endS - 3599.0) < 1.0);
    QVERIFY(std::abs(selection[1].endS - 301.0) < 20.0);
    const TcqScatterData &shown = bench.inspect->scatter().shown();
    QVERIFY(shown.selectedDeltaT.size() > 100);
    QVERIFY(shown.selectedDeltaT.maxCoeff() < 12.0); // the cold ends
    QCOMPARE(bench.inspect->strip().shown().selected.timeS.size(), shown.selectedDeltaT.size());
    QTest::keyClick(bench.inspect.get(), Qt::Key_Escape);
    QVERIFY(bench.inspect->selection().empty());
    QCOMPARE(bench.inspect->scatter().shown().selectedDeltaT.size(), Eigen::Index{0});
}

void TestGuiInspect::strip_deleteAndUndo_excludesAndGivesBack()
{
    InspectBench bench;
    const RunId run = bench.importRun(upAndDown(0.3), "run1");
    QVERIFY(bench.show());
    Session &session = bench.workbench->session();
    const auto before = bench.inspect->seen()->excludedSamples;
    bench.dragInStrip(1000.0, 1500.0);
    QTest::keyClick(bench.inspect.get(), Qt::Key_Delete);
    QCOMPARE(session.plan().find(run)->excluded.size(), std::size_t{1});
    QVERIFY(bench.settled());
    const ExcludedStretch &stretch = bench.inspect->seen()->excluded.front();
    QVERIFY(stretch.own);
    QVERIFY2(std::abs(double(stretch.samples) - 500.0) < 20.0, qPrintable(QString::number(stretch.samples)));
    QVERIFY(bench.inspect->seen()->excludedSamples >= before + stretch.samples - 20);
    QCOMPARE(bench.inspect->strip().shown().ranges.size(), std::size_t{1});
    QVERIFY(session.history().undoText().startsWith(QStringLiteral("exclude")));

    bench.context.actions.undo->trigger();
    QVERIFY(session.plan().find(run)->excluded.empty());
    QVERIFY(bench.settled());
    QCOMPARE(bench.inspect->seen()->excludedSamples, before);
    bench.context.actions.redo->trigger();
    QVERIFY(bench.settled());
    QCOMPARE(session.plan().find(run)->excluded.size(), std::size_t{1});

    // Picked and deleted: in again.
    ExclusionStrip &strip = bench.inspect->strip();
    strip.plot().replot();
    QTest::mouseClick(&strip.plot(), Qt::LeftButton, Qt::NoModifier,
                      QPoint(int(strip.pixelOf(1250.0)), strip.plot().axisRects().front()->center().y()));
    QTest::keyClick(bench.inspect.get(), Qt::Key_Delete);
    QVERIFY(session.plan().find(run)->excluded.empty());
    QVERIFY(bench.settled());
}

void TestGuiInspect::strip_grips_moveTheExclusion()
{
    InspectBench bench;
    const RunId run = bench.importRun(upAndDown(0.3), "run1");
    QVERIFY(bench.show());
    bench.dragInStrip(1000.0, 1500.0);
    QTest::keyClick(bench.inspect.get(), Qt::Key_Delete);
    QVERIFY(bench.settled());
    bench.dragInStrip(1500.0, 2500.0); // its right edge
    QVERIFY(bench.settled());
    const auto &excluded = bench.workbench->session().plan().find(run)->excluded;
    QCOMPARE(excluded.size(), std::size_t{1});
    QVERIFY(std::abs(excluded.front().range.startS - 1000.0) < 10.0);
    QVERIFY(std::abs(excluded.front().range.endS - 2500.0) < 15.0);
    QCOMPARE(bench.workbench->session().history().undoText(),
             QStringLiteral("move an excluded stretch of run1"));
}

void TestGuiInspect::scatter_boxInTheResiduals_selectsItsStretches()
{
    InspectBench bench;
    bench.importRun(upAndDown(0.6), "run1");
    QVERIFY(bench.show());
    QCustomPlot &plot = bench.inspect->scatter().plot();
    plot.replot();
    QCPAxisRect &residuals = *plot.axisRects().at(3); // over dT
    const auto at = [&](double deltaT, double value) {
        return QPointF(residuals.axis(QCPAxis::atBottom)->coordToPixel(deltaT),
                       residuals.axis(QCPAxis::atLeft)->coordToPixel(value));
    };
    // What reads too much in the middle is the way down.
    bench.drag(plot, at(10.0, 0.27), at(30.0, 0.1), Qt::ControlModifier);
    QVERIFY(!bench.inspect->selection().empty());
    for (const SelectedStretch &stretch : bench.inspect->selection())
        QVERIFY(stretch.startS > 1800.0);
}

void TestGuiInspect::coverage_drag_selectsByTemperature()
{
    InspectBench bench;
    bench.importRun(upAndDown(0.0), "run1");
    QVERIFY(bench.show());
    QCustomPlot &plot = bench.inspect->coverage().plot();
    plot.replot();
    QCPAxisRect &panel = *plot.axisRects().front();
    const auto x = [&](double temperatureC) {
        return panel.axis(QCPAxis::atBottom)->coordToPixel(temperatureC);
    };
    bench.drag(plot, {x(10.0), double(panel.center().y())}, {x(20.0), double(panel.center().y())});
    const Eigen::VectorXd selected = bench.inspect->scatter().shown().selectedDeltaT.array() +
                                     bench.inspect->seen()->referenceTemperatureC;
    QVERIFY(selected.size() > 100);
    QVERIFY(selected.minCoeff() > 9.0 && selected.maxCoeff() < 21.0);
    double seconds = 0.0;
    for (const SelectedStretch &stretch : bench.inspect->selection())
        seconds += stretch.endS - stretch.startS;
    QVERIFY(std::abs(seconds - 900.0) < 120.0); // a quarter of the way up and down
}

void TestGuiInspect::table_reason_canBeWritten()
{
    InspectBench bench;
    const RunId run = bench.importRun(upAndDown(0.3), "run1");
    QVERIFY(bench.show());
    bench.dragInStrip(1000.0, 1500.0);
    QTest::keyClick(bench.inspect.get(), Qt::Key_Delete);
    QVERIFY(bench.settled());
    ExcludedModel &model = bench.inspect->side().excluded();
    const int row = model.rowOf(0, 0);
    QVERIFY(row >= 0);
    QCOMPARE(model.index(row, 2).data().toString(), QStringLiteral("by hand"));
    QVERIFY(
        static_cast<QAbstractItemModel &>(model).setData(model.index(row, 2), QStringLiteral("door open")));
    QCOMPARE(bench.workbench->session().plan().find(run)->excluded.front().note, std::string("door open"));
    QVERIFY(bench.settled());
}

void TestGuiInspect::keys_xyz_chooseTheAxis()
{
    InspectBench bench;
    bench.importRun(upAndDown(0.3), "run1");
    QVERIFY(bench.show());
    QTest::keyClick(bench.inspect.get(), Qt::Key_Z);
    QCOMPARE(bench.inspect->axis(), 2);
    QCOMPARE(bench.inspect->side().axes().currentAxis(), 2);
    QCOMPARE(bench.inspect->scatter().shown().axis, 2);
    QTest::keyClick(&bench.inspect->side().axes(), Qt::Key_Up);
    QCOMPARE(bench.inspect->axis(), 1);
    QVERIFY(bench.inspect->head().context().startsWith(QStringLiteral("TDE of y")));
}

void TestGuiInspect::refusal_constantTemperature_isSaidAndTheRunShown()
{
    InspectBench bench;
    bench.importRun(upAndDown(0.0, 0.0), "run1");
    QVERIFY(bench.show());
    const Banner &banner = bench.inspect->banners().banner();
    QCOMPARE(banner.content().kind, BannerKind::Bad);
    QCOMPARE(banner.content().toDo.toStdString(), bench.inspect->seen()->prepared->refusal->message);
    QCOMPARE(bench.inspect->stepState().mark, StepMark::Warning);
    QVERIFY(!bench.inspect->strip().isEmpty());
    banner.content().actions.front()->trigger(); // the findings
    QVERIFY(bench.inspect->findChild<QTableView *>());
}

void TestGuiInspect::overTime_chosen_showsSixPanels()
{
    InspectBench bench;
    bench.importRun(upAndDown(0.3), "run1");
    QVERIFY(bench.show());
    QCOMPARE(bench.inspect->seen()->overTime.traces.size(), std::size_t{6});
    const Envelope &deltaT = bench.inspect->seen()->overTime.traces.front();
    QVERIFY(*std::max_element(deltaT.high.begin(), deltaT.high.end()) > 39.0);
    QCOMPARE(bench.inspect->seen()->overTime.spanS, 3599.0);
}

QTEST_MAIN(TestGuiInspect)
#include "tst_gui_inspect.moc"
