// A source on its own thread: what it gives arrives in order, recorded or not, and nothing reaches an object
// that is gone.
#include "app/session/acquisition.h"
#include "app/session/sample_columns.h"
#include "app/session/session_source.h"
#include "support/scripted_source.h"

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <thread>

using namespace driftbench;
using namespace driftbench::test;

class TestSessionAcquisition : public QObject
{
    Q_OBJECT

private slots:
    void start_script_arrivesInOrder();
    void start_openingFails_finishedWithTheError();
    void start_sourceFails_samplesBeforeItArrive();
    void start_whileRunning_isRefused();
    void stop_endlessSource_ends();
    void stop_whileOpening_neverStarts();
    void destroyed_whileRunning_neverCallsBack();
    void destroyed_inItsOwnSignal_isSafe();
    void recording_partOfAStream_startsAtZeroAndHoldsThatPart();
    void recording_endOfSource_isFinished();
    void recording_continued_isOneRunWithAGap();
    void recording_memoryFull_endsWithAnErrorAndTheStreamGoesOn();
    void recording_withoutASource_isRefused();
    void sourceOpener_simulatedBridge_streams();
};

namespace {

// Everything that arrived, as it arrived.
struct Watcher : QObject
{
    explicit Watcher(Acquisition &acquisition)
    {
        connect(&acquisition, &Acquisition::started, this, [this](const SourceInfo &info) {
            order += "s";
            name = info.name;
        });
        connect(&acquisition, &Acquisition::batch, this,
                [this](const std::shared_ptr<const SampleBlock> &block) {
                    order += "b";
                    if (block->firstSample != samples)
                        inOrder = false;
                    for (Eigen::Index i = 0; i < block->size(); ++i) {
                        if (block->temperatureC[i] != static_cast<double>(samples + i) ||
                            block->rateDps(i, 1) != -block->temperatureC[i])
                            inOrder = false;
                    }
                    samples += block->size();
                });
        connect(&acquisition, &Acquisition::gap, this, [this](const SampleGap &) {
            order += "g";
            samplesAtGap = samples;
        });
        connect(&acquisition, &Acquisition::sourceSaid, this, [this](const QString &) { order += "e"; });
        connect(&acquisition, &Acquisition::finished, this, [this](const Result<SourceStats> &result) {
            order += "f";
            outcome = result;
        });
        connect(&acquisition, &Acquisition::recordingFinished, this,
                [this](RunId, const Status &status) { recorded = status; });
    }

    // Batches in a row are one.
    QString events() const
    {
        QString text = order;
        while (text.contains("bb"))
            text.replace("bb", "b");
        return text;
    }

    QString order;
    std::string name;
    std::int64_t samples = 0;
    std::int64_t samplesAtGap = -1;
    bool inOrder = true;
    std::optional<Result<SourceStats>> outcome;
    std::optional<Status> recorded;
};

Acquisition::OpenSource opening(std::vector<ScriptStep> script, bool endless)
{
    return [script = std::move(script), endless]() -> Result<std::unique_ptr<SampleSource>> {
        return std::unique_ptr<SampleSource>(std::make_unique<ScriptedSource>(script, endless));
    };
}

const std::vector<ScriptStep> kSteady{ScriptedSamples{10}, ScriptedWait{std::chrono::milliseconds(2)}};

SessionFile newFile(const QTemporaryDir &folder)
{
    auto file = SessionFile::create(folder.filePath("s.driftbench").toStdString());
    if (!file)
        qFatal("%s", file.error().message.c_str());
    return std::move(file).value();
}

} // namespace

