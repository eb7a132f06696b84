// The native bridge as a source: what it gives is what the gyro did, in the host's time. What goes wrong on
// the way is in tst_device_bridge_source_faults.
#include "engine/exports/device_compensation.h"
#include "engine/physics/gyro_simulator.h"
#include "support/bridge_link.h"
#include "support/collecting_sink.h"
#include "support/firmware_device.h"

#include <QTest>

#include <cmath>
#include <thread>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceBridgeSource : public QObject
{
    Q_OBJECT

private slots:
    void run_wholeProfile_equalsTheSimulator();
    void run_tenKilohertz_losesNothing();
    void run_clockErrorAndWrap_timeIsTheHosts();
    void run_saturation_isCountedAndTold();
    void run_thermometers_asChosen();
    void run_compensated_equalsTheHostsCompensation();
    void run_stopToken_endsAndStopsTheStream();
    void run_sinkStops_ends();
    void open_wrongOptions_sayWhatThereIs();
    void run_realTimeOnAThread_stops();
};

void TestDeviceBridgeSource::run_wholeProfile_equalsTheSimulator()
{
    SimulatedBoardOptions options = quickBoard(30.0);
    BridgeLink made = linkTo(options, atRate(500.0));
    QCOMPARE(made.source->info().name, std::string("native bridge SIM-0001"));
    QCOMPARE(made.source->info().sampleRateHz, 500.0);
    QCOMPARE(made.source->info().rangeDps, 245.0);
    QVERIFY(made.source->info().simulated && !made.source->info().compensated);
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    QVERIFY(stats.ok());
    options.simulation.gyro.sampleRateHz = 500.0;
    const Recording expected = *simulateRun(options.simulation, 0);
    QCOMPARE(static_cast<Eigen::Index>(sink.rows.size()), expected.size());
    for (std::size_t i = 0; i < sink.rows.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        QVERIFY(std::abs(sink.rows[i].timeS - expected.timeS[row]) < 2e-6);
        QVERIFY(std::abs(sink.rows[i].temperatureC - expected.temperatureC[row / 7 * 7]) < 1e-9);
        for (std::size_t axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(sink.rows[i].rateDps[axis] -
                             expected.rateDps(row, static_cast<Eigen::Index>(axis))) < 1e-9);
    }
    QVERIFY(sink.consistent && sink.timesRise());
    QVERIFY(sink.longestBlockS < 0.06);
    QCOMPARE(stats->samples, expected.size());
    QCOMPARE(stats->lostSamples, 0);
    QVERIFY(sink.gaps.empty());
    QVERIFY(sink.hasEvent("has stopped streaming"));
}

void TestDeviceBridgeSource::run_tenKilohertz_losesNothing()
{
    BridgeLink made = linkTo(quickBoard(20.0), atRate(10000.0));
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    QCOMPARE(stats->samples, 200000);
    QCOMPARE(stats->lostSamples, 0);
    QCOMPARE(made.board->droppedInside(), 0u);
    QVERIFY(sink.consistent && sink.timesRise() && sink.gaps.empty());
}

void TestDeviceBridgeSource::run_clockErrorAndWrap_timeIsTheHosts()
{
    for (const double ppm : {-200.0, 200.0}) {
        SimulatedBoardOptions options = quickBoard(6000.0);
        options.clockErrorPpm = ppm;
        options.powerUpClockUs = 3000000000u; // wraps after 21 min and again after 93 min
        BridgeLink made = linkTo(options, atRate(10.0));
        CollectingSink sink;
        const auto stats = made.source->run(sink, {});
        QCOMPARE(stats->samples, 60000);
        QVERIFY(sink.gaps.empty());
        QVERIFY2(std::abs(stats->clockDriftPpm - ppm) < 1.0,
                 qPrintable(QString::number(stats->clockDriftPpm)));
        // 200 ppm of 6000 s would be 1.2 s.
        QVERIFY(std::abs(sink.rows.back().timeS - 5999.9) < 0.05);
    }
}

void TestDeviceBridgeSource::run_saturation_isCountedAndTold()
{
    SimulatedBoardOptions options = quickBoard(20.0);
    options.simulation.faults.motionBursts = 1;
    options.simulation.faults.motionDps = 3000.0;
    options.simulation.faults.motionS = 2.0;
    BridgeLink made = linkTo(options, atRate(100.0));
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    std::int64_t atLimit = 0;
    for (const auto &row : sink.rows) {
        const bool any = std::any_of(row.rateDps.begin(), row.rateDps.end(), [](double rateDps) {
            return rateDps == 32767 * 875 / 100000.0 || rateDps == -32768 * 875 / 100000.0;
        });
        atLimit += any ? 1 : 0;
    }
    QVERIFY(atLimit > 0);
    QCOMPARE(stats->saturatedSamples, atLimit);
    QVERIFY(sink.hasEvent("saturated on"));
    QCOMPARE(sink.events.size(), std::size_t(2)); // and that it has stopped streaming
}

void TestDeviceBridgeSource::run_thermometers_asChosen()
{
    SimulatedBoardOptions options = quickBoard(60.0);
    options.simulation.gyro.packageLagS = 10.0;
    BridgeSourceOptions choice = atRate(50.0);
    CollectingSink external;
    QVERIFY(linkTo(options, choice).source->run(external, {}).ok());
    choice.thermometer = BridgeThermometer::Die;
    CollectingSink die;
    QVERIFY(linkTo(options, choice).source->run(die, {}).ok());
    options.externalThermometer = false;
    choice.thermometer = BridgeThermometer::Automatic;
    CollectingSink automatic;
    QVERIFY(linkTo(options, choice).source->run(automatic, {}).ok());
    const std::size_t middle = die.rows.size() / 2;
    QVERIFY(external.rows[middle].temperatureC > die.rows[middle].temperatureC + 1.0);
    QCOMPARE(automatic.rows[middle].temperatureC, die.rows[middle].temperatureC);
}

