// The bridge goes away in the middle of each step, of a recording, of an upload and of the guided tour: the
// window says so, stays usable, and works again once the bridge is back.
#include "support/fault_window.h"
#include "support/plugged_board.h"

#include "app/gui/export/device_panel.h"
#include "app/gui/export/upload_steps.h"
#include "app/gui/pages/export_page.h"
#include "app/gui/pages/record_page.h"
#include "app/gui/record/live_run.h"
#include "app/gui/source/bridge_list.h"
#include "app/gui/start/guided_tour.h"
#include "app/gui/status_line.h"
#include "device/simulated_board.h"
#include "widgets/live/live_trace_view.h"
#include "widgets/tables/data_table.h"

using namespace driftbench;
using namespace driftbench::test;

class TestGuiFaultsDevice : public QObject
{
    Q_OBJECT

private slots:
    void unplugged_onEachStep_windowStaysUsable_data() { addStepRows(); }
    void unplugged_onEachStep_windowStaysUsable();
    void unplugged_whileRecording_runIsSafeAndTheNextWorks_data();
    void unplugged_whileRecording_runIsSafeAndTheNextWorks();
    void statusBar_whileRecording_saysDroppedOnce();
    void unplugged_inEachStepOfAnUpload_isSaidAndAgainWorks();
    void watchedBridge_exportEntered_isLetGo();
    void tour_bridgeUnplugged_saysSoAndGoesOn();
    void tour_flashDamaged_saysSoAndIsRepeated();
};

namespace {

// A window in which a real bridge was chosen on the Source page, by a click.
class BoardWindow : public FaultyWindow
{
public:
    BoardWindow(const PluggedBoard &board, int runs) : FaultyWindow(runs, board.access(), true)
    {
        auto *list = main().page(Step::Source)->findChild<BridgeList *>();
        if (!QTest::qWaitFor([list] { return list->model()->rowCount() == 2; }, kPatienceMs))
            qFatal("the bridge is not found");
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualRect(list->model()->index(1, 0)).center());
        if (!bench->sourceChoice() || !bench->sourceChoice()->as<NativeChoice>() || !bench->useSource())
            qFatal("the bridge can't be used");
        main().showStep(Step::Record);
    }

    RecordPage &record() { return page<RecordPage>(Step::Record); }
    ExportPage &exports() { return page<ExportPage>(Step::Export); }
    const BannerContent &said(Step step) { return main().page(step)->banners().banner().content(); }

    bool startRecording()
    {
        record().startRecording();
        return QTest::qWaitFor(
            [this] { return record().run().isRecording() && record().run().elapsedS() > 2.0; }, kPatienceMs);
    }
    bool stopRecording()
    {
        QTest::keyClick(&record(), Qt::Key_Period, Qt::ControlModifier);
        return QTest::qWaitFor([this] { return !bench->acquisition().isRecording(); }, kPatienceMs);
    }
    bool deviceKnown()
    {
        return QTest::qWaitFor(
            [this] { return exports().preview() != nullptr && exports().device().canWrite(); }, kPatienceMs);
    }
    // Wants that model's table on the device.
    bool choose(const std::string &model)
    {
        ExportChoice choice = session().exportChoice();
        choice.model = model;
        choice.options.force = true; // what is written is the matter here, not the verdict
        return session().setExportChoice(choice).ok() &&
               QTest::qWaitFor([&] { return exports().preview() && exports().preview()->model == model; },
                               kPatienceMs) &&
               deviceKnown();
    }
    // By its key; true: an upload was begun and has come to its end.
    bool write()
    {
        exports().writeAction()->trigger();
        return exports().device().isWriting() &&
               QTest::qWaitFor([this] { return !exports().device().isWriting(); }, kPatienceMs);
    }
    bool lookSays(const std::function<bool()> &what) { return QTest::qWaitFor(what, kPatienceMs); }
};

// As another program finds it: whole, and the runs with their samples.
void expectWhole(const std::filesystem::path &path, RunId run, std::int64_t samples)
{
    const auto file = SessionFile::open(path, SessionAccess::ReadOnly);
    QVERIFY2(file.ok(), file.ok() ? "" : file.error().message.c_str());
    const auto wrong = file->check();
    QVERIFY(wrong.ok());
    QVERIFY2(wrong->empty(), wrong->empty() ? "" : wrong->front().c_str());
    const auto recording = file->readRun(run);
    QVERIFY(recording.ok());
    QVERIFY2(recording->size() == samples,
             qPrintable(QStringLiteral("%1 of %2").arg(recording->size()).arg(samples)));
    for (Eigen::Index i = 1; i < recording->size(); ++i)
        QVERIFY(recording->timeS[i] > recording->timeS[i - 1]);
}

} // namespace