void TestSessionAcquisition::start_script_arrivesInOrder()
{
    Acquisition acquisition;
    Watcher watcher(acquisition);
    const SampleGap gap{0.7, 0.9, 200, GapCause::ReportsLost};
    QVERIFY(acquisition.start(opening({ScriptedSamples{300}, ScriptedSamples{400}, gap, ScriptedSamples{55},
                                       std::string("saturated on x"),
                                       ScriptedWait{std::chrono::milliseconds(90)}, ScriptedSamples{45}},
                                      false)));
    QCOMPARE(acquisition.state(), Acquisition::State::Opening);
    QTRY_VERIFY(watcher.outcome);
    QCOMPARE(watcher.events(), QString("sbgbebf"));
    QVERIFY(watcher.inOrder);
    QCOMPARE(watcher.samples, 800);
    QCOMPARE(watcher.samplesAtGap, 700);
    QVERIFY(watcher.outcome->ok());
    QCOMPARE((*watcher.outcome)->samples, 800);
    QCOMPARE(watcher.name, std::string("script"));
    QCOMPARE(acquisition.state(), Acquisition::State::Idle);
}

void TestSessionAcquisition::start_openingFails_finishedWithTheError()
{
    Acquisition acquisition;
    Watcher watcher(acquisition);
    QVERIFY(acquisition.start([]() -> Result<std::unique_ptr<SampleSource>> {
        return Error{Errc::DeviceNotFound, "No bridge is plugged in."};
    }));
    QTRY_VERIFY(watcher.outcome);
    QCOMPARE(watcher.outcome->error().code, Errc::DeviceNotFound);
    QCOMPARE(watcher.order, QString("f"));
    QCOMPARE(acquisition.state(), Acquisition::State::Idle);
    QVERIFY(acquisition.start(opening({ScriptedSamples{1}}, false)));
    QTRY_COMPARE(watcher.order, QString("fsbf"));
}

void TestSessionAcquisition::start_sourceFails_samplesBeforeItArrive()
{
    Acquisition acquisition;
    Watcher watcher(acquisition);
    acquisition.start(opening({ScriptedSamples{20}, Error{Errc::DeviceUnplugged, "Gone."}}, false));
    QTRY_VERIFY(watcher.outcome);
    QCOMPARE(watcher.order, QString("sbf"));
    QCOMPARE(watcher.samples, 20);
    QCOMPARE(watcher.outcome->error().code, Errc::DeviceUnplugged);
}

void TestSessionAcquisition::start_whileRunning_isRefused()
{
    Acquisition acquisition;
    Watcher watcher(acquisition);
    QVERIFY(acquisition.start(opening(kSteady, true)));
    QVERIFY(!acquisition.start(opening(kSteady, true)));
    QTRY_VERIFY(watcher.samples > 0);
    QVERIFY(!acquisition.start(opening(kSteady, true)));
    acquisition.stop();
    QCOMPARE(acquisition.state(), Acquisition::State::Stopping);
    QVERIFY(!acquisition.start(opening(kSteady, true)));
    QTRY_VERIFY(watcher.outcome);
}

void TestSessionAcquisition::stop_endlessSource_ends()
{
    Acquisition acquisition;
    Watcher watcher(acquisition);
    acquisition.start(opening(kSteady, true));
    QTRY_VERIFY(watcher.samples > 100);
    acquisition.stop();
    QTRY_VERIFY(watcher.outcome);
    QVERIFY(watcher.inOrder);
    QCOMPARE((*watcher.outcome)->samples, watcher.samples);
}

// Who starts the next source then would take it for that one.
void TestSessionAcquisition::stop_whileOpening_neverStarts()
{
    Acquisition acquisition;
    const Watcher watcher(acquisition);
    const auto open = opening(kSteady, true);
    const auto mayOpen = std::make_shared<std::atomic<bool>>(false);
    QVERIFY(acquisition.start([open, mayOpen] {
        while (!*mayOpen)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return open();
    }));
    acquisition.stop();
    QCOMPARE(acquisition.state(), Acquisition::State::Stopping);
    *mayOpen = true;
    QTRY_VERIFY(watcher.outcome);
    QVERIFY(!watcher.order.contains('s'));
    QCOMPARE(acquisition.state(), Acquisition::State::Idle);
}

