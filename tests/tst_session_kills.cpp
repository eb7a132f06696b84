// A program that is killed while it records loses at most the last second, and leaves a whole file.
//
// DRIFTBENCH_KILLS=200 kills so many times (20 else); the test tst_session_kills_200 (label long) does.
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

using namespace driftbench;
using namespace driftbench::test;

class TestSessionKills : public QObject
{
    Q_OBJECT

private slots:
    void kill_whileRecording_losesAtMostASecond();
};

namespace {

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

void TestSessionKills::kill_whileRecording_losesAtMostASecond()
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
    TestSessionKills test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_session_kills.moc"
