// The recorder: everything arrives, in order; interrupted runs are found and gone on with.
#include "app/session/run_recorder.h"
#include "app/session/session_file.h"
#include "app/session/session_lock.h"
#include "device/bridge/bridge_source.h"
#include "support/cli_process.h"
#include "support/session_data.h"
#include "support/simulated_device.h"

#include <QTest>

#include <atomic>
#include <chrono>
#include <thread>

using namespace driftbench;
using namespace driftbench::test;

class TestSessionRecorder : public QObject
{
    Q_OBJECT

private slots:
    void samples_manyBlocks_areAllThereInOrder();
    void samples_slowSensor_doNotBecomeCrumbs();
    void samples_whileItRecords_areReadByAnother();
    void finish_slowDisk_isReported();
    void start_readOnlyFile_isRefused();
    void source_simulatedBridge_isRecordedWhole();
    void open_afterACrash_marksTheRunInterrupted();
    void runs_readOnly_areRecordedAsLongAsSomebodyWrites();
    void lock_askedForAllTheTime_canBeTaken();
    void resume_interruptedRun_goesOnBehindAGap();
    void resume_anotherSensor_isRefused();
};

namespace {

SessionFile newSession()
{
    auto made = SessionFile::create(newSessionPath());
    if (!made)
        qFatal("%s", made.error().message.c_str());
    return std::move(*made);
}

// As it stands on the disk now, as a crash would leave it.
std::filesystem::path crashedCopy(const std::filesystem::path &path)
{
    const auto copy = newSessionPath();
    for (const char *ending : {"", "-wal"}) {
        const std::filesystem::path from = path.string() + ending;
        if (std::filesystem::exists(from))
            std::filesystem::copy_file(from, copy.string() + ending);
    }
    return copy;
}

void waitUntilWritten(const RunRecorder &recorder)
{
    QTRY_COMPARE_WITH_TIMEOUT(recorder.stats().queued(), std::int64_t{0}, 30000);
}

Result<std::unique_ptr<BridgeSource>> simulatedSource(const std::shared_ptr<SimulatedBoard> &board)
{
    BridgeSourceOptions options;
    options.rateHz = 1000.0;
    return BridgeSource::open(*SimulatedBridge::open(board), board->clock(), options);
}

} // namespace

void TestSessionRecorder::samples_manyBlocks_areAllThereInOrder()
{
    auto file = newSession();
    Random random(4);
    const Recording recording = randomRecording(31, 60000);
    RecorderOptions options;
    options.commitEveryS = 0.002;
    auto recorder = *RunRecorder::start(file, describeSource(sourceOf(recording, 100.0), "run"), options);
    std::vector<std::int64_t> marks;
    for (Eigen::Index at = 0; at < recording.size();) {
        const auto count =
            std::min<Eigen::Index>(1 + static_cast<Eigen::Index>(random.below(900)), recording.size() - at);
        QVERIFY(recorder->samples(blockOf(recording, at, count), count) == Flow::Continue);
        at += count;
        if (random.below(6) == 0) {
            recorder->gap({1.0, 2.0, 17, GapCause::DeviceOverrun});
            recorder->event("Something happened.");
            marks.push_back(at);
        }
        if (random.below(4) == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(3));
    }
    QVERIFY(recorder->finish().ok());
    QVERIFY(recorder->finish().ok()); // again does nothing
    const RecorderStats stats = recorder->stats();
    QCOMPARE(stats.taken, recording.size());
    QCOMPARE(stats.written, recording.size());
    QVERIFY(stats.commits > 1);
    QCOMPARE(stats.failedCommits, std::int64_t{0});
    QVERIFY(sameSamples(*file.readRun(recorder->run()), recording));
    QVERIFY(file.run(recorder->run())->state == RunState::Complete);
    const auto gaps = *file.gaps(recorder->run());
    const auto events = *file.events(recorder->run());
    QCOMPARE(gaps.size(), marks.size());
    QCOMPARE(events.size(), marks.size());
    for (std::size_t i = 0; i < marks.size(); ++i) {
        QCOMPARE(gaps[i].beforeSample, marks[i]);
        QCOMPARE(gaps[i].gap.lostSamples, std::int64_t{17});
        QVERIFY(gaps[i].gap.cause == GapCause::DeviceOverrun);
        QCOMPARE(events[i].atSample, marks[i]);
    }
    QVERIFY(file.check()->empty());
}