void TestSessionAcquisition::destroyed_whileRunning_neverCallsBack()
{
    for (int i = 0; i < 40; ++i) {
        auto acquisition = std::make_unique<Acquisition>();
        int calls = 0;
        const auto count = [&calls](auto &&...) { ++calls; };
        connect(acquisition.get(), &Acquisition::batch, this, count);
        connect(acquisition.get(), &Acquisition::started, this, count);
        connect(acquisition.get(), &Acquisition::finished, this, count);
        acquisition->start(opening({ScriptedSamples{5}}, true));
        if (i % 2 == 0)
            QTest::qWait(i % 5);
        acquisition.reset();
        const int before = calls;
        QCoreApplication::processEvents();
        QCOMPARE(calls, before);
    }
}

void TestSessionAcquisition::destroyed_inItsOwnSignal_isSafe()
{
    auto *acquisition = new Acquisition;
    bool isGone = false;
    connect(acquisition, &Acquisition::batch, this, [&acquisition] {
        if (acquisition)
            acquisition->deleteLater();
        acquisition = nullptr;
    });
    connect(acquisition, &QObject::destroyed, this, [&isGone] { isGone = true; });
    acquisition->start(opening(kSteady, true));
    QTRY_VERIFY(isGone);
}

void TestSessionAcquisition::recording_partOfAStream_startsAtZeroAndHoldsThatPart()
{
    const QTemporaryDir folder;
    const SessionFile file = newFile(folder);
    Acquisition acquisition;
    Watcher watcher(acquisition);
    acquisition.start(opening(kSteady, true));
    QTRY_VERIFY(watcher.samples > 50);
    QVERIFY(acquisition.startRecording(file, "heating"));
    QVERIFY(acquisition.isRecording());
    QCOMPARE(acquisition.startRecording(file, "twice").error().code, Errc::InvalidOption);
    const RunId run = *acquisition.recordingRun();
    const std::int64_t from = watcher.samples;
    QTRY_VERIFY(watcher.samples > from + 1000); // more than can be under way
    acquisition.stopRecording();
    QTRY_VERIFY(watcher.recorded);
    QVERIFY(watcher.recorded->ok());
    const std::int64_t then = watcher.samples;
    QTRY_VERIFY2(watcher.samples > then, "the source goes on");
    acquisition.stop();
    QTRY_VERIFY(watcher.outcome);
    QVERIFY(watcher.inOrder);

    const auto recorded = file.readRun(run);
    QVERIFY(recorded);
    QVERIFY(recorded->size() >= 150);
    QCOMPARE(recorded->timeS[0], 0.0);
    QVERIFY2(recorded->temperatureC[0] >= 50.0, "nothing from before");
    for (Eigen::Index i = 1; i < recorded->size(); ++i) {
        QCOMPARE(recorded->temperatureC[i], recorded->temperatureC[i - 1] + 1.0);
        QVERIFY(qAbs(recorded->timeS[i] - static_cast<double>(i) / 1000.0) < 1e-9);
    }
    const auto record = file.run(run);
    QVERIFY(record);
    QCOMPARE(record->state, RunState::Complete);
    QCOMPARE(record->description.name, std::string("heating"));
    QCOMPARE(record->description.sensor.serial, std::string("T-1"));
}

void TestSessionAcquisition::recording_endOfSource_isFinished()
{
    const QTemporaryDir folder;
    const SessionFile file = newFile(folder);
    Acquisition acquisition;
    Watcher watcher(acquisition);
    connect(&acquisition, &Acquisition::started, this,
            [&] { QVERIFY(acquisition.startRecording(file, "run")); });
    const std::vector<ScriptStep> script{ScriptedWait{std::chrono::milliseconds(100)}, ScriptedSamples{500},
                                         SampleGap{0.499, 0.7, 200, GapCause::ReportsLost},
                                         ScriptedSamples{500}, Error{Errc::DeviceUnplugged, "Gone."}};
    acquisition.start(opening(script, false));
    QTRY_VERIFY(watcher.recorded);
    QVERIFY(watcher.recorded->ok());
    QVERIFY(watcher.outcome && !watcher.outcome->ok());
    QVERIFY(!acquisition.isRecording());
    const auto runs = file.runs();
    QVERIFY(runs);
    QCOMPARE(runs->size(), std::size_t(1));
    QCOMPARE(runs->front().samples, 1000);
    QCOMPARE(runs->front().state, RunState::Complete);
    QCOMPARE(file.gaps(runs->front().id)->size(), std::size_t(1));
}

