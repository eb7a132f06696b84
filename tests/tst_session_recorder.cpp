// The recorder: everything arrives, in order; interrupted runs are found and gone on with; a program that is
// killed while it records loses at most the last second.
//
// DRIFTBENCH_KILLS=200 kills so many times (20 else).
#include "app/session/database.h"
#include "app/session/run_recorder.h"
#include "app/session/session_file.h"
#include "device/bridge/bridge_source.h"
#include "support/session_data.h"
#include "support/simulated_device.h"

#include <QProcess>
#include <QTest>

#include <chrono>
#include <csignal>
#include <cstdio>
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
    void resume_interruptedRun_goesOnBehindAGap();
    void resume_anotherSensor_isRefused();
    void kill_whileRecording_losesAtMostASecond();
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

// The program that is killed ------------------------------------------------------------------------------

struct Handed
{
    double atS = 0.0; // CLOCK_MONOTONIC, which all programs share
    std::int64_t samples = 0;
};

double monotonicS()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Says on standard output what it has handed to the recorder, and when.
class SayingSink final : public SampleSink
{
public:
    explicit SayingSink(RunRecorder &recorder) : m_recorder(recorder) {}

    Flow samples(const SampleBlock &block, Eigen::Index count) override
    {
        const Flow flow = m_recorder.samples(block, count);
        m_handed.samples += count;
        m_handed.atS = monotonicS();
        return std::fwrite(&m_handed, sizeof m_handed, 1, stdout) == 1 && std::fflush(stdout) == 0
                   ? flow
                   : Flow::Stop;
    }
    void gap(const SampleGap &gap) override { m_recorder.gap(gap); }
    void event(const std::string &sentence) override { m_recorder.event(sentence); }

private:
    RunRecorder &m_recorder;
    Handed m_handed;
};

Result<std::unique_ptr<BridgeSource>> simulatedSource(const std::shared_ptr<SimulatedBoard> &board)
{
    BridgeSourceOptions options;
    options.rateHz = 1000.0;
    return BridgeSource::open(*SimulatedBridge::open(board), board->clock(), options);
}

int recordUntilKilled(const char *path)
{
    SimulatedBoardOptions options = quickBoard(600.0);
    options.speed = 1.0;
    const auto board = *SimulatedBoard::create(std::move(options));
    const auto source = simulatedSource(board);
    const auto file = SessionFile::open(path, SessionAccess::ReadWrite);
    if (!source || !file)
        return 1;
    auto recorder = RunRecorder::start(*file, describeSource((*source)->info(), "run"));
    if (!recorder)
        return 2;
    SayingSink sink(**recorder);
    return (*source)->run(sink, {}).ok() ? 3 : 4;
}

struct Killing
{
    std::filesystem::path path = newSessionPath();
    QProcess process;
    double killedAtS = 0.0;
};

std::vector<Handed> handedBy(const QByteArray &output)
{
    std::vector<Handed> handed(static_cast<std::size_t>(output.size()) / sizeof(Handed));
    std::memcpy(handed.data(), output.constData(), handed.size() * sizeof(Handed));
    return handed;
}

// Seconds of what was handed over that are missing behind the last sample in the file.
double missingS(const std::vector<Handed> &handed, std::int64_t inFile, double killedAtS)
{
    for (const Handed &block : handed) {
        if (block.samples > inFile)
            return killedAtS - block.atS;
    }
    return 0.0;
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
    QVERIFY(asIs->run(recorder->run()).ok());
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

void TestSessionRecorder::kill_whileRecording_losesAtMostASecond()
{
    const auto seed = static_cast<std::uint64_t>(QDateTime::currentMSecsSinceEpoch());
    const int kills = qEnvironmentVariableIntValue("DRIFTBENCH_KILLS") > 0
                          ? qEnvironmentVariableIntValue("DRIFTBENCH_KILLS")
                          : 20;
    constexpr int atOnce = 4;
    qInfo("seed %llu, %d kills", static_cast<unsigned long long>(seed), kills);
    Random random(seed);
    double worstS = 0.0;
    for (int done = 0; done < kills; done += atOnce) {
        std::array<Killing, atOnce> killings;
        for (Killing &killing : killings) {
            QVERIFY(SessionFile::create(killing.path).ok());
            killing.process.start(QCoreApplication::applicationFilePath(),
                                  {"--record", QString::fromStdString(killing.path.string())});
        }
        for (Killing &killing : killings)
            QVERIFY(killing.process.waitForReadyRead(60000));
        QTest::qWait(300 + static_cast<int>(random.below(900)));
        for (Killing &killing : killings) {
            // Before, so that waiting for the processor here does not excuse the recorder.
            killing.killedAtS = monotonicS();
            ::kill(static_cast<pid_t>(killing.process.processId()), SIGKILL);
        }
        for (Killing &killing : killings) {
            QVERIFY(killing.process.waitForFinished(60000));
            QCOMPARE(killing.process.exitStatus(), QProcess::CrashExit);
            const auto handed = handedBy(killing.process.readAllStandardOutput());
            QVERIFY(!handed.empty());
            const auto file = SessionFile::open(killing.path, SessionAccess::ReadWrite);
            QVERIFY2(file.ok(), file.ok() ? "" : file.error().message.c_str());
            QVERIFY(!file->readOnly());
            QVERIFY(file->check()->empty());
            const auto runs = *file->runs();
            QCOMPARE(runs.size(), std::size_t{1});
            QVERIFY(runs[0].state == RunState::Interrupted);
            QCOMPARE(file->readRun(runs[0].id)->size(), Eigen::Index{runs[0].samples});
            const double missing = missingS(handed, runs[0].samples, killing.killedAtS);
            worstS = std::max(worstS, missing);
            QVERIFY2(missing <= 1.0, qPrintable(QString("%1 s are missing").arg(missing)));
        }
    }
    qInfo("at most %.3f s were missing", worstS);
}

int main(int argc, char **argv)
{
    if (argc == 3 && std::string_view(argv[1]) == "--record")
        return recordUntilKilled(argv[2]);
    QCoreApplication application(argc, argv);
    TestSessionRecorder test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_session_recorder.moc"
