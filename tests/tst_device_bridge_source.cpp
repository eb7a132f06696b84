// The native bridge as a source: every sample arrives or is accounted for, whatever goes wrong on the way.
#include "device/bridge/bridge_source.h"
#include "engine/base/random.h"
#include "engine/exports/device_compensation.h"
#include "engine/physics/gyro_simulator.h"
#include "support/collecting_sink.h"
#include "support/firmware_device.h"
#include "support/simulated_device.h"

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
    void run_lostReports_areCountedExactly();
    void run_lossOfAWholeTurnOfTheSequence_isSeen();
    void run_overrunInTheDevice_isCountedExactly();
    void run_randomFaults_everySampleIsAccountedFor();
    void run_clockErrorAndWrap_timeIsTheHosts();
    void run_stall_isToldAndEnds();
    void run_unplugged_deliversWhatCameBefore();
    void run_pluggedInAgain_goesOnBehindAGap();
    void run_otherGyroPluggedIn_waitsForTheRightOne();
    void run_unpluggedAndStopped_ends();
    void run_damagedReports_areSkippedOrEndIt();
    void run_saturation_isCountedAndTold();
    void run_thermometers_asChosen();
    void run_compensated_equalsTheHostsCompensation();
    void run_stopToken_endsAndStopsTheStream();
    void run_sinkStops_ends();
    void open_wrongOptions_sayWhatThereIs();
    void run_realTimeOnAThread_stops();
};

namespace {

struct Link
{
    std::shared_ptr<SimulatedBoard> board;
    std::unique_ptr<BridgeSource> source;
};

Link link(const SimulatedBoardOptions &options, const BridgeSourceOptions &sourceOptions)
{
    Link made{*SimulatedBoard::create(options), nullptr};
    made.source = *BridgeSource::open(*SimulatedBridge::open(made.board), made.board->clock(), sourceOptions);
    return made;
}

BridgeSourceOptions atRate(double rateHz)
{
    BridgeSourceOptions options;
    options.rateHz = rateHz;
    return options;
}

// The board is plugged in again, 2 s later, by whoever looks for it.
BridgeSourceOptions reopening(const std::shared_ptr<SimulatedBoard> &board, double rateHz)
{
    BridgeSourceOptions options = atRate(rateHz);
    options.reopen = [board] {
        board->plugIn(2.0);
        return SimulatedBridge::open(board);
    };
    return options;
}

} // namespace

void TestDeviceBridgeSource::run_wholeProfile_equalsTheSimulator()
{
    SimulatedBoardOptions options = quickBoard(30.0);
    Link made = link(options, atRate(500.0));
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
    Link made = link(quickBoard(20.0), atRate(10000.0));
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    QCOMPARE(stats->samples, 200000);
    QCOMPARE(stats->lostSamples, 0);
    QCOMPARE(made.board->droppedInside(), 0u);
    QVERIFY(sink.consistent && sink.timesRise() && sink.gaps.empty());
}

void TestDeviceBridgeSource::run_lostReports_areCountedExactly()
{
    Link made = link(quickBoard(20.0), atRate(1000.0));
    made.board->inject([](SimulatedFaults &faults) {
        faults.loseReports(10, 1);
        faults.loseReports(50, 20);
        faults.loseReports(100, 1000);
    });
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    QVERIFY(stats.ok());
    QCOMPARE(stats->lostSamples, 1021 * 7);
    QCOMPARE(stats->samples + stats->lostSamples, 20000);
    QCOMPARE(stats->gaps, 3);
    QCOMPARE(sink.gaps[0].lostSamples, 7);
    QCOMPARE(sink.gaps[1].lostSamples, 140);
    QCOMPARE(sink.gaps[2].lostSamples, 7000);
    for (const SampleGap &gap : sink.gaps) {
        QCOMPARE(gap.cause, GapCause::ReportsLost);
        QVERIFY(std::abs(gap.endS - gap.startS - 0.001 * static_cast<double>(gap.lostSamples + 1)) < 1e-5);
    }
    QVERIFY(sink.consistent && sink.timesRise());
}

void TestDeviceBridgeSource::run_lossOfAWholeTurnOfTheSequence_isSeen()
{
    Link made = link(quickBoard(100.0), atRate(5000.0));
    made.board->inject([](SimulatedFaults &faults) { faults.loseReports(100, 65535); });
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    QVERIFY(stats.ok());
    QCOMPARE(stats->lostSamples, 65535 * 7);
    QCOMPARE(stats->samples + stats->lostSamples, 500000);
}

