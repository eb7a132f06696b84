// A log played back: the same samples, in time, with its gaps marked.
#include "device/replay_source.h"
#include "device/simulated_clock.h"
#include "support/collecting_sink.h"
#include "support/test_data.h"

#include <QFile>
#include <QTest>

#include <cmath>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceReplay : public QObject
{
    Q_OBJECT

private slots:
    void run_asFastAsItGoes_givesEverySample();
    void run_realSpeed_takesTheLogsTime_data();
    void run_realSpeed_takesTheLogsTime();
    void run_gapsInTheLog_areMarked();
    void run_stopped_ends();
    void run_sinkStops_ends();
    void run_again_startsAgain();
    void open_noLog_saysWhy();
    void open_recordedLog_saysWhatItIs();
};

namespace {

constexpr double kIntervalS = 0.01;
constexpr int kSamples = 20000;
constexpr double kFirstS = 1000.0;

// Sample i is missing where lost(i).
template <class Lost>
std::filesystem::path writeLog(const char *name, Lost lost)
{
    const std::filesystem::path path = scratchFolder() / name;
    QFile file(QString::fromStdString(path.string()));
    if (!file.open(QIODevice::WriteOnly))
        qFatal("the scratch folder can't be written to");
    file.write("time_s,temperature_c,rate_x_dps,rate_y_dps,rate_z_dps\n");
    for (int i = 0; i < kSamples; ++i) {
        if (!lost(i))
            file.write(QString("%1,%2,%3,%4,0.5\n")
                           .arg(kFirstS + i * kIntervalS, 0, 'f', 2)
                           .arg(20.0 + 0.001 * i, 0, 'f', 3)
                           .arg(i)
                           .arg(-i)
                           .toUtf8());
    }
    return path;
}

std::filesystem::path wholeLog()
{
    return writeLog("whole.csv", [](int) { return false; });
}

} // namespace

void TestDeviceReplay::run_asFastAsItGoes_givesEverySample()
{
    SimulatedClock clock(0.0);
    ReplayOptions options;
    options.speed = 0.0;
    const auto source = *ReplaySource::open(wholeLog(), clock, options);
    QCOMPARE(source->info().name, std::string("whole.csv"));
    QVERIFY(std::abs(source->info().sampleRateHz - 100.0) < 1e-6);
    CollectingSink sink;
    const auto stats = source->run(sink, {});
    QVERIFY(stats.ok());
    QCOMPARE(stats->samples, kSamples);
    QCOMPARE(sink.rows.size(), std::size_t(kSamples));
    for (int i = 0; i < kSamples; ++i) {
        const auto &row = sink.rows[static_cast<std::size_t>(i)];
        QVERIFY(std::abs(row.timeS - i * kIntervalS) < 1e-9);
        QVERIFY(std::abs(row.temperatureC - 20.0 - 0.001 * i) < 1e-9);
        QCOMPARE(row.rateDps[0], static_cast<double>(i));
        QCOMPARE(row.rateDps[1], static_cast<double>(-i));
    }
    QVERIFY(sink.consistent && sink.gaps.empty());
    QVERIFY(sink.longestBlockS < 0.06);
    QCOMPARE(clock.nowS(), 0.0);
}

void TestDeviceReplay::run_realSpeed_takesTheLogsTime_data()
{
    QTest::addColumn<double>("speed");
    QTest::newRow("real time") << 1.0;
    QTest::newRow("ten times") << 10.0;
    QTest::newRow("slow motion") << 0.5;
}

void TestDeviceReplay::run_realSpeed_takesTheLogsTime()
{
    QFETCH(double, speed);
    SimulatedClock clock(0.0);
    ReplayOptions options;
    options.speed = speed;
    const auto source = *ReplaySource::open(wholeLog(), clock, options);
    CollectingSink sink;
    double earliestS = 1e9;
    double latestS = -1e9;
    sink.onSamples = [&] {
        const double lateS = clock.nowS() - sink.rows.back().timeS / speed;
        earliestS = std::min(earliestS, lateS);
        latestS = std::max(latestS, lateS);
    };
    QVERIFY(source->run(sink, {}).ok());
    // On a clock that moves only when it is waited for, a block comes exactly when its last sample is due.
    QVERIFY(earliestS > -1e-9 && latestS < 1e-9);
    QVERIFY(std::abs(clock.nowS() - (kSamples - 1) * kIntervalS / speed) < 1e-6);
}