void TestSessionAcquisition::recording_continued_isOneRunWithAGap()
{
    const QTemporaryDir folder;
    const SessionFile file = newFile(folder);
    std::optional<RunId> run;
    for (int part = 0; part < 2; ++part) {
        Acquisition acquisition;
        Watcher watcher(acquisition);
        connect(&acquisition, &Acquisition::started, this, [&] {
            const Status begun =
                run ? acquisition.continueRecording(file, *run) : acquisition.startRecording(file, "run");
            QVERIFY2(begun, begun ? "" : begun.error().message.c_str());
            run = acquisition.recordingRun();
        });
        acquisition.start(
            opening({ScriptedWait{std::chrono::milliseconds(100)}, ScriptedSamples{300}}, false));
        QTRY_VERIFY(watcher.recorded);
        QVERIFY(watcher.recorded->ok());
    }
    const auto recorded = file.readRun(*run);
    QVERIFY(recorded);
    QCOMPARE(recorded->size(), 600);
    for (Eigen::Index i = 1; i < recorded->size(); ++i)
        QVERIFY(recorded->timeS[i] > recorded->timeS[i - 1]);
    const auto gaps = file.gaps(*run);
    QCOMPARE(gaps->size(), std::size_t(1));
    QCOMPARE(gaps->front().gap.cause, GapCause::Interrupted);
    QCOMPARE(gaps->front().beforeSample, 300);
}

void TestSessionAcquisition::recording_memoryFull_endsWithAnErrorAndTheStreamGoesOn()
{
    const QTemporaryDir folder;
    const SessionFile file = newFile(folder);
    Acquisition acquisition;
    Watcher watcher(acquisition);
    RecorderOptions options;
    options.memoryBoundBytes = 100 * kSampleBytes;
    options.commitEveryS = 5.0;
    connect(&acquisition, &Acquisition::started, this,
            [&] { QVERIFY(acquisition.startRecording(file, "run", options)); });
    acquisition.start(opening(kSteady, true));
    QTRY_VERIFY(watcher.recorded);
    const std::int64_t then = watcher.samples;
    QTRY_VERIFY(watcher.samples > then);
    acquisition.stop();
    QTRY_VERIFY(watcher.outcome);
    QVERIFY(watcher.outcome->ok());
}

void TestSessionAcquisition::recording_withoutASource_isRefused()
{
    const QTemporaryDir folder;
    const SessionFile file = newFile(folder);
    Acquisition acquisition;
    QCOMPARE(acquisition.startRecording(file, "run").error().code, Errc::InvalidOption);
    QVERIFY(!acquisition.isRecording());
    QVERIFY(!acquisition.recordingRun());
    QVERIFY(!acquisition.finishAgain());
}

void TestSessionAcquisition::sourceOpener_simulatedBridge_streams()
{
    auto choice = parseSourceChoice("simulated:L3GD20H");
    QVERIFY(choice);
    choice->as<SimulatedChoice>()->speed = 0.0;
    choice->rateHz = 100.0;
    Acquisition acquisition;
    std::int64_t samples = 0;
    std::optional<Result<SourceStats>> outcome;
    connect(&acquisition, &Acquisition::batch, this,
            [&samples](const std::shared_ptr<const SampleBlock> &block) { samples += block->size(); });
    connect(&acquisition, &Acquisition::finished, this,
            [&outcome](const Result<SourceStats> &result) { outcome = result; });
    acquisition.start(sourceOpener(*choice));
    QTRY_VERIFY(samples > 500);
    QVERIFY(acquisition.info());
    QVERIFY(acquisition.info()->simulated);
    acquisition.stop();
    QTRY_VERIFY(outcome);
    QVERIFY(outcome->ok());
}

QTEST_GUILESS_MAIN(TestSessionAcquisition)
#include "tst_session_acquisition.moc"