void TestDeviceBridgeSource::run_overrunInTheDevice_isCountedExactly()
{
    SimulatedBoardOptions options = quickBoard(30.0);
    options.ringReports = 16;
    Link made = link(options, atRate(1000.0));
    made.board->inject([](SimulatedFaults &faults) { faults.stall(20, 4.0); });
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    QVERIFY(stats->lostSamples > 3800);
    QCOMPARE(stats->lostSamples, static_cast<std::int64_t>(made.board->droppedInside()));
    QCOMPARE(stats->samples + stats->lostSamples, 30000);
    QCOMPARE(sink.gaps.size(), std::size_t(1));
    QCOMPARE(sink.gaps[0].cause, GapCause::DeviceOverrun);
    QVERIFY(sink.hasEvent("No samples have come for") && sink.hasEvent("Samples come again after"));
}

void TestDeviceBridgeSource::run_randomFaults_everySampleIsAccountedFor()
{
    constexpr std::uint64_t kSeed = 4711;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    for (int trial = 0; trial < 60; ++trial) {
        SimulatedBoardOptions options = quickBoard(20.0);
        options.ringReports = static_cast<std::uint32_t>(1 + random.below(40));
        options.powerUpClockUs = static_cast<std::uint32_t>(random.bits());
        options.clockErrorPpm = random.uniform(-200.0, 200.0);
        const double rateHz = 20.0 + static_cast<double>(random.below(2000));
        const auto expected = static_cast<std::int64_t>(20.0 * rateHz);
        Link made = link(options, atRate(rateHz));
        const auto reports = expected / 7;
        made.board->inject([&](SimulatedFaults &faults) {
            for (std::uint64_t i = random.below(4); i > 0; --i)
                faults.loseReports(
                    1 + static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(reports / 2))),
                    1 + static_cast<std::int64_t>(random.below(9)));
            if (random.below(2) == 0)
                faults.stall(
                    1 + static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(reports / 2))),
                    random.uniform(0.1, 5.0));
        });
        CollectingSink sink;
        const auto stats = made.source->run(sink, {});
        QVERIFY(stats.ok() && sink.consistent && sink.timesRise());
        QCOMPARE(stats->samples + stats->lostSamples, expected);
        QVERIFY(sink.lost(GapCause::DeviceOverrun) == made.board->droppedInside() ||
                sink.lost(GapCause::ReportsLost) > 0);
    }
}

