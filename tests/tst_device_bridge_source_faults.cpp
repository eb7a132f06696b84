// The native bridge as a source: every sample arrives or is accounted for, whatever goes wrong on the way.
#include "engine/base/random.h"
#include "support/bridge_link.h"
#include "support/collecting_sink.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceBridgeSourceFaults : public QObject
{
    Q_OBJECT

private slots:
    void run_lostReports_areCountedExactly();
    void run_lossOfAWholeTurnOfTheSequence_isSeen();
    void run_overrunInTheDevice_isCountedExactly();
    void run_randomFaults_everySampleIsAccountedFor();
    void run_stall_isToldAndEnds();
    void run_unplugged_deliversWhatCameBefore();
    void run_pluggedInAgain_goesOnBehindAGap();
    void run_otherGyroPluggedIn_waitsForTheRightOne();
    void run_unpluggedAndStopped_ends();
    void run_damagedReports_areSkippedOrEndIt();
};

namespace {

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

void TestDeviceBridgeSourceFaults::run_lostReports_areCountedExactly()
{
    BridgeLink made = linkTo(quickBoard(20.0), atRate(1000.0));
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

void TestDeviceBridgeSourceFaults::run_lossOfAWholeTurnOfTheSequence_isSeen()
{
    BridgeLink made = linkTo(quickBoard(100.0), atRate(5000.0));
    made.board->inject([](SimulatedFaults &faults) { faults.loseReports(100, 65535); });
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    QVERIFY(stats.ok());
    QCOMPARE(stats->lostSamples, 65535 * 7);
    QCOMPARE(stats->samples + stats->lostSamples, 500000);
}

void TestDeviceBridgeSourceFaults::run_overrunInTheDevice_isCountedExactly()
{
    SimulatedBoardOptions options = quickBoard(30.0);
    options.ringReports = 16;
    BridgeLink made = linkTo(options, atRate(1000.0));
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

void TestDeviceBridgeSourceFaults::run_randomFaults_everySampleIsAccountedFor()
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
        BridgeLink made = linkTo(options, atRate(rateHz));
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

void TestDeviceBridgeSourceFaults::run_stall_isToldAndEnds()
{
    BridgeLink made = linkTo(quickBoard(20.0), atRate(100.0));
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

void TestDeviceBridgeSourceFaults::run_unplugged_deliversWhatCameBefore()
{
    BridgeLink made = linkTo(quickBoard(20.0), atRate(1000.0));
    made.board->inject([](SimulatedFaults &faults) { faults.unplugAtReport(333); });
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    QVERIFY(!stats.ok());
    QCOMPARE(stats.error().code, Errc::DeviceUnplugged);
    QCOMPARE(sink.rows.size(), std::size_t(333 * 7));
}

void TestDeviceBridgeSourceFaults::run_pluggedInAgain_goesOnBehindAGap()
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

void TestDeviceBridgeSourceFaults::run_otherGyroPluggedIn_waitsForTheRightOne()
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

void TestDeviceBridgeSourceFaults::run_unpluggedAndStopped_ends()
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

void TestDeviceBridgeSourceFaults::run_damagedReports_areSkippedOrEndIt()
{
    BridgeLink made = linkTo(quickBoard(10.0), atRate(1000.0));
    made.board->inject([](SimulatedFaults &faults) { faults.damageReports(20, 1); });
    CollectingSink sink;
    const auto stats = made.source->run(sink, {});
    QCOMPARE(stats->lostSamples, 7);
    QCOMPARE(stats->samples, 9993);
    QVERIFY(sink.hasEvent("damaged"));

    BridgeLink broken = linkTo(quickBoard(10.0), atRate(1000.0));
    broken.board->inject([](SimulatedFaults &faults) { faults.damageReports(20, 1000000); });
    CollectingSink rest;
    QCOMPARE(broken.source->run(rest, {}).error().code, Errc::DamagedReport);
    QCOMPARE(rest.rows.size(), std::size_t(140));
}

QTEST_APPLESS_MAIN(TestDeviceBridgeSourceFaults)
#include "tst_device_bridge_source_faults.moc"
