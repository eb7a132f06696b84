// Recording into a CSV log: what a source gives is what readLog reads, gaps stay gaps and are written down,
// and what was recorded is in the file before the recording ends, whatever ends it.
#include "app/recording/csv_recorder.h"
#include "device/open_source.h"
#include "engine/formats/log_reader.h"
#include "engine/formats/sidecar.h"
#include "support/collecting_sink.h"
#include "support/simulated_device.h"
#include "support/test_data.h"

#include <QFile>
#include <QTest>
#include <nlohmann/json.hpp>

#include <cmath>
#include <csignal>
#include <sys/resource.h>
#include <thread>

using namespace driftbench;
using namespace driftbench::test;
namespace fs = std::filesystem;

class TestRecordingCsv : public QObject
{
    Q_OBJECT

private slots:
    void init();

    void record_simulated_isReadAsItWasMeasured();
    void record_duration_endsBeforeIt();
    void record_gaps_areWrittenDownNotFilled();
    void record_asked_ends();
    void record_silentDevice_endsWithItsTime();
    void record_sourceError_keepsWhatCame();
    void record_fullDisk_isToldAndEnds();
    void recorder_beforeTheEnd_hasItAllOnDisk();
    void recorder_oddText_staysOnItsLine();
    void recorder_existingLog_isKept();
    void monitor_randomBlocks_countsThem();

private:
    fs::path m_out;
    int m_number = 0;
};

namespace {

using Json = nlohmann::json;

QByteArray bytesIn(const fs::path &path)
{
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

Json sidecarOf(const fs::path &log)
{
    return Json::parse(bytesIn(sidecarPath(log)).toStdString());
}

Flow goOn(const RecordingState &)
{
    return Flow::Continue;
}

SourceChoice quickSimulated(double durationS, double rateHz)
{
    SimulatedChoice simulated;
    simulated.profile = *TemperatureProfile::build("test", 20.0, {HoldSegment{durationS}});
    simulated.speed = 0.0;
    SourceChoice choice{simulated};
    choice.rateHz = rateHz;
    return choice;
}

// A source that plays a script.
class ScriptedSource final : public SampleSource
{
public:
    using Script = std::function<Result<SourceStats>(SampleSink &, const std::stop_token &)>;

    explicit ScriptedSource(Script script) : m_script(std::move(script)) { m_info.name = "script"; }

    const SourceInfo &info() const override { return m_info; }
    Result<SourceStats> run(SampleSink &sink, std::stop_token stop) override { return m_script(sink, stop); }

    SourceInfo m_info;

private:
    Script m_script;
};

SampleBlock blockFrom(double startS, Eigen::Index rows, double stepS)
{
    SampleBlock block = SampleBlock::withRows(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        block.timeS[i] = startS + static_cast<double>(i) * stepS;
        block.temperatureC[i] = 20.0 + 0.5 * static_cast<double>(i);
        block.rateDps.row(i).setConstant(0.25);
    }
    return block;
}

} // namespace

void TestRecordingCsv::init()
{
    m_out = scratchFolder() / ("run" + std::to_string(++m_number) + ".csv");
}

void TestRecordingCsv::record_simulated_isReadAsItWasMeasured()
{
    const SourceChoice choice = quickSimulated(20.0, 100.0);
    const auto opened = openSource(choice);
    auto recorder = CsvRecorder::create(opened->source->info(), {m_out, {}, false, {6, {}, 5}});
    const RecordingOutcome outcome = record(*opened->source, *recorder, {}, goOn);
    QVERIFY(outcome.status.ok() && recorder->finish(outcome).ok());
    QCOMPARE(outcome.end, RecordingEnd::Source);
    QCOMPARE(outcome.state.samples, 2000);
    QVERIFY(std::abs(outcome.state.measuredRateHz() - 100.0) < 0.01);

    CollectingSink same;
    QVERIFY(openSource(choice)->source->run(same, {}).ok());
    const auto read = readLog(m_out, {});
    QVERIFY2(read.ok(), read ? "" : read.error().message.c_str());
    QCOMPARE(read->size(), Eigen::Index(2000));
    for (Eigen::Index i = 0; i < read->size(); ++i) {
        const auto &row = same.rows[static_cast<std::size_t>(i)];
        QVERIFY(std::abs(read->timeS[i] - row.timeS) < 1e-6);
        QCOMPARE(read->temperatureC[i], row.temperatureC);
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(read->rateDps(i, axis) - row.rateDps[static_cast<std::size_t>(axis)]) < 1e-9);
    }
    QCOMPARE(read->info.sensor.text(), std::string("I3G4250D SIM-0001"));
    QVERIFY(read->info.simulated && read->info.warnings.empty());
    const Json meta = sidecarOf(m_out)["recording"];
    QVERIFY(meta["complete"].get<bool>());
    QCOMPARE(meta["samples"].get<int>(), 2000);
    QCOMPARE(meta["nominal_rate_hz"].get<double>(), 100.0);
}

