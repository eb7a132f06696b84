// Every write, sync and truncation under a session file fails in turn, in the database and in its log:
// nothing that was reported as written is lost, what was not is tried again, and the file stays whole.
#include "app/session/run_recorder.h"
#include "app/session/session_file.h"
#include "support/cli_process.h"
#include "support/fault_vfs.h"
#include "support/session_data.h"

#include <QTest>

#include <atomic>
#include <thread>

using namespace driftbench;
using namespace driftbench::test;

class TestSessionFaults : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { registerFaultVfs(); }
    void cleanup() { clearFaults(); }

    void finish_operationFails_isToldAndDoneAgain_data() { faults(); }
    void finish_operationFails_isToldAndDoneAgain();
    void crash_behindAFault_leavesAWholeFile_data() { faults(); }
    void crash_behindAFault_leavesAWholeFile();
    void migration_operationFails_leavesAWholeFile_data();
    void migration_operationFails_leavesAWholeFile();
    void recording_diskFullForAWhile_losesNothing();
    void recording_memoryBoundReached_stopsAndKeepsAll();
    void recording_smallDisk_losesNothing();
    void damage_random_isAnErrorOrWhatIsLeft();

private:
    static void faults();
};

namespace {

constexpr double kRateHz = 1000.0;

RecorderOptions byHand()
{
    RecorderOptions options;
    options.commitEveryS = 1000.0; // only finish() commits
    return options;
}

// Two runs with a checkpoint between them; how many of its samples the second has on the disk is left to see.
struct Trial
{
    std::filesystem::path path = newSessionPath();
    Recording recording = measuredRecording(5, 20000, kRateHz);
    std::optional<SessionFile> file;
    RunId first = 0;

    Trial()
    {
        auto made = SessionFile::create(path, {kFaultVfs, "test"});
        if (!made)
            qFatal("%s", made.error().message.c_str());
        file.emplace(std::move(*made));
        first = *file->importRun(rowsOf(recording, 0, 1000), describeRecording(recording.info, "first"));
    }
    void take(RunRecorder &recorder) const
    {
        for (Eigen::Index at = 0; at < recording.size(); at += 1000)
            recorder.samples(blockOf(recording, at, 1000), 1000);
        recorder.event("Saturated on x.");
    }
};

} // namespace

void TestSessionFaults::faults()
{
    QTest::addColumn<int>("fault");
    QTest::newRow("disk full") << static_cast<int>(Fault::DiskFull);
    QTest::newRow("write error") << static_cast<int>(Fault::WriteError);
    QTest::newRow("torn write") << static_cast<int>(Fault::TornWrite);
    QTest::newRow("sync error") << static_cast<int>(Fault::SyncError);
    QTest::newRow("any") << static_cast<int>(Fault::AnyError);
}

void TestSessionFaults::finish_operationFails_isToldAndDoneAgain()
{
    QFETCH(int, fault);
    int failures = 0;
    for (std::int64_t at = 1;; ++at) {
        Trial trial;
        auto recorder = RunRecorder::start(
            *trial.file, describeSource(sourceOf(trial.recording, kRateHz), "second"), byHand());
        QVERIFY(recorder.ok());
        trial.take(**recorder);
        injectFault(static_cast<Fault>(fault), at, false);
        const Status finished = (*recorder)->finish();
        const bool happened = faultHappened();
        clearFaults();
        if (!finished) {
            ++failures;
            QVERIFY(finished.error().code == Errc::OutputFull ||
                    finished.error().code == Errc::OutputNotWritable);
            QVERIFY((*recorder)->finish().ok());
        }
        const auto back = trial.file->readRun((*recorder)->run());
        QVERIFY(back.ok() && sameSamples(*back, trial.recording));
        QVERIFY(trial.file->run((*recorder)->run())->state == RunState::Complete);
        recorder->reset();
        const auto findings = trial.file->check();
        QVERIFY(findings.ok());
        QVERIFY2(findings->empty(), findings->empty() ? "" : findings->front().c_str());
        if (!happened)
            break;
        // Far behind the first commits nothing new comes.
        at += at > 4 ? at / 2 : 0;
    }
    QVERIFY(failures > 0);
}