void TestDeviceBridgeSource::run_clockErrorAndWrap_timeIsTheHosts()
{
    for (const double ppm : {-200.0, 200.0}) {
        SimulatedBoardOptions options = quickBoard(6000.0);
        options.clockErrorPpm = ppm;
        options.powerUpClockUs = 3000000000u; // wraps after 21 min and again after 93 min
        Link made = link(options, atRate(10.0));
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

void TestDeviceBridgeSource::run_stall_isToldAndEnds()
{
    Link made = link(quickBoard(20.0), atRate(100.0));
    made.board->inject([](SimulatedFaults &faults) { faults.stall(5, 2.5); });
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    // The ring of 64 reports holds what was sampled meanwhile.
    QCOMPARE(stats->samples, 2000);
    QVERIFY(sink.gaps.empty());
    const auto told = std::count_if(sink.events.begin(), sink.events.end(), [](const std::string &event) {
        return event.starts_with("No samples have come");
    });
    QCOMPARE(told, 1);
    QVERIFY(sink.hasEvent("Samples come again after 2."));
}

void TestDeviceBridgeSource::run_unplugged_deliversWhatCameBefore()
{
    Link made = link(quickBoard(20.0), atRate(1000.0));
    made.board->inject([](SimulatedFaults &faults) { faults.unplugAtReport(333); });
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    QVERIFY(!stats.ok());
    QCOMPARE(stats.error().code, Errc::DeviceUnplugged);
    QCOMPARE(sink.rows.size(), std::size_t(333 * 7));
}

void TestDeviceBridgeSource::run_pluggedInAgain_goesOnBehindAGap()
{
    SimulatedBoardOptions options = quickBoard(20.0);
    const auto board = *SimulatedBoard::create(options);
    const auto source =
        *BridgeSource::open(*SimulatedBridge::open(board), board->clock(), reopening(board, 1000.0));
    board->inject([](SimulatedFaults &faults) { faults.unplugAtReport(500); });
    CollectingSink sink;
    sink.onSamples = [&, again = true]() mutable {
        if (again && sink.gaps.size() == 1) {
            again = false;
            board->inject([](SimulatedFaults &faults) { faults.unplugAtReport(300); });
        }
    };
    const auto stats = source->run(sink, {});
    QVERIFY(stats.ok() && sink.consistent && sink.timesRise());
    QCOMPARE(sink.gaps.size(), std::size_t(2));
    for (const SampleGap &gap : sink.gaps) {
        QCOMPARE(gap.cause, GapCause::Unplugged);
        QVERIFY(gap.endS - gap.startS > 2.0 && gap.endS - gap.startS < 2.2);
        QVERIFY(std::abs(static_cast<double>(gap.lostSamples) - 1000.0 * (gap.endS - gap.startS)) < 2.0);
    }
    QVERIFY(sink.hasEvent("was unplugged") && sink.hasEvent("is back"));
    // The chamber went on meanwhile: the run ends when it would have ended.
    QVERIFY(std::abs(sink.rows.back().timeS - 20.0) < 0.05);
    QVERIFY(std::abs(static_cast<double>(stats->samples + stats->lostSamples) - 20000.0) < 50.0);
}

void TestDeviceBridgeSource::run_otherGyroPluggedIn_waitsForTheRightOne()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    SimulatedBoardOptions otherOptions = quickBoard(10.0);
    otherOptions.simulation.sensor.serial = "SIM-0002";
    const auto other = *SimulatedBoard::create(otherOptions);
    BridgeSourceOptions options = atRate(100.0);
    int tries = 0;
    options.reopen = [&]() -> Result<std::unique_ptr<HidTransport>> {
        if (++tries == 3)
            board->plugIn();
        return tries == 2 ? SimulatedBridge::open(other) : SimulatedBridge::open(board);
    };
    const auto source = *BridgeSource::open(*SimulatedBridge::open(board), board->clock(), options);
    board->inject([](SimulatedFaults &faults) { faults.unplugAtReport(10); });
    CollectingSink sink;
    QVERIFY(source->run(sink, {}).ok());
    QCOMPARE(tries, 3);
    QVERIFY(sink.hasEvent("SIM-0002"));
    QCOMPARE(sink.gaps.size(), std::size_t(1));
}

void TestDeviceBridgeSource::run_unpluggedAndStopped_ends()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeSourceOptions options = atRate(100.0);
    std::stop_source stop;
    int tries = 0;
    options.reopen = [&] {
        if (++tries == 5)
            stop.request_stop();
        return SimulatedBridge::open(board);
    };
    const auto source = *BridgeSource::open(*SimulatedBridge::open(board), board->clock(), options);
    board->inject([](SimulatedFaults &faults) { faults.unplugAtReport(10); });
    CollectingSink sink;
    const auto stats = source->run(sink, stop.get_token());
    QVERIFY(stats.ok());
    QCOMPARE(tries, 5);
    QCOMPARE(stats->samples, static_cast<std::int64_t>(sink.rows.size()));
    QVERIFY(stats->samples > 0);
}

void TestDeviceBridgeSource::run_damagedReports_areSkippedOrEndIt()
{
    Link made = link(quickBoard(10.0), atRate(1000.0));
    made.board->inject([](SimulatedFaults &faults) { faults.damageReports(20, 1); });
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    QCOMPARE(stats->lostSamples, 7);
    QCOMPARE(stats->samples, 9993);
    QVERIFY(sink.hasEvent("damaged"));

    Link broken = link(quickBoard(10.0), atRate(1000.0));
    broken.board->inject([](SimulatedFaults &faults) { faults.damageReports(20, 1000000); });
    CollectingSink rest;
    QCOMPARE(broken.source->run(rest, {}).error().code, Errc::DamagedReport);
    QCOMPARE(rest.rows.size(), std::size_t(140));
}

void TestDeviceBridgeSource::run_saturation_isCountedAndTold()
{
    SimulatedBoardOptions options = quickBoard(20.0);
    options.simulation.faults.motionBursts = 1;
    options.simulation.faults.motionDps = 3000.0;
    options.simulation.faults.motionS = 2.0;
    Link made = link(options, atRate(100.0));
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
    QVERIFY(link(options, choice).source->run(external, {}).ok());
    choice.thermometer = BridgeThermometer::Die;
    CollectingSink die;
    QVERIFY(link(options, choice).source->run(die, {}).ok());
    options.externalThermometer = false;
    choice.thermometer = BridgeThermometer::Automatic;
    CollectingSink automatic;
    QVERIFY(link(options, choice).source->run(automatic, {}).ok());
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
    QVERIFY(link(options, atRate(350.0)).source->run(raw, {}).ok());
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
    Link made = link(quickBoard(100.0), atRate(200.0));
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
    Link made = link(quickBoard(100.0), atRate(200.0));
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
    Link made = link(options, atRate(100.0));
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