void TestRecordingCsv::record_duration_endsBeforeIt()
{
    const auto opened = openSource(quickSimulated(60.0, 1000.0));
    auto recorder = CsvRecorder::create(opened->source->info(), {m_out});
    const RecordingOutcome outcome = record(*opened->source, *recorder, {10.0}, goOn);
    QCOMPARE(outcome.end, RecordingEnd::Duration);
    QCOMPARE(outcome.state.samples, 10000);
    QVERIFY(outcome.state.lastS < 10.0 && outcome.state.reachedEnd);
    QCOMPARE(readLog(m_out, {})->size(), Eigen::Index(10000));
}

void TestRecordingCsv::record_gaps_areWrittenDownNotFilled()
{
    const auto opened = openSource(quickSimulated(20.0, 1000.0));
    opened->board->inject([](SimulatedFaults &faults) { faults.loseReports(100, 50); });
    auto recorder = CsvRecorder::create(opened->source->info(), {m_out});
    const RecordingOutcome outcome = record(*opened->source, *recorder, {}, goOn);
    QVERIFY(recorder->finish(outcome).ok());
    QCOMPARE(outcome.state.gaps, 1);
    QCOMPARE(outcome.state.lostSamples, 350);
    QCOMPARE(outcome.state.samples, 20000 - 350);
    QVERIFY(std::abs(outcome.state.measuredRateHz() - 1000.0) < 0.1);
    const auto read = readLog(m_out, {});
    QCOMPARE(read->size(), Eigen::Index(20000 - 350));
    QVERIFY((read->timeS.tail(read->size() - 1) - read->timeS.head(read->size() - 1)).maxCoeff() > 0.35);
    const QByteArray events = bytesIn(recorder->eventsPath());
    QVERIFY(events.startsWith("time_s,end_s,kind,lost_samples,text\n"));
    QVERIFY2(events.contains(",gap,350,\"reports lost\"\n"), events.constData());
    QVERIFY(events.contains(",event,,\""));
}

void TestRecordingCsv::record_asked_ends()
{
    const auto opened = openSource(quickSimulated(1e6, 100.0));
    auto recorder = CsvRecorder::create(opened->source->info(), {m_out});
    const RecordingOutcome outcome =
        record(*opened->source, *recorder, {0.0, false, 0.001},
               [](const RecordingState &state) { return state.samples > 100 ? Flow::Stop : Flow::Continue; });
    QCOMPARE(outcome.end, RecordingEnd::Asked);
    QVERIFY(outcome.status.ok() && outcome.stats.has_value());
    QCOMPARE(readLog(m_out, {})->size(), static_cast<Eigen::Index>(outcome.state.samples));
}

void TestRecordingCsv::record_silentDevice_endsWithItsTime()
{
    ScriptedSource source([](SampleSink &, const std::stop_token &stop) -> Result<SourceStats> {
        while (!stop.stop_requested())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return SourceStats{};
    });
    CollectingSink sink;
    const RecordingOutcome outcome = record(source, sink, {0.01, true, 0.001}, goOn);
    QCOMPARE(outcome.end, RecordingEnd::Duration);
    QCOMPARE(outcome.state.samples, 0);
}

void TestRecordingCsv::record_sourceError_keepsWhatCame()
{
    ScriptedSource source([](SampleSink &sink, const std::stop_token &) -> Result<SourceStats> {
        sink.samples(blockFrom(0.0, 50, 0.1), 50);
        return Error{Errc::DeviceUnplugged, "It was unplugged."};
    });
    auto recorder = CsvRecorder::create(source.info(), {m_out});
    const RecordingOutcome outcome = record(source, *recorder, {}, goOn);
    QCOMPARE(outcome.end, RecordingEnd::Error);
    QCOMPARE(outcome.status.error().code, Errc::DeviceUnplugged);
    QVERIFY(recorder->finish(outcome).ok());
    QCOMPARE(readLog(m_out, {})->size(), Eigen::Index(50));
    const Json meta = sidecarOf(m_out)["recording"];
    QCOMPARE(meta["error"].get<std::string>(), std::string("It was unplugged."));
    QVERIFY(meta["clock_drift_ppm"].is_null());
}