void TestDeviceBridgeSource::run_compensated_equalsTheHostsCompensation()
{
    const SimulatedBoardOptions options = quickBoard(20.0);
    CompensationTable table;
    table.firstMilliC = 15000;
    table.lastMilliC = 45000;
    table.compensated = {true, true, true};
    table.provenance.sensor = options.simulation.sensor;
    table.tdeDps = Eigen::MatrixX3d::Random(31, 3);
    const Bytes bytes = imageOf(table, DeviceTableKind::FixedPoint, DeviceThermometer::External);

    CollectingSink raw;
    QVERIFY(linkTo(options, atRate(350.0)).source->run(raw, {}).ok());
    BridgeSourceOptions compensated = atRate(350.0);
    compensated.compensate = true;
    const auto board = *SimulatedBoard::create(options);
    const auto transport = *SimulatedBridge::open(board);
    for (const Report &report : uploadReports(bytes, 1))
        QVERIFY(transport->sendFeature(report).ok());
    QVERIFY(transport->sendFeature(generationReport(BRIDGE_REPORT_ACTIVATE, 1)).ok());
    const auto source = *BridgeSource::open(*SimulatedBridge::open(board), board->clock(), compensated);
    QVERIFY(source->info().compensated);
    CollectingSink sink;
    QVERIFY(source->run(sink, {}).ok());

    const DeviceCompensation host(*decodeDeviceImage(bytes, "test"), 875);
    QCOMPARE(sink.rows.size(), raw.rows.size());
    for (std::size_t i = 0; i < raw.rows.size(); ++i) {
        const auto tde =
            host.tdeCounts(static_cast<std::int32_t>(std::lround(raw.rows[i].temperatureC * 1000.0)));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto counts =
                static_cast<std::int16_t>(std::lround(raw.rows[i].rateDps[axis] * 100000.0 / 875.0));
            QCOMPARE(sink.rows[i].rateDps[axis],
                     (BridgeRange{245, 875}).rateDps(DeviceCompensation::compensated(counts, tde[axis])));
        }
    }
    QCOMPARE(sink.events.size(), std::size_t(1)); // that it has stopped streaming
}

void TestDeviceBridgeSource::run_stopToken_endsAndStopsTheStream()
{
    BridgeLink made = linkTo(quickBoard(100.0), atRate(200.0));
    std::stop_source stop;
    CollectingSink sink;
    sink.onSamples = [&] {
        if (sink.rows.size() >= 1000)
            stop.request_stop();
    };
    const auto stats = made.source->run(sink, stop.get_token());
    QVERIFY(stats.ok());
    QVERIFY(!made.source->client().config()->stream);
    // Everything that the device took while it streamed has come.
    QCOMPARE(made.source->client().status()->producedSamples, static_cast<std::uint32_t>(sink.rows.size()));
    QVERIFY(sink.rows.size() < 1100);
    // And the same source can run again.
    sink.onSamples = {};
    CollectingSink next;
    QCOMPARE(made.source->run(next, {})->samples, 20000);
}

void TestDeviceBridgeSource::run_sinkStops_ends()
{
    BridgeLink made = linkTo(quickBoard(100.0), atRate(200.0));
    CollectingSink sink;
    sink.stopAfter = 500;
    const auto stats = made.source->run(sink, {});
    QVERIFY(stats.ok());
    QVERIFY(sink.rows.size() >= 500 && sink.rows.size() < 520);
    QVERIFY(!made.source->client().config()->stream);
}

void TestDeviceBridgeSource::open_wrongOptions_sayWhatThereIs()
{
    SimulatedBoardOptions boardOptions = quickBoard(10.0);
    boardOptions.externalThermometer = false;
    const auto board = *SimulatedBoard::create(boardOptions);
    const auto refusal = [&](const BridgeSourceOptions &options) {
        return BridgeSource::open(*SimulatedBridge::open(board), board->clock(), options).error();
    };
    BridgeSourceOptions options = atRate(50000.0);
    QCOMPARE(refusal(options).code, Errc::InvalidOption);
    QVERIFY(refusal(options).message.find("1 to 10000 Hz") != std::string::npos);
    options = {};
    options.rangeDps = 300.0;
    QVERIFY(refusal(options).message.find("245, 490, 1960") != std::string::npos);
    options = {};
    options.thermometer = BridgeThermometer::External;
    QCOMPARE(refusal(options).code, Errc::InvalidOption);
    options = {};
    options.compensate = true;
    const auto source = *BridgeSource::open(*SimulatedBridge::open(board), board->clock(), options);
    CollectingSink sink;
    QCOMPARE(source->run(sink, {}).error().code, Errc::DeviceRefused);
}

void TestDeviceBridgeSource::run_realTimeOnAThread_stops()
{
    SimulatedBoardOptions options = quickBoard(3600.0);
    options.speed = 20.0;
    BridgeLink made = linkTo(options, atRate(100.0));
    CollectingSink sink;
    std::stop_source stop;
    sink.onSamples = [&] {
        if (sink.rows.size() >= 300)
            stop.request_stop();
    };
    Result<SourceStats> stats = SourceStats{};
    std::thread thread([&] { stats = made.source->run(sink, stop.get_token()); });
    thread.join();
    QVERIFY(stats.ok() && sink.consistent && sink.timesRise());
    QVERIFY(sink.rows.size() >= 300);
}

QTEST_APPLESS_MAIN(TestDeviceBridgeSource)
#include "tst_device_bridge_source.moc"