void TestSessionFaults::crash_behindAFault_leavesAWholeFile()
{
    QFETCH(int, fault);
    for (std::int64_t at = 1;; at += at > 4 ? at / 2 : 1) {
        bool happened = false;
        bool acknowledged = false;
        RunId second = 0;
        std::filesystem::path path;
        Recording recording;
        {
            Trial trial;
            path = trial.path;
            recording = trial.recording;
            auto recorder = RunRecorder::start(
                *trial.file, describeSource(sourceOf(recording, kRateHz), "second"), byHand());
            QVERIFY(recorder.ok());
            second = (*recorder)->run();
            trial.take(**recorder);
            // From here on the disk takes nothing any more, until the program has gone.
            injectFault(static_cast<Fault>(fault), at, true);
            acknowledged = (*recorder)->finish().ok();
            happened = faultHappened();
            recorder->reset();
        }
        clearFaults();
        auto again = SessionFile::open(path, SessionAccess::ReadWrite);
        QVERIFY2(again.ok(), again.ok() ? "" : again.error().message.c_str());
        QVERIFY(again->check()->empty());
        QVERIFY(sameSamples(*again->readRun(1), rowsOf(recording, 0, 1000)));
        const auto record = again->run(second);
        QVERIFY(record.ok());
        if (acknowledged)
            QCOMPARE(record->samples, recording.size());
        const auto back = again->readRun(second);
        QVERIFY(back.ok() && sameSamples(*back, rowsOf(recording, 0, record->samples)));
        if (!happened)
            break;
    }
}

void TestSessionFaults::migration_operationFails_leavesAWholeFile_data()
{
    QTest::addColumn<int>("fault");
    QTest::addColumn<bool>("lasting"); // as behind a crash; else only the one fails
    QTest::addColumn<Eigen::Index>("samples");
    QTest::newRow("disk full") << static_cast<int>(Fault::DiskFull) << true << Eigen::Index{500};
    QTest::newRow("torn write") << static_cast<int>(Fault::TornWrite) << true << Eigen::Index{500};
    QTest::newRow("torn write, once") << static_cast<int>(Fault::TornWrite) << false << Eigen::Index{500};
    QTest::newRow("sync error") << static_cast<int>(Fault::SyncError) << true << Eigen::Index{500};
    QTest::newRow("any, once") << static_cast<int>(Fault::AnyError) << false << Eigen::Index{500};
    QTest::newRow("any") << static_cast<int>(Fault::AnyError) << true << Eigen::Index{40000};
}

void TestSessionFaults::migration_operationFails_leavesAWholeFile()
{
    QFETCH(int, fault);
    QFETCH(bool, lasting);
    QFETCH(Eigen::Index, samples);
    const Recording recording = measuredRecording(3, samples, kRateHz);
    const auto original = newSessionPath();
    QVERIFY(SessionFile::create(original)->importRun(recording, {}).ok());
    makeVersion1(original);
    const RunOverview overview = *SessionFile::open(original, SessionAccess::ReadOnly)->overview(1);
    const auto path = newSessionPath();
    const auto isWhole = [&](SessionAccess access) {
        const auto file = SessionFile::open(path, access);
        return file.ok() && file->check().ok() && file->check()->empty() &&
               sameSamples(*file->readRun(1), recording) && sameOverview(*file->overview(1), overview) &&
               (access == SessionAccess::ReadOnly || file->formatVersion() == kSessionFormatVersion);
    };
    int failures = 0;
    int stillOld = 0;
    for (std::int64_t at = 1;; ++at) {
        std::filesystem::copy_file(original, path, std::filesystem::copy_options::overwrite_existing);
        injectFault(static_cast<Fault>(fault), at, lasting);
        const bool opened = SessionFile::open(path, SessionAccess::ReadWrite, {kFaultVfs, "test"}).ok();
        const bool happened = faultHappened();
        clearFaults();
        failures += opened ? 0 : 1;
        // The file as it was, or brought up to date; and in the end the latter.
        stillOld += SessionFile::open(path, SessionAccess::ReadOnly)->formatVersion() == 1 ? 1 : 0;
        QVERIFY2(isWhole(SessionAccess::ReadOnly), qPrintable(QString("operation %1").arg(at)));
        QVERIFY2(isWhole(SessionAccess::ReadWrite), qPrintable(QString("operation %1").arg(at)));
        if (!happened)
            break;
    }
    qInfo("%d openings failed, %d files were still of version 1", failures, stillOld);
    QVERIFY(failures > 0 && stillOld > 0 && stillOld <= failures);
}