void TestRecordingCsv::record_fullDisk_isToldAndEnds()
{
    ScriptedSource source([](SampleSink &sink, const std::stop_token &) -> Result<SourceStats> {
        for (int block = 0; block < 100000; ++block) {
            if (sink.samples(blockFrom(block, 10, 0.1), 10) == Flow::Stop)
                return SourceStats{};
        }
        return Error{Errc::Cancelled, "Nobody stopped it."};
    });
    auto recorder = CsvRecorder::create(source.info(), {m_out});
    QVERIFY(recorder.ok());
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{20000, before.rlim_max};
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const RecordingOutcome outcome = record(source, *recorder, {}, goOn);
    const Status finished = recorder->finish(outcome);
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &before), 0);
    QVERIFY(outcome.status.ok());
    QCOMPARE(outcome.end, RecordingEnd::Sink);
    QCOMPARE(finished.error().code, Errc::OutputNotWritable);
    QVERIFY(bytesIn(m_out).size() > 19000);
}

void TestRecordingCsv::recorder_beforeTheEnd_hasItAllOnDisk()
{
    SourceInfo info;
    info.sensor = {"L3GD20H", "K-1"};
    auto recorder = CsvRecorder::create(info, {m_out});
    recorder->samples(blockFrom(0.0, 30, 0.1), 20);
    recorder->gap({1.9, 5.0, -1, GapCause::Unplugged});
    // As another program sees it, as after a kill.
    const auto read = readLog(m_out, {});
    QCOMPARE(read->size(), Eigen::Index(20));
    QCOMPARE(read->info.sensor.text(), std::string("L3GD20H K-1"));
    QVERIFY(bytesIn(recorder->eventsPath()).endsWith("1.900000,5.000000,gap,,\"unplugged\"\n"));
    QVERIFY(!sidecarOf(m_out)["recording"]["complete"].get<bool>());
    fs::remove(sidecarPath(m_out));
    QCOMPARE(readLog(m_out, {})->info.sensor.text(), std::string("L3GD20H K-1"));
}

void TestRecordingCsv::recorder_oddText_staysOnItsLine()
{
    SourceInfo info;
    info.sensor = {"A\nB", "\"x\",\r\n9,9,9,9,9\xff"};
    auto recorder = CsvRecorder::create(info, {m_out});
    recorder->event("He said \"no\",\nand left.");
    recorder->samples(blockFrom(0.0, 30, 0.1), 30);
    QVERIFY(recorder->finish({}).ok());
    QCOMPARE(readLog(m_out, {})->size(), Eigen::Index(30));
    QVERIFY(bytesIn(recorder->eventsPath()).contains("\"He said \"\"no\"\", and left.\"\n"));
}

void TestRecordingCsv::recorder_existingLog_isKept()
{
    const SourceInfo info;
    QVERIFY(CsvRecorder::create(info, {m_out}).ok());
    QCOMPARE(CsvRecorder::create(info, {m_out}).error().code, Errc::OutputNotWritable);
    QVERIFY(CsvRecorder::create(info, {m_out, {}, true}).ok());
}

void TestRecordingCsv::monitor_randomBlocks_countsThem()
{
    constexpr std::uint64_t kSeed = 5;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    for (int trial = 0; trial < 200; ++trial) {
        CollectingSink sink;
        const double endS = random.uniform(1.0, 30.0);
        RecordingMonitor monitor(sink, endS);
        double timeS = 0.0;
        Flow flow = Flow::Continue;
        while (flow == Flow::Continue) {
            const auto rows = static_cast<Eigen::Index>(1 + random.below(20));
            flow = monitor.samples(blockFrom(timeS, rows, 0.1), rows);
            timeS += 0.1 * static_cast<double>(rows);
        }
        const RecordingState state = monitor.state();
        QCOMPARE(static_cast<std::int64_t>(sink.rows.size()), state.samples);
        QVERIFY(sink.rows.back().timeS < endS && sink.rows.back().timeS + 0.1000001 >= endS);
        QVERIFY(state.reachedEnd && state.hasTemperature());
        QVERIFY(std::abs(state.measuredRateHz() - 10.0) < 1e-6 || state.samples < 2);
    }
}

QTEST_APPLESS_MAIN(TestRecordingCsv)
#include "tst_recording_csv.moc"