void TestSessionRecorder::samples_slowSensor_doNotBecomeCrumbs()
{
    auto file = newSession();
    const Recording recording = measuredRecording(3, 600, 10.0);
    RecorderOptions options;
    options.commitEveryS = 0.001;
    auto recorder = *RunRecorder::start(file, describeSource(sourceOf(recording, 10.0), "run"), options);
    for (Eigen::Index at = 0; at < 600; at += 6) {
        recorder->samples(blockOf(recording, at, 6), 6);
        waitUntilWritten(*recorder);
        QVERIFY(*file.database().integer("SELECT count(*) FROM chunk") <= 32);
    }
    QCOMPARE(recorder->stats().commits, std::int64_t{100});
    QVERIFY(recorder->finish().ok());
    QCOMPARE(*file.database().integer("SELECT count(*) FROM chunk"), std::int64_t{1});
    QVERIFY(sameSamples(*file.readRun(recorder->run()), recording));
}

void TestSessionRecorder::samples_whileItRecords_areReadByAnother()
{
    auto file = newSession();
    const Recording recording = measuredRecording(9, 40000, 1000.0);
    RecorderOptions options;
    options.commitEveryS = 0.001;
    auto recorder = *RunRecorder::start(file, describeSource(sourceOf(recording, 1000.0), "run"), options);
    const RunId run = recorder->run();
    std::atomic<bool> wrong = false;
    {
        // Whatever moment a reader sees, it is a whole beginning of the run.
        const std::jthread reader(
            [&, own = std::make_shared<SessionFile>(*file.another())](const std::stop_token &stop) {
                while (!stop.stop_requested()) {
                    const auto part = own->readRun(run);
                    wrong = wrong || !part.ok() || !sameSamples(*part, rowsOf(recording, 0, part->size()));
                }
            });
        const std::jthread watcher([&](const std::stop_token &stop) {
            while (!stop.stop_requested())
                wrong = wrong || recorder->stats().queued() < 0;
        });
        for (Eigen::Index at = 0; at < recording.size(); at += 400) {
            recorder->samples(blockOf(recording, at, 400), 400);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        QVERIFY(file.setDocument("view", "written beside it").ok());
        QVERIFY(recorder->finish().ok());
    }
    QVERIFY(!wrong);
    QVERIFY(sameSamples(*file.readRun(run), recording));
}

void TestSessionRecorder::finish_slowDisk_isReported()
{
    auto file = newSession();
    const Recording recording = measuredRecording(9, 300, 1000.0);
    std::vector<RecorderEventKind> kinds;
    RecorderOptions options;
    options.commitEveryS = 1000.0;
    options.slowAfterS = 0.01;
    options.onEvent = [&](const RecorderEvent &event) { kinds.push_back(event.kind); };
    auto recorder = *RunRecorder::start(file, describeSource(sourceOf(recording, 1000.0), "run"), options);
    recorder->samples(blockOf(recording, 0, 100), 100);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    recorder->samples(blockOf(recording, 100, 100), 100);
    recorder->samples(blockOf(recording, 200, 100), 100);
    QCOMPARE(kinds, std::vector<RecorderEventKind>{RecorderEventKind::Slow});
    QVERIFY(recorder->stats().lastCommitAgeS > 0.01);
    QVERIFY(recorder->finish().ok());
    QVERIFY(sameSamples(*file.readRun(recorder->run()), recording));
}

void TestSessionRecorder::start_readOnlyFile_isRefused()
{
    const auto path = newSessionPath();
    QVERIFY(SessionFile::create(path).ok());
    const auto file = SessionFile::open(path, SessionAccess::ReadOnly);
    QCOMPARE(RunRecorder::start(*file, {}).error().code, Errc::SessionReadOnly);
    QCOMPARE(RunRecorder::resume(*file, 1, {}).error().code, Errc::SessionReadOnly);
}

void TestSessionRecorder::source_simulatedBridge_isRecordedWhole()
{
    auto file = newSession();
    const auto board = *SimulatedBoard::create(quickBoard(20.0));
    const auto source = *simulatedSource(board);
    auto recorder = *RunRecorder::start(file, describeSource(source->info(), "run"));
    const auto stats = source->run(*recorder, {});
    QVERIFY(stats.ok());
    QVERIFY(recorder->finish().ok());
    const auto record = file.run(recorder->run());
    QCOMPARE(record->samples, stats->samples);
    QVERIFY(record->samples >= 19000);
    QCOMPARE(record->description.sensor.serial, std::string("SIM-0001"));
    QCOMPARE(record->description.sampleRateHz, 1000.0);
    QVERIFY(record->description.simulated);
    // Counts, hundredths of degrees and a clock in microseconds.
    const auto bytes =
        *file.database().integer("SELECT sum(length(time) + length(temperature) + length(rate_x) +"
                                 " length(rate_y) + length(rate_z)) FROM chunk");
    QVERIFY(bytes < 16 * record->samples);
}

void TestSessionRecorder::open_afterACrash_marksTheRunInterrupted()
{
    auto file = newSession();
    const Recording recording = measuredRecording(1, 2000, 1000.0);
    RecorderOptions options;
    options.commitEveryS = 0.001;
    auto recorder = *RunRecorder::start(file, describeSource(sourceOf(recording, 1000.0), "run"), options);
    recorder->samples(blockOf(recording, 0, 1500), 1500);
    waitUntilWritten(*recorder);
    const auto path = crashedCopy(file.path());
    const auto asIs = SessionFile::open(path, SessionAccess::ReadOnly);
    QVERIFY(asIs.ok());
    QVERIFY(asIs->run(recorder->run())->state == RunState::Interrupted);
    const auto again = SessionFile::open(path, SessionAccess::ReadWrite);
    QVERIFY(again.ok());
    QCOMPARE(again->recovered(), std::vector<RunId>{recorder->run()});
    QVERIFY(again->run(recorder->run())->state == RunState::Interrupted);
    QVERIFY(!again->run(recorder->run())->endedUtc.empty());
    QVERIFY(sameSamples(*again->readRun(recorder->run()), rowsOf(recording, 0, 1500)));
    QCOMPARE(again->events()->back().kind, std::string("recovery"));
    QCOMPARE(again->events()->back().atSample, std::int64_t{1500});
    QVERIFY(again->check()->empty());
}

void TestSessionRecorder::runs_readOnly_areRecordedAsLongAsSomebodyWrites()
{
    std::optional<SessionFile> file = newSession();
    const auto path = file->path();
    const Recording recording = measuredRecording(1, 2000, 1000.0);
    auto recorder = *RunRecorder::start(*file, describeSource(sourceOf(recording, 1000.0), "run"));
    recorder->samples(blockOf(recording, 0, 1500), 1500);
    const RunId run = recorder->run();
    const auto reader = SessionFile::open(path, SessionAccess::ReadOnly);
    QVERIFY(reader->runs()->front().state == RunState::Recording);
    QVERIFY(reader->run(run)->state == RunState::Recording);
    QVERIFY(recorder->finish().ok());
    QVERIFY(reader->run(run)->state == RunState::Complete);
    recorder.reset();
    // A program that ended before it could say so, and a lock file that was left by it.
    QVERIFY(file->database().run("UPDATE run SET state = 'recording'").ok());
    QVERIFY(reader->run(run)->state == RunState::Recording);
    file.reset();
    QVERIFY(reader->run(run)->state == RunState::Interrupted);
    writeBytes(QString::fromStdString(path.string() + "-lock"), "12345");
    QVERIFY(reader->runs()->front().state == RunState::Interrupted);
}

void TestSessionRecorder::lock_askedForAllTheTime_canBeTaken()
{
    const auto path = newSessionPath();
    QVERIFY(SessionFile::create(path).ok());
    std::atomic<int> held = 0;
    std::atomic<int> notHeld = 0;
    const std::jthread asking([&](const std::stop_token &stop) {
        while (!stop.stop_requested())
            ++(SessionLock::isHeld(path) ? held : notHeld);
    });
    for (int i = 0; i < 50 || held == 0 || notHeld == 0; ++i)
        QVERIFY(SessionLock::acquire(path).ok());
}

void TestSessionRecorder::resume_interruptedRun_goesOnBehindAGap()
{
    auto file = newSession();
    const Recording recording = measuredRecording(1, 3000, 1000.0);
    const SourceInfo source = sourceOf(recording, 1000.0);
    RunDescription what = describeSource(source, "run");
    what.startedUtc = "2026-01-02T03:04:05.000Z"; // long ago
    auto recorder = *RunRecorder::start(file, what);
    recorder->samples(blockOf(recording, 0, 1500), 1500);
    QVERIFY(recorder->finish().ok());
    const RunId run = recorder->run();
    for (const Eigen::Index from : {1500, 2000}) {
        recorder = *RunRecorder::resume(file, run, source);
        const SampleBlock block = blockOf(measuredRecording(1, 3000, 1000.0), from, 500);
        recorder->samples(block, 500);
        recorder->gap({block.timeS[0], block.timeS[499], 3, GapCause::ReportsLost});
        QVERIFY(recorder->finish().ok());
    }
    const auto back = *file.readRun(run);
    QCOMPARE(back.size(), Eigen::Index{2500});
    QVERIFY(sameBits(back.rateDps, Eigen::MatrixX3d(recording.rateDps.topRows(2500))));
    for (Eigen::Index i = 1; i < back.size(); ++i)
        QVERIFY(back.timeS[i] > back.timeS[i - 1]);
    const auto gaps = *file.gaps(run);
    QCOMPARE(gaps.size(), std::size_t{4});
    QVERIFY(gaps[0].gap.cause == GapCause::Interrupted);
    QCOMPARE(gaps[0].beforeSample, std::int64_t{1500});
    QCOMPARE(gaps[0].gap.startS, back.timeS[1499]);
    QCOMPARE(gaps[0].gap.endS, back.timeS[1500]);
    QVERIFY(gaps[0].gap.endS - gaps[0].gap.startS > 3600.0);
    QVERIFY(std::abs(static_cast<double>(gaps[0].gap.lostSamples) + 1.0 -
                     (gaps[0].gap.endS - gaps[0].gap.startS) * 1000.0) < 1.0);
    QCOMPARE(gaps[1].gap.startS, back.timeS[1500]); // on the run's clock
    QVERIFY(file.check()->empty());
}

void TestSessionRecorder::resume_anotherSensor_isRefused()
{
    auto file = newSession();
    const Recording recording = measuredRecording(1, 100, 1000.0);
    SourceInfo source = sourceOf(recording, 1000.0);
    auto recorder = *RunRecorder::start(file, describeSource(source, "run"));
    QCOMPARE(RunRecorder::resume(file, recorder->run(), source).error().code, Errc::InvalidOption);
    QVERIFY(recorder->finish().ok());
    source.sensor.serial = "SIM-0002";
    const auto other = RunRecorder::resume(file, recorder->run(), source);
    QCOMPARE(other.error().code, Errc::WrongSensor);
    QVERIFY(other.error().message.find("SIM-0002") != std::string::npos);
    QCOMPARE(RunRecorder::resume(file, 99, source).error().code, Errc::NoSuchRun);
    const RunId imported = *file.importRun(recording, describeRecording(recording.info, "log"));
    QCOMPARE(RunRecorder::resume(file, imported, sourceOf(recording, 1000.0)).error().code,
             Errc::InvalidOption);
}

QTEST_GUILESS_MAIN(TestSessionRecorder)
#include "tst_session_recorder.moc"