void TestGuiFaultsDevice::unplugged_onEachStep_windowStaysUsable()
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

void TestGuiFaultsDevice::unplugged_whileRecording_runIsSafeAndTheNextWorks_data()
{
    QTest::addColumn<bool>("comesBack");
    QTest::newRow("stopped while it is away") << false;
    QTest::newRow("plugged in again") << true;
}

void TestGuiFaultsDevice::unplugged_whileRecording_runIsSafeAndTheNextWorks()
{
    QFETCH(bool, comesBack);
    const PluggedBoard board(20.0);
    BoardWindow window(board, 0);
    RecordPage &record = window.record();
    QVERIFY(window.startRecording());
    board->unplug();
    QTRY_VERIFY_WITH_TIMEOUT(record.banners().holds(QStringLiteral("absence")), kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(window.said(Step::Record).what.startsWith("The bridge was unplugged at "),
                              qPrintable(window.said(Step::Record).what), kPatienceMs);
    QCOMPARE(window.said(Step::Record).kind, BannerKind::Caution);
    window.expectUsable();
    // Nothing moves any more, and what came is on the disk.
    const std::int64_t shown = record.run().link().samples;
    QTRY_COMPARE_WITH_TIMEOUT(window.bench->acquisition().recorderStats()->queued(), std::int64_t(0),
                              kPatienceMs);
    QCOMPARE(record.run().link().samples, shown);
    QVERIFY(record.run().isRecording());
    const RunId run = *record.run().run();
    expectWhole(window.session().path(), run, shown);
    if (comesBack) {
        board->plugIn();
        QTRY_VERIFY_WITH_TIMEOUT(record.run().link().samples > shown + 20, kPatienceMs);
        QTRY_VERIFY(!record.banners().holds(QStringLiteral("absence")));
        QCOMPARE(record.view().marks().gaps.size(), std::size_t(1));
    }
    QVERIFY(window.stopRecording());
    QVERIFY2(window.said(Step::Record).what.startsWith("Run 1 was stopped at"),
             qPrintable(window.said(Step::Record).what));
    const RunRecord kept = *window.session().run(run);
    QCOMPARE(kept.state, RunState::Complete);
    QVERIFY(comesBack ? kept.samples > shown : kept.samples == shown);
    expectWhole(window.session().path(), run, kept.samples);
    QCOMPARE(window.session().file().gaps(run)->size(), std::size_t(comesBack ? 1 : 0));
    // A bridge that is not there can't be recorded, and that is said where it was asked for.
    if (!comesBack) {
        QTRY_COMPARE_WITH_TIMEOUT(window.bench->acquisition().state(), Acquisition::State::Idle, kPatienceMs);
        record.startRecording();
        QTRY_COMPARE_WITH_TIMEOUT(window.said(Step::Record).what, QString("The source has ended."),
                                  kPatienceMs);
        QVERIFY(!window.said(Step::Record).toDo.isEmpty());
        board->plugIn();
    }
    QTRY_COMPARE_WITH_TIMEOUT(window.bench->acquisition().state(), Acquisition::State::Idle, kPatienceMs);
    QVERIFY(window.startRecording());
    QVERIFY(window.stopRecording());
    QCOMPARE(window.session().runs().size(), std::size_t(2));
    QCOMPARE(window.session().runs().back().state, RunState::Complete);
    expectWhole(window.session().path(), window.session().runs().back().id,
                window.session().runs().back().samples);
}

void TestGuiFaultsDevice::statusBar_whileRecording_saysDroppedOnce()
{
    const PluggedBoard board(20.0);
    BoardWindow window(board, 0);
    const auto *status = window.main().findChild<StatusLine *>();
    const auto said = [status] { return status->parts().filter(QStringLiteral("dropped")); };
    QVERIFY(window.startRecording());
    QTRY_VERIFY_WITH_TIMEOUT(said().value(0).endsWith(QStringLiteral("0 dropped")), kPatienceMs);
    QCOMPARE(said().size(), 1);
    board->inject([](SimulatedFaults &faults) { faults.loseReports(2, 3); });
    QTRY_VERIFY_WITH_TIMEOUT(said().value(0).contains(QStringLiteral("dropped of")), kPatienceMs);
    QCOMPARE(said().size(), 1);
    QVERIFY(window.stopRecording());
}

// The link breaks at the moment at which a step is asked of the device: what the window says of the six
// steps, and what is on the device then.
void TestGuiFaultsDevice::unplugged_inEachStepOfAnUpload_isSaidAndAgainWorks()
{
    struct Break
    {
        std::uint8_t report;
        int nth;
        UploadSteps::Step at;
        bool newInUse;
    };
    const Break breaks[] = {{BRIDGE_REPORT_BEGIN, 1, UploadSteps::Begin, false},
                            {BRIDGE_REPORT_CHUNK, 3, UploadSteps::Write, false},
                            {BRIDGE_REPORT_READ, 3, UploadSteps::ReadBack, false},
                            {BRIDGE_REPORT_VERIFY, 1, UploadSteps::Verify, false},
                            {BRIDGE_REPORT_COMMIT, 1, UploadSteps::Commit, false},
                            {BRIDGE_REPORT_ACTIVATE, 1, UploadSteps::Activate, false},
                            {BRIDGE_REPORT_CONFIG, 1, UploadSteps::Activate, true}};
    const PluggedBoard board(5.0);
    BoardWindow window(board, 2);
    window.bench->stopSource();
    QVERIFY(window.train());
    window.main().showStep(Step::Export);
    DevicePanel &device = window.exports().device();
    const auto onDevice = [&device] { return device.tables() ? device.tables()->image : std::nullopt; };
    QVERIFY(window.choose("linear") && window.write());
    QCOMPARE(device.steps().state(), UploadSteps::State::Done);
    const std::vector<std::uint8_t> before = window.exports().preview()->image;
    QVERIFY(window.lookSays([&] { return onDevice() == before; }));
    QVERIFY(window.choose("cubic"));
    const std::vector<std::uint8_t> after = window.exports().preview()->image;
    QVERIFY(after != before);
    for (const Break &each : breaks) {
        const QByteArray name = QByteArray::number(int(each.report), 16);
        board.cutAtSet(each.report, each.nth);
        QVERIFY2(window.write(), name);
        QCOMPARE(device.steps().state(), UploadSteps::State::Failed);
        QVERIFY2(device.steps().current() == each.at,
                 name + " stands at step " + QByteArray::number(device.steps().current()));
        QCOMPARE(window.said(Step::Export).kind, BannerKind::Bad);
        QCOMPARE(window.said(Step::Export).what, each.at == UploadSteps::Activate
                                                     ? QString("The activation was not confirmed.")
                                                     : QString("The table was not written."));
        QVERIFY(window.said(Step::Export).toDo.contains(QStringLiteral("unplugged")));
        // Of a device that is away nothing is claimed.
        QVERIFY(window.lookSays([&] { return !device.problem().isEmpty(); }));
        QVERIFY(!device.tables() && !device.canWrite() && !window.exports().writeAction()->isEnabled());
        QVERIFY(device.steps().isVisible());
        QCOMPARE(device.comparison().model()->index(0, 1).data().toString(), QString("not known"));
        QCOMPARE(window.session().uploads().size(), std::size_t(1));
        if (each.report == BRIDGE_REPORT_CHUNK)
            window.expectUsable();
        board->plugIn();
        if (each.report != BRIDGE_REPORT_CHUNK) // else by itself, as soon as the watch has seen it
            device.look();
        if (!window.deviceKnown())
            QFAIL(name + ": " + device.problem().toUtf8());
        QVERIFY2(onDevice() == (each.newInUse ? after : before), name);
    }
    QVERIFY(window.write());
    QCOMPARE(device.steps().state(), UploadSteps::State::Done);
    QCOMPARE(window.session().uploads().size(), std::size_t(2));
    const UploadRecord made = window.session().uploads().back();
    QVERIFY(made.verified && made.activated);
    QCOMPARE(made.crc32, deviceImageCrc(after));
    QVERIFY(window.lookSays([&] { return onDevice() == after; }));
    window.expectUsable();
}

void TestGuiFaultsDevice::watchedBridge_exportEntered_isLetGo()
{
    const PluggedBoard board(20.0);
    BoardWindow window(board, 2);
    window.main().showStep(Step::Source);
    QVERIFY(window.bench->startSource(SourceUse::Watch));
    QTRY_COMPARE_WITH_TIMEOUT(window.bench->acquisition().state(), Acquisition::State::Running, kPatienceMs);
    window.main().showStep(Step::Export);
    QTRY_COMPARE_WITH_TIMEOUT(window.bench->acquisition().state(), Acquisition::State::Idle, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(window.exports().device().tables().has_value(), kPatienceMs);
}

void TestGuiFaultsDevice::tour_bridgeUnplugged_saysSoAndGoesOn()
{
    FaultyWindow window(0);
    GuidedTour &tour = window.main().tour();
    tour.start(); // in the session as it is
    tour.next();
    QTRY_COMPARE_WITH_TIMEOUT(tour.at(), int(Step::Plan), kPatienceMs);
    tour.skip(); // the plan is there
    window.chooseSimulated(20.0);
    auto &record = window.page<RecordPage>(Step::Record);
    tour.next();
    QTRY_VERIFY_WITH_TIMEOUT(record.run().isRecording() && record.run().hasSamples(), kPatienceMs);
    const auto board = window.bench->simulatedBoard();
    board->unplug();
    QTRY_VERIFY_WITH_TIMEOUT(!tour.trouble().isEmpty(), kPatienceMs);
    QVERIFY(tour.trouble().contains(QStringLiteral("unplugged")));
    QVERIFY(!tour.isWorking());
    tour.next(); // it is still away
    QVERIFY(!tour.isWorking() && !tour.trouble().isEmpty());
    window.expectUsable();
    QCOMPARE(tour.at(), int(Step::Record));
    const std::int64_t samples = record.run().link().samples;
    board->plugIn();
    QTRY_VERIFY_WITH_TIMEOUT(record.run().link().samples > samples, kPatienceMs);
    tour.next();
    QVERIFY(tour.isWorking() && tour.trouble().isEmpty());
    QVERIFY(window.bench->acquisition().isRecording()); // the same run
    board->unplug();
    QTRY_VERIFY_WITH_TIMEOUT(!tour.trouble().isEmpty(), kPatienceMs);
    tour.stop();
    QVERIFY(!tour.isActive());
    record.stopRecording();
    QTRY_VERIFY_WITH_TIMEOUT(!window.bench->acquisition().isRecording(), kPatienceMs);
    QCOMPARE(window.session().runs().front().state, RunState::Complete);
    window.expectUsable();
}

void TestGuiFaultsDevice::tour_flashDamaged_saysSoAndIsRepeated()
{
    FaultyWindow window(2);
    QVERIFY(window.train());
    ExportChoice choice = window.session().exportChoice();
    choice.model = "cubic";
    choice.options.force = true;
    QVERIFY(window.session().setExportChoice(choice).ok());
    GuidedTour &tour = window.main().tour();
    const std::filesystem::path flash = window.folder() / "simulated-bridge.flash";
    QFile damaged(QString::fromStdString(flash.string()));
    QVERIFY(damaged.open(QIODevice::WriteOnly));
    damaged.write("no flash");
    damaged.close();
    tour.start();
    for (int step = 0; step < int(Step::Export); ++step)
        tour.skip();
    QCOMPARE(window.main().currentStep(), Step::Export);
    tour.next();
    QTRY_VERIFY_WITH_TIMEOUT(!tour.isWorking(), kPatienceMs);
    QVERIFY2(tour.trouble().contains(QStringLiteral("simulated-bridge.flash")), qPrintable(tour.trouble()));
    window.expectUsable();
    QVERIFY(damaged.remove());
    window.chooseSimulated(1.0); // on the Source page another one was looked at
    QTRY_VERIFY_WITH_TIMEOUT(window.page<ExportPage>(Step::Export).device().canWrite(), kPatienceMs);
    tour.next();
    QTRY_VERIFY2_WITH_TIMEOUT(!tour.isActive(), qPrintable(tour.trouble()), kPatienceMs); // done
    QVERIFY(window.session().uploads().back().verified);
}

QTEST_MAIN(TestGuiFaultsDevice)
#include "tst_gui_faults_device.moc"