void TestSessionFaults::recording_diskFullForAWhile_losesNothing()
{
    Trial trial;
    std::mutex mutex;
    std::vector<RecorderEventKind> kinds;
    RecorderOptions options;
    options.commitEveryS = 0.005;
    options.retryEveryS = 0.005;
    options.onEvent = [&](const RecorderEvent &event) {
        const std::lock_guard guard(mutex);
        kinds.push_back(event.kind);
    };
    auto recorder = *RunRecorder::start(
        *trial.file, describeSource(sourceOf(trial.recording, kRateHz), "second"), options);
    injectFault(Fault::DiskFull, 1, true);
    for (Eigen::Index at = 0; at < 10000; at += 100)
        QVERIFY(recorder->samples(blockOf(trial.recording, at, 100), 100) == Flow::Continue);
    QTRY_VERIFY_WITH_TIMEOUT(recorder->stats().failing, 20000);
    QVERIFY(recorder->stats().written < 10000);
    clearFaults();
    QTRY_VERIFY_WITH_TIMEOUT(!recorder->stats().failing, 20000);
    for (Eigen::Index at = 10000; at < 20000; at += 100)
        QVERIFY(recorder->samples(blockOf(trial.recording, at, 100), 100) == Flow::Continue);
    QVERIFY(recorder->finish().ok());
    QVERIFY(sameSamples(*trial.file->readRun(recorder->run()), trial.recording));
    QCOMPARE(recorder->stats().queued(), std::int64_t{0});
    QCOMPARE(recorder->stats().queuedBytes, std::size_t{0});
    const std::lock_guard guard(mutex);
    QCOMPARE(kinds,
             (std::vector<RecorderEventKind>{RecorderEventKind::Failing, RecorderEventKind::Recovered}));
    // Both stand in the file's log.
    QCOMPARE(trial.file->events(recorder->run())->size(), std::size_t{2});
}

void TestSessionFaults::recording_memoryBoundReached_stopsAndKeepsAll()
{
    Trial trial;
    std::atomic<int> full = 0;
    RecorderOptions options;
    options.commitEveryS = 0.005;
    options.memoryBoundBytes = 5000 * 40;
    options.onEvent = [&](const RecorderEvent &event) { full += event.kind == RecorderEventKind::Full; };
    auto recorder = *RunRecorder::start(
        *trial.file, describeSource(sourceOf(trial.recording, kRateHz), "second"), options);
    injectFault(Fault::DiskFull, 1, true);
    Eigen::Index taken = 0;
    Flow flow = Flow::Continue;
    for (; flow == Flow::Continue && taken < 20000; taken += 100)
        flow = recorder->samples(blockOf(trial.recording, taken, 100), 100);
    QVERIFY(flow == Flow::Stop);
    QCOMPARE(taken, Eigen::Index{5000});
    QCOMPARE(full.load(), 1);
    const Status finished = recorder->finish();
    QCOMPARE(finished.error().code, Errc::OutputFull);
    QVERIFY(sameSamples(recorder->unwritten(), rowsOf(trial.recording, 0, taken)));
    clearFaults();
    QVERIFY(recorder->finish().ok());
    QCOMPARE(recorder->unwritten().size(), Eigen::Index{0});
    QVERIFY(sameSamples(*trial.file->readRun(recorder->run()), rowsOf(trial.recording, 0, taken)));
}

