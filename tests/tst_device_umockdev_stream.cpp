// The real device path, second part: samples of the reference firmware through the unmodified libhidapi, over
// umockdev, in real time.
#include "device/bridge/bridge_source.h"
#include "support/collecting_sink.h"
#include "support/mocked_hidraw.h"
#include "support/real_device.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceUmockdevStream : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();

    void run_10sAt1kHz_losesNothing();
    void run_lostReports_areCountedBySequenceNumber();
    void run_unplugged_endsWithWhatCame();
    void run_unpluggedTwiceAndBack_goesOnBehindGaps();
};

namespace {

constexpr double kRateHz = 1000.0;

struct Bench
{
    std::shared_ptr<SimulatedBoard> board = *SimulatedBoard::create(realTimeBoard());
    MockedHidraw mock{board};
    SteadyClock clock;
    CollectingSink sink;

    std::unique_ptr<BridgeSource> source(ReopenTransport reopen = {})
    {
        BridgeSourceOptions options;
        options.rateHz = kRateHz;
        options.reopenEveryS = 0.02;
        options.reopen = std::move(reopen);
        auto transport = openListed(board->identity().serial);
        if (!transport)
            qFatal("%s", transport.error().message.c_str());
        auto source = BridgeSource::open(*std::move(transport), clock, std::move(options));
        if (!source)
            qFatal("%s", source.error().message.c_str());
        return *std::move(source);
    }
};

} // namespace

void TestDeviceUmockdevStream::initTestCase()
{
    QVERIFY2(MockedHidraw::isPreloaded(), "run it by ctest, which preloads umockdev");
}

void TestDeviceUmockdevStream::run_10sAt1kHz_losesNothing()
{
    Bench bench;
    bench.sink.stopAfter = 10000;
    const auto stats = bench.source()->run(bench.sink, {});
    QVERIFY2(stats.ok(), stats ? "" : stats.error().message.c_str());
    QVERIFY(stats->samples >= 10000);
    for (const SampleGap &gap : bench.sink.gaps)
        qInfo("%lld samples lost after %.3f s: %s", static_cast<long long>(gap.lostSamples), gap.startS,
              std::string(gapCauseText(gap.cause)).c_str());
    QCOMPARE(stats->lostSamples, 0);
    QCOMPARE(bench.board->droppedInside(), 0u);
    QVERIFY(bench.sink.gaps.empty() && bench.sink.consistent && bench.sink.timesRise());
    const double lengthS = bench.sink.rows.back().timeS;
    qInfo("%lld samples in %.3f s, none lost", static_cast<long long>(stats->samples), lengthS);
}

// Five reports, between libhidapi and the firmware.
void TestDeviceUmockdevStream::run_lostReports_areCountedBySequenceNumber()
{
    Bench bench;
    bench.board->inject([](SimulatedFaults &faults) {
        faults.loseReports(20, 1);
        faults.loseReports(40, 4);
    });
    bench.sink.stopAfter = 600;
    const auto stats = bench.source()->run(bench.sink, {});
    QVERIFY2(stats.ok(), stats ? "" : stats.error().message.c_str());
    QCOMPARE(bench.sink.gaps.size(), std::size_t(2));
    QCOMPARE(bench.sink.lost(GapCause::ReportsLost), 5 * std::int64_t(BRIDGE_SAMPLES_PER_REPORT));
    QCOMPARE(stats->lostSamples, 5 * std::int64_t(BRIDGE_SAMPLES_PER_REPORT));
}

void TestDeviceUmockdevStream::run_unplugged_endsWithWhatCame()
{
    Bench bench;
    bench.sink.onSamples = [&bench] {
        if (bench.sink.rows.size() >= 300)
            bench.mock.unplug();
    };
    const auto stats = bench.source()->run(bench.sink, {});
    QCOMPARE(stats.error().code, Errc::DeviceUnplugged);
    QVERIFY(stats.error().message.find(bench.mock.node()) != std::string::npos);
    QVERIFY(bench.sink.rows.size() >= 300);
}

// Unplugged after 300 samples and again after 600, back as another node after the third and the first look.
void TestDeviceUmockdevStream::run_unpluggedTwiceAndBack_goesOnBehindGaps()
{
    Bench bench;
    std::size_t unplugAt = 300;
    int looks = 0;
    bench.sink.onSamples = [&] {
        if (bench.sink.rows.size() >= unplugAt) {
            unplugAt += 300;
            bench.mock.unplug();
        }
    };
    bench.sink.stopAfter = 900;
    const std::string before = bench.mock.node();
    auto source = bench.source([&]() -> Result<std::unique_ptr<HidTransport>> {
        ++looks;
        if (looks == 3 || looks == 4)
            bench.mock.plugIn();
        return openListed(bench.board->identity().serial);
    });
    const auto stats = source->run(bench.sink, {});
    QVERIFY2(stats.ok(), stats ? "" : stats.error().message.c_str());
    QCOMPARE(looks, 4);
    QVERIFY(bench.mock.node() != before);
    QCOMPARE(bench.sink.gaps.size(), std::size_t(2));
    for (const SampleGap &gap : bench.sink.gaps) {
        QCOMPARE(gap.cause, GapCause::Unplugged);
        QVERIFY(gap.endS > gap.startS);
    }
    QVERIFY(bench.sink.hasEvent("was unplugged") && bench.sink.hasEvent("is back"));
    QVERIFY(bench.sink.consistent && bench.sink.timesRise());
}

QTEST_APPLESS_MAIN(TestDeviceUmockdevStream)
#include "tst_device_umockdev_stream.moc"
