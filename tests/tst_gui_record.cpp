// The page Record over the simulated bridge: what it shows is what is recorded.
#include "app/gui/pages/record_page.h"
#include "app/gui/record/live_run.h"
#include "app/gui/record/record_readouts.h"
#include "app/gui/source_status.h"
#include "device/simulated_board.h"
#include "support/short_plan.h"
#include "support/workbench_pages.h"
#include "widgets/live/live_trace_view.h"
#include "widgets/style/number_text.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <qcustomplot.h>

using namespace driftbench;
using namespace driftbench::test;

namespace {

constexpr double kSpeed = 100.0;

class RecordBench : public PageBench
{
public:
    explicit RecordBench(double speed = kSpeed)
    {
        if (!workbench->session().setTestPlan(shortPlan()).ok())
            qFatal("no plan");
        SimulatedChoice simulated;
        simulated.speed = speed;
        simulated.referenceRateDps = {25.0, 5.0, 53.0};
        workbench->setSourceChoice({simulated});
        record = page<RecordPage>();
    }
    ~RecordBench() { workbench->stopSource(); }

    bool start()
    {
        record->startRecording();
        return QTest::qWaitFor([this] { return record->run().isRecording() && record->run().hasSamples(); },
                               20'000);
    }
    bool waitUntilOver()
    {
        return QTest::qWaitFor([this] { return !workbench->acquisition().isRecording(); }, 30'000);
    }
    QString banner() const
    {
        return record->banners().banner().content().what + QLatin1Char(' ') +
               record->banners().banner().content().toDo;
    }

    std::unique_ptr<RecordPage> record;
};

} // namespace

class TestGuiRecord : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void empty_noSource_leadsToTheSource();
    void recording_wholePlan_endsWithItAndScoresWhatIsInTheFile();
    void recording_modelInSession_isApplied();
    void pause_view_recordingGoesOn();
    void cursors_whileRecording_readOut();
    void unplugged_whileRecording_saysSoAndGoesOn();
    void disk_fullWhileRecording_isSaidUntilItRecovers();
    void stop_byKey_keepsWhatWasRecorded();
    void session_replaced_isForgotten();
};

void TestGuiRecord::empty_noSource_leadsToTheSource()
{
    PageBench bench;
    const auto record = bench.page<RecordPage>();
    QVERIFY(!record->stepState().holds);
    QVERIFY(!record->hints().isEmpty());
    QSignalSpy go(&bench.navigator, &Navigator::stepRequested);
    record->startRecording();
    QVERIFY(record->banners().banner().content().what.contains(QStringLiteral("No source")));
    record->banners().banner().content().actions.front()->trigger();
    QCOMPARE(go.count(), 1);
    QCOMPARE(go.first().first().value<Step>(), Step::Source);
}

void TestGuiRecord::recording_wholePlan_endsWithItAndScoresWhatIsInTheFile()
{
    RecordBench bench;
    QVERIFY(bench.start());
    QCOMPARE(bench.record->stepState().mark, StepMark::Recording);
    QVERIFY(bench.record->stepState().note.startsWith(QStringLiteral("Run 1 of 2")));
    QCOMPARE(bench.record->origin(), Origin::Simulated);
    QVERIFY(bench.waitUntilOver());
    QTRY_COMPARE(bench.workbench->session().runs().size(), std::size_t{1});
    QVERIFY2(bench.banner().startsWith(QStringLiteral("Run 1 is complete.")), qPrintable(bench.banner()));

    const RunRecord record = bench.workbench->session().runs().front();
    const auto recording = bench.workbench->session().recording(record.id);
    QVERIFY(recording.ok());
    const auto count = static_cast<double>((*recording)->size());
    QVERIFY(count > 2200.0);
    // At this speed the last batches are on the disk and not in the view.
    const auto shown = static_cast<Eigen::Index>(bench.record->run().link().samples);
    QVERIFY(shown > 2000 && shown <= (*recording)->size());
    const Eigen::Vector3d reference(25.0, 5.0, 53.0);
    const Eigen::MatrixX3d tde = (*recording)->rateDps.topRows(shown).rowwise() - reference.transpose();
    const Eigen::Vector3d msd = tde.colwise().squaredNorm().transpose() / double(shown);
    const RecordReadouts &readouts = bench.record->readouts();
    bench.record->readouts().showAll();
    for (int axis = 0; axis < 3; ++axis) {
        QVERIFY(std::abs(bench.record->run().scores().before.msdDps2()[axis] - msd[axis]) < 1e-9);
        QCOMPARE(readouts.text(QStringLiteral("scores"), axis, 0), numberText(msd[axis], 3));
        QCOMPARE(readouts.text(QStringLiteral("scores"), axis, 1), QStringLiteral("–")); // no model
    }
    QVERIFY(readouts.text(QStringLiteral("progress"), 1).startsWith(QStringLiteral("0:00:0"))); // remaining
    QVERIFY(readouts.text(QStringLiteral("link"), 0).startsWith(QStringLiteral("10.0 Hz")));
    const auto &holds = bench.record->view().marks().holds;
    QVERIFY(!holds.empty() && std::abs(holds.front().temperatureC - 20.0) < 0.3);
}

void TestGuiRecord::recording_modelInSession_isApplied()
{
    RecordBench bench;
    QVERIFY(bench.start() && bench.waitUntilOver());
    CalibrationPlan plan = bench.workbench->session().plan();
    plan.models = {"constant", "linear"};
    plan.quality.allowSmallSpan = true;
    QVERIFY(bench.workbench->session().editPlan(plan, QStringLiteral("quick models")).ok());
    QVERIFY(bench.workbench->train().ok());
    QTRY_VERIFY_WITH_TIMEOUT(bench.workbench->session().result() != nullptr, 60'000);
    QVERIFY(bench.start());
    QVERIFY(bench.record->run().model());
    QVERIFY(bench.record->head().context().startsWith(
        QStringLiteral("Run 2 of 2, compensated by the model of run1")));
    QVERIFY(bench.waitUntilOver());
    const RunningScores &scores = bench.record->run().scores();
    QCOMPARE(scores.after.samples(), scores.before.samples());
    for (int axis = 0; axis < 3; ++axis)
        QVERIFY2(scores.after.msdDps2()[axis] < scores.before.msdDps2()[axis],
                 qPrintable(QString::number(axis)));
    bench.record->readouts().showAll();
    QVERIFY(bench.record->readouts().text(QStringLiteral("scores"), 0, 1) != QStringLiteral("–"));
    QVERIFY(bench.record->view().legend().size() >= 3);
}

void TestGuiRecord::pause_view_recordingGoesOn()
{
    RecordBench bench(20.0);
    QVERIFY(bench.start());
    QTest::keyClick(bench.record.get(), Qt::Key_Space);
    QVERIFY(bench.record->view().isPaused());
    QVERIFY(bench.banner().contains(QStringLiteral("Recording goes on")));
    const auto samples = bench.record->run().link().samples;
    QTRY_VERIFY(bench.record->run().link().samples > samples + 100);
    QVERIFY(bench.record->view().samplesSincePause() > 0);
    QTest::keyClick(bench.record.get(), Qt::Key_Space);
    QVERIFY(!bench.record->view().isPaused());
    QVERIFY(!bench.record->banners().holds(QStringLiteral("paused")));
    bench.record->stopRecording();
    QVERIFY(bench.waitUntilOver());
}

void TestGuiRecord::cursors_whileRecording_readOut()
{
    RecordBench bench(50.0);
    QVERIFY(bench.start());
    QTRY_VERIFY_WITH_TIMEOUT(bench.record->run().elapsedS() > 100.0, 20'000);
    bench.record->view().cursors().place(Cursor::A, 30.0);
    bench.record->view().cursors().place(Cursor::B, 90.0);
    const RecordReadouts &readouts = bench.record->readouts();
    QCOMPARE(readouts.text(QStringLiteral("cursors"), 0, 0), QStringLiteral("0:00:30"));
    QCOMPARE(readouts.text(QStringLiteral("cursors"), 0, 2), QStringLiteral("0:01:00"));
    const auto a = bench.record->view().reading(Cursor::A);
    const auto b = bench.record->view().reading(Cursor::B);
    QVERIFY(a && b);
    const double difference = b->means[TracePyramid::kTemperature] - a->means[TracePyramid::kTemperature];
    QVERIFY(difference > 1.0); // up the stair
    QCOMPARE(readouts.text(QStringLiteral("cursors"), 1, 2), QLatin1Char('+') + numberText(difference, 2));
    bench.record->stopRecording();
    QVERIFY(bench.waitUntilOver());
}

void TestGuiRecord::unplugged_whileRecording_saysSoAndGoesOn()
{
    RecordBench bench(20.0);
    QVERIFY(bench.start());
    const auto board = bench.workbench->simulatedBoard();
    QVERIFY(board);
    const SourceStatus status(*bench.workbench);
    const auto saysSilent = [&status] {
        const std::vector<StatusPart> parts = status.parts();
        return parts.at(0).text.contains(QLatin1String("no samples for")) &&
               parts.at(0).tone == Tone::Caution;
    };
    QVERIFY(!saysSilent());
    board->unplug();
    QTRY_VERIFY_WITH_TIMEOUT(bench.record->banners().holds(QStringLiteral("absence")), 20'000);
    QVERIFY(saysSilent());
    QVERIFY(bench.record->run().isRecording());
    const auto samples = bench.record->run().link().samples;
    board->plugIn(5.0);
    QTRY_VERIFY_WITH_TIMEOUT(bench.record->run().link().samples > samples + 20, 20'000);
    QTRY_VERIFY(!bench.record->banners().holds(QStringLiteral("absence")));
    QVERIFY(!saysSilent());
    QVERIFY(!bench.record->view().marks().gaps.empty());
    bench.record->stopRecording();
    QVERIFY(bench.waitUntilOver());
    QCOMPARE(bench.workbench->session().runs().size(), std::size_t{1});
}

void TestGuiRecord::disk_fullWhileRecording_isSaidUntilItRecovers()
{
    RecordBench bench(20.0);
    QVERIFY(bench.start());
    Acquisition &acquisition = bench.workbench->acquisition();
    emit acquisition.recorderEvent({RecorderEventKind::Failing, "The disk is full."});
    QVERIFY2(bench.banner().contains(QStringLiteral("recording goes on in memory")),
             qPrintable(bench.banner()));
    QVERIFY(!bench.record->banners().banner().content().closable);
    emit acquisition.recorderEvent({RecorderEventKind::Recovered, "All is written."});
    QVERIFY(bench.banner().contains(QStringLiteral("on the disk again")));
    bench.record->stopRecording();
    QVERIFY(bench.waitUntilOver());
}

void TestGuiRecord::stop_byKey_keepsWhatWasRecorded()
{
    RecordBench bench(20.0);
    QVERIFY(bench.start());
    QTest::keyClick(bench.record.get(), Qt::Key_Period, Qt::ControlModifier);
    QVERIFY(bench.waitUntilOver());
    QVERIFY2(bench.banner().startsWith(QStringLiteral("Run 1 was stopped at 0:00:")),
             qPrintable(bench.banner()));
    QCOMPARE(bench.workbench->session().runs().front().state, RunState::Complete);
    QCOMPARE(bench.record->stepState().mark, StepMark::Done);
}

void TestGuiRecord::session_replaced_isForgotten()
{
    RecordBench bench;
    QVERIFY(bench.start() && bench.waitUntilOver());
    QVERIFY(bench.record->run().hasSamples());
    QVERIFY(bench.workbench->newSession().ok());
    QVERIFY(!bench.record->run().hasSamples());
    QVERIFY(bench.record->view().isEmpty());
}

QTEST_MAIN(TestGuiRecord)
#include "tst_gui_record.moc"