void TestSessionFaults::recording_smallDisk_losesNothing()
{
    // A file system of 2 MiB with a ballast on it, which goes when the recorder has run into it.
    const std::filesystem::path folder = scratchFolder() / "small";
    std::filesystem::create_directory(folder);
    const std::string mount = "mount -t tmpfs -o size=2m driftbench " + folder.string() + " 2>/dev/null";
    if (std::system(mount.c_str()) != 0)
        QSKIP("this machine does not let a test mount a small file system");
    const auto unmount = qScopeGuard(
        [&] { [[maybe_unused]] const int ignored = std::system(("umount -l " + folder.string()).c_str()); });
    auto made = SessionFile::create(folder / "a.driftbench");
    QVERIFY(made.ok());
    {
        SessionFile file = std::move(*made);
        const Recording recording = measuredRecording(6, 30000, kRateHz);
        RecorderOptions options;
        options.commitEveryS = options.retryEveryS = 0.01;
        auto recorder =
            *RunRecorder::start(file, describeSource(sourceOf(recording, kRateHz), "run"), options);
        const auto ballast = QString::fromStdString((folder / "ballast").string());
        QFile filler(ballast);
        QVERIFY(filler.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
        while (filler.write(QByteArray(4096, 'x')) > 0) {
        }
        filler.close();
        Eigen::Index at = 0;
        for (; at < 30000 && !recorder->stats().failing; at += 500) {
            recorder->samples(blockOf(recording, at, 500), 500);
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        QVERIFY(recorder->stats().failing);
        for (; at < 30000; at += 500)
            recorder->samples(blockOf(recording, at, 500), 500);
        QVERIFY(QFile::remove(ballast));
        QVERIFY(recorder->finish().ok());
        QVERIFY(sameSamples(*file.readRun(recorder->run()), recording));
        QVERIFY(file.check()->empty());
    }
}

void TestSessionFaults::damage_random_isAnErrorOrWhatIsLeft()
{
    const auto seed = static_cast<std::uint64_t>(QDateTime::currentMSecsSinceEpoch());
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    Random random(seed);
    const auto original = newSessionPath();
    {
        auto file = *SessionFile::create(original);
        for (const std::uint64_t run : {1, 2, 3})
            QVERIFY(file.importRun(measuredRecording(run, 3000, 100.0), {}).ok());
        QVERIFY(file.setMask(1, Mask(3000)).ok() && file.setDocument("plan", "no plan").ok());
    }
    const QByteArray whole = bytesOf(QString::fromStdString(original.string()));
    for (int trial = 0; trial < 60; ++trial) {
        QByteArray bytes = whole;
        if (trial % 3 == 0)
            bytes.truncate(static_cast<qsizetype>(random.below(static_cast<std::uint64_t>(bytes.size()))));
        for (std::uint64_t flip = random.below(8); trial % 3 != 0 && flip < 12; ++flip) {
            // Half of them in the pages with the tables.
            const auto range = static_cast<std::uint64_t>(
                flip % 2 == 0 ? bytes.size() : std::min<qsizetype>(bytes.size(), 1 << 16));
            const auto at = static_cast<qsizetype>(random.below(range));
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
        }
        const auto path = newSessionPath();
        writeBytes(QString::fromStdString(path.string()), bytes);
        auto file =
            SessionFile::open(path, trial % 2 == 0 ? SessionAccess::ReadWrite : SessionAccess::ReadOnly);
        if (!file) {
            QVERIFY(!file.error().message.empty());
            continue;
        }
        const auto findings = file->check();
        QVERIFY(findings.ok() || !findings.error().message.empty());
        const auto runs = file->runs();
        for (const RunRecord &run : runs.ok() ? *runs : std::vector<RunRecord>()) {
            const auto strict = file->readRun(run.id);
            const auto lenient = file->readRun(run.id, {true});
            QVERIFY(!strict.ok() || lenient.ok());
            (void)file->overview(run.id);
            (void)file->mask(run.id);
            (void)file->gaps(run.id);
        }
        (void)file->models();
        (void)file->plan();
        (void)file->events();
    }
}

QTEST_GUILESS_MAIN(TestSessionFaults)
#include "tst_session_faults.moc"