void TestDeviceReplay::run_gapsInTheLog_areMarked()
{
    // Around the end of the reader's first block as well; the loss of four samples is none.
    const auto lost = [](int i) {
        return (i >= 100 && i < 104) || (i >= 1000 && i < 1250) || (i >= 8192 && i < 8292);
    };
    SimulatedClock clock(0.0);
    const auto source = *ReplaySource::open(writeLog("gaps.csv", lost), clock, {});
    CollectingSink sink;
    const auto stats = source->run(sink, {});
    QCOMPARE(stats->samples, kSamples - 354);
    QCOMPARE(stats->gaps, 2);
    QCOMPARE(stats->lostSamples, 350);
    QVERIFY(sink.consistent && sink.timesRise());
    QCOMPARE(sink.gaps[0].lostSamples, 250);
    QVERIFY(std::abs(sink.gaps[0].startS - 9.99) < 1e-9);
    QVERIFY(std::abs(sink.gaps[0].endS - 12.5) < 1e-9);
    QCOMPARE(sink.gaps[1].lostSamples, 100);
}

void TestDeviceReplay::run_stopped_ends()
{
    SimulatedClock clock(0.0);
    const auto source = *ReplaySource::open(wholeLog(), clock, {});
    CollectingSink sink;
    std::stop_source stop;
    sink.onSamples = [&] {
        if (sink.rows.size() > 5000)
            stop.request_stop();
    };
    const auto stats = source->run(sink, stop.get_token());
    QVERIFY(stats.ok());
    QVERIFY(sink.rows.size() > 5000 && sink.rows.size() < 5010);
    QVERIFY(clock.nowS() < 51.0);
}

void TestDeviceReplay::run_sinkStops_ends()
{
    SimulatedClock clock(0.0);
    const auto source = *ReplaySource::open(wholeLog(), clock, {});
    CollectingSink sink;
    sink.stopAfter = 700;
    QVERIFY(source->run(sink, {}).ok());
    QVERIFY(sink.rows.size() >= 700 && sink.rows.size() < 710);
}

void TestDeviceReplay::run_again_startsAgain()
{
    SimulatedClock clock(0.0);
    ReplayOptions options;
    options.speed = 0.0;
    const auto source = *ReplaySource::open(wholeLog(), clock, options);
    CollectingSink first;
    CollectingSink second;
    QVERIFY(source->run(first, {}).ok() && source->run(second, {}).ok());
    QCOMPARE(first.rows.size(), second.rows.size());
    QCOMPARE(second.rows.front().timeS, 0.0);
}

void TestDeviceReplay::open_noLog_saysWhy()
{
    SimulatedClock clock(0.0);
    QCOMPARE(ReplaySource::open(scratchFolder() / "none.csv", clock, {}).error().code, Errc::FileNotFound);
    ReplayOptions options;
    options.speed = -1.0;
    QCOMPARE(ReplaySource::open(wholeLog(), clock, options).error().code, Errc::InvalidOption);
}

void TestDeviceReplay::open_recordedLog_saysWhatItIs()
{
    REQUIRE_SHARED_DATA(path, "climate_chamber/run1_cooling.csv");
    SimulatedClock clock(0.0);
    ReplayOptions options;
    options.speed = 0.0;
    const auto source = ReplaySource::open(path, clock, options);
    QVERIFY2(source.ok(), source.ok() ? "" : source.error().message.c_str());
    CollectingSink sink;
    const auto stats = (*source)->run(sink, {});
    QVERIFY(stats.ok() && sink.consistent);
    QVERIFY(stats->samples > 1000);
    QVERIFY(!(*source)->info().simulated);
}

QTEST_APPLESS_MAIN(TestDeviceReplay)
#include "tst_device_replay.moc"
