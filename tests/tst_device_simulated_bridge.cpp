// The simulated board: its samples are the simulator's, nothing is lost unless a fault says so, and its flash
// keeps what it was given.
#include "engine/physics/gyro_simulator.h"
#include "support/firmware_device.h"
#include "support/simulated_device.h"
#include "support/test_data.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;
using namespace std::chrono_literals;

class TestDeviceSimulatedBridge : public QObject
{
    Q_OBJECT

private slots:
    void stream_wholeRun_equalsTheSimulator_data();
    void stream_wholeRun_equalsTheSimulator();
    void stream_tenKilohertz_losesNothing();
    void stream_startedAgain_isTheNextRun();
    void stream_interrupted_goesOn();
    void stream_faultsOfTheSimulation_areOverruns();
    void clock_errorAndStart_areTheDevices();
    void read_notStreaming_timesOut();
    void stall_ringTooSmall_overrunsAndCounts();
    void loss_someReports_isSeenInTheSequence();
    void flashFile_tableUploaded_survivesTheProgram();
    void flashFile_otherSize_isRefused();
    void powerCut_inTheUpload_comesBack();
    void create_badOptions_sayWhy();
};

namespace {

// All reports until none comes for so long or `most` have come.
std::vector<BridgeSamples> readAll(HidTransport &transport, std::chrono::milliseconds patience = 5s,
                                   std::size_t most = SIZE_MAX)
{
    std::vector<BridgeSamples> reports;
    BridgeReport report;
    while (reports.size() < most) {
        const auto length = transport.read(report, patience);
        if (!length.ok() || *length == 0)
            break;
        reports.push_back(*decodeBridgeSamples(report));
    }
    return reports;
}

std::int64_t samplesOf(const std::vector<BridgeSamples> &reports)
{
    std::int64_t count = 0;
    for (const BridgeSamples &report : reports)
        count += report.count;
    return count;
}

// The recording that the board's run number `run` must give.
Recording simulated(const SimulatedBoardOptions &options, double rateHz, int run)
{
    SimulationOptions simulation = options.simulation;
    simulation.gyro.sampleRateHz = rateHz;
    return *simulateRun(simulation, run);
}

bool equalsRecording(const std::vector<BridgeSamples> &reports, const Recording &recording, BridgeRange range)
{
    Eigen::Index row = 0;
    for (const BridgeSamples &report : reports) {
        if (row < recording.size() &&
            *report.externalMilliC != std::lround(recording.temperatureC[row] * 1000.0))
            return false;
        for (std::size_t i = 0; i < static_cast<std::size_t>(report.count); ++i, ++row) {
            if (row >= recording.size())
                return false;
            for (int axis = 0; axis < 3; ++axis) {
                const double difference = range.rateDps(report.counts[i][static_cast<std::size_t>(axis)]) -
                                          recording.rateDps(row, axis);
                if (std::abs(difference) > 1e-9)
                    return false;
            }
        }
    }
    return row == recording.size();
}

} // namespace

void TestDeviceSimulatedBridge::stream_wholeRun_equalsTheSimulator_data()
{
    QTest::addColumn<double>("rateHz");
    QTest::newRow("10 Hz") << 10.0;
    QTest::newRow("190 Hz") << 190.0;
    QTest::newRow("1 kHz") << 1000.0;
}

void TestDeviceSimulatedBridge::stream_wholeRun_equalsTheSimulator()
{
    QFETCH(double, rateHz);
    const SimulatedBoardOptions options = quickBoard(20.0);
    const auto board = *SimulatedBoard::create(options);
    BridgeClient client = connectTo(board);
    const auto rateMilliHz = static_cast<std::uint32_t>(rateHz * 1000.0);
    QVERIFY(client.configure({rateMilliHz, 0, true, false}).ok());
    const auto reports = readAll(client.transport());
    const Recording expected = simulated(options, rateHz, 0);
    QCOMPARE(samplesOf(reports), expected.size());
    QVERIFY(equalsRecording(reports, expected, client.info().ranges[0]));
    for (std::size_t i = 0; i < reports.size(); ++i)
        QCOMPARE(reports[i].sequence, static_cast<std::uint16_t>(i));
    QVERIFY(!client.config()->stream);
    QCOMPARE(client.status()->droppedSamples, 0u);
    QCOMPARE(client.status()->producedSamples, static_cast<std::uint32_t>(expected.size()));
}

void TestDeviceSimulatedBridge::stream_tenKilohertz_losesNothing()
{
    const SimulatedBoardOptions options = quickBoard(10.0);
    const auto board = *SimulatedBoard::create(options);
    BridgeClient client = connectTo(board);
    QVERIFY(client.configure({10000000, 1, true, false}).ok());
    const auto reports = readAll(client.transport());
    QCOMPARE(samplesOf(reports), 100000);
    QCOMPARE(reports.back().sequence, static_cast<std::uint16_t>(reports.size() - 1));
    QCOMPARE(board->droppedInside(), 0u);
}

void TestDeviceSimulatedBridge::stream_startedAgain_isTheNextRun()
{
    const SimulatedBoardOptions options = quickBoard(5.0);
    const auto board = *SimulatedBoard::create(options);
    BridgeClient client = connectTo(board);
    const BridgeRange range = client.info().ranges[0];
    for (int run = 0; run < 3; ++run) {
        QVERIFY(client.configure({100000, 0, true, false}).ok());
        QVERIFY(equalsRecording(readAll(client.transport()), simulated(options, 100.0, run), range));
    }
    QVERIFY(client.configure({100000, 0, true, false}).ok());
    readAll(client.transport(), 5s, 3);
    QVERIFY(client.configure({100000, 0, false, false}).ok());
    readAll(client.transport());
    QVERIFY(client.configure({100000, 0, true, false}).ok());
    QVERIFY(equalsRecording(readAll(client.transport()), simulated(options, 100.0, 4), range));
}

void TestDeviceSimulatedBridge::stream_interrupted_goesOn()
{
    const SimulatedBoardOptions options = quickBoard(5.0);
    const auto board = *SimulatedBoard::create(options);
    BridgeClient client = connectTo(board);
    const BridgeConfig streaming{100000, 0, true, false};
    QVERIFY(client.configure(streaming).ok());
    board->inject([](SimulatedFaults &faults) { faults.unplugAtReport(20); });
    auto before = readAll(client.transport());
    QCOMPARE(before.size(), 20u);
    const double unpluggedS = board->clock().nowS();
    board->plugIn(1.0);
    BridgeClient again = connectTo(board);
    QVERIFY(again.configure(streaming).ok());
    const double resumedS = board->clock().nowS();
    QVERIFY(resumedS >= unpluggedS + 1.0);
    const auto after = readAll(again.transport());
    const Recording expected = simulated(options, 100.0, 0);
    const Eigen::Index skipped = expected.size() - samplesOf(after);
    QCOMPARE(skipped, static_cast<Eigen::Index>(std::ceil(resumedS * 100.0 - 1e-9)));
    Recording rest = expected;
    rest.temperatureC = expected.temperatureC.tail(samplesOf(after)).eval();
    rest.rateDps = expected.rateDps.bottomRows(samplesOf(after)).eval();
    rest.timeS = expected.timeS.tail(samplesOf(after)).eval();
    QVERIFY(equalsRecording(after, rest, again.info().ranges[0]));
    QCOMPARE(after.front().sequence, std::uint16_t(0));
}

void TestDeviceSimulatedBridge::stream_faultsOfTheSimulation_areOverruns()
{
    SimulatedBoardOptions options = quickBoard(60.0);
    options.simulation.faults.gaps = 3;
    options.simulation.faults.gapS = 2.0;
    const auto board = *SimulatedBoard::create(options);
    BridgeClient client = connectTo(board);
    QVERIFY(client.configure({100000, 0, true, false}).ok());
    const auto reports = readAll(client.transport());
    QCOMPARE(samplesOf(reports), simulated(options, 100.0, 0).size());
    int overruns = 0;
    for (const BridgeSamples &report : reports)
        overruns += report.has(BRIDGE_FLAG_OVERRUN) ? 1 : 0;
    QCOMPARE(overruns, 3);
    QCOMPARE(static_cast<std::int64_t>(board->droppedInside()) + samplesOf(reports), 6000);
}

void TestDeviceSimulatedBridge::clock_errorAndStart_areTheDevices()
{
    SimulatedBoardOptions options = quickBoard(100.0);
    options.clockErrorPpm = 200.0;
    options.powerUpClockUs = 0xFFFFFFFFu - 49999999u; // wraps after 50 s
    const auto board = *SimulatedBoard::create(options);
    BridgeClient client = connectTo(board);
    QVERIFY(client.configure({10000, 0, true, false}).ok());
    const auto reports = readAll(client.transport());
    QCOMPARE(reports.front().timeUs, options.powerUpClockUs);
    QVERIFY(reports.back().timeUs < 60000000u);
    const std::uint32_t elapsedUs = reports.back().timeUs - reports.front().timeUs;
    const auto samples = static_cast<double>(samplesOf(reports) - reports.back().count);
    QCOMPARE(elapsedUs, static_cast<std::uint32_t>(std::lround(samples * 0.1 * 1000200.0)));
}

void TestDeviceSimulatedBridge::read_notStreaming_timesOut()
{
    const auto board = *SimulatedBoard::create(quickBoard(5.0));
    BridgeClient client = connectTo(board);
    BridgeReport report;
    const double beforeS = board->clock().nowS();
    QCOMPARE(*client.transport().read(report, 250ms), std::size_t(0));
    QCOMPARE(board->clock().nowS() - beforeS, 0.25);
    QCOMPARE(client.transport().write(report).error().code, Errc::DeviceRefused);
    BridgeReport unknown{0x77};
    QCOMPARE(client.transport().getFeature(unknown).error().code, Errc::DeviceRefused);
}

void TestDeviceSimulatedBridge::stall_ringTooSmall_overrunsAndCounts()
{
    SimulatedBoardOptions options = quickBoard(20.0);
    options.ringReports = 8;
    const auto board = *SimulatedBoard::create(options);
    BridgeClient client = connectTo(board);
    QVERIFY(client.configure({1000000, 0, true, false}).ok());
    board->inject([](SimulatedFaults &faults) { faults.stall(10, 3.0); });
    std::vector<BridgeSamples> reports;
    for (int silences = 0; client.config()->stream;) {
        const auto some = readAll(client.transport(), 100ms);
        silences += some.empty() ? 1 : 0;
        QVERIFY(silences < 100);
        reports.insert(reports.end(), some.begin(), some.end());
    }
    QVERIFY(board->droppedInside() > 2900u && board->droppedInside() < 3000u);
    QCOMPARE(samplesOf(reports) + board->droppedInside(), 20000);
    for (std::size_t i = 0; i < reports.size(); ++i) {
        QCOMPARE(reports[i].sequence, static_cast<std::uint16_t>(i));
        QCOMPARE(reports[i].has(BRIDGE_FLAG_OVERRUN), i == 18);
    }
}

void TestDeviceSimulatedBridge::loss_someReports_isSeenInTheSequence()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    QVERIFY(client.configure({700000, 0, true, false}).ok());
    board->inject([](SimulatedFaults &faults) {
        faults.loseReports(5, 3);
        faults.loseReports(100, 1);
    });
    const auto reports = readAll(client.transport());
    QCOMPARE(samplesOf(reports), 7000 - 4 * 7);
    QCOMPARE(reports[4].sequence, std::uint16_t(4));
    QCOMPARE(reports[5].sequence, std::uint16_t(8));
    QCOMPARE(reports[97].sequence, std::uint16_t(101));
}

void TestDeviceSimulatedBridge::flashFile_tableUploaded_survivesTheProgram()
{
    const std::filesystem::path file = scratchFolder() / "board.flash";
    SimulatedBoardOptions options = quickBoard(5.0);
    options.flashFile = file;
    Random random(3);
    const Bytes image = randomImage(random, 20);
    {
        const auto board = *SimulatedBoard::create(options);
        const auto transport = *SimulatedBridge::open(board);
        for (const Report &report : uploadReports(image, 1))
            QVERIFY(transport->sendFeature(report).ok());
        QVERIFY(transport->sendFeature(generationReport(BRIDGE_REPORT_ACTIVATE, 1)).ok());
    }
    const auto board = *SimulatedBoard::create(options);
    BridgeClient client = connectTo(board);
    const auto status = client.status();
    QVERIFY(status->activeBank.has_value());
    QCOMPARE(*client.readImage(*status->activeBank, static_cast<std::uint32_t>(image.size())), image);
}

void TestDeviceSimulatedBridge::flashFile_otherSize_isRefused()
{
    SimulatedBoardOptions options = quickBoard(5.0);
    options.flashFile = scratchFolder() / "no.flash";
    QFile file(QString::fromStdString(options.flashFile.string()));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("no flash");
    file.close();
    QCOMPARE(SimulatedBoard::create(options).error().code, Errc::InvalidOption);
}

void TestDeviceSimulatedBridge::powerCut_inTheUpload_comesBack()
{
    const auto board = *SimulatedBoard::create(quickBoard(5.0));
    Random random(4);
    const Bytes image = randomImage(random, 20);
    auto transport = *SimulatedBridge::open(board);
    board->cutPowerAt(10, PowerCut::Torn, 1);
    Status sent;
    for (const Report &report : uploadReports(image, 1)) {
        sent = transport->sendFeature(report);
        if (!sent)
            break;
    }
    QCOMPARE(sent.error().code, Errc::DeviceUnplugged);
    QVERIFY(!board->pluggedIn());
    board->plugIn();
    QCOMPARE(transport->sendFeature(makeReport(BRIDGE_REPORT_CONFIG)).error().code, Errc::DeviceUnplugged);
    BridgeClient client = connectTo(board);
    QVERIFY(!client.status()->activeBank);
    QCOMPARE(client.status()->receivedBytes, 0u);
}

void TestDeviceSimulatedBridge::create_badOptions_sayWhy()
{
    SimulatedBoardOptions fine = quickBoard(5.0);
    auto broken = fine;
    broken.simulation.gyro.sensitivityMdps = 0.0;
    QCOMPARE(SimulatedBoard::create(broken).error().code, Errc::InvalidOption);
    broken = fine;
    broken.speed = -1.0;
    QCOMPARE(SimulatedBoard::create(broken).error().code, Errc::InvalidOption);
    broken = fine;
    broken.bankBytes = 1001;
    QCOMPARE(SimulatedBoard::create(broken).error().code, Errc::InvalidOption);
    broken = fine;
    broken.simulation.sensor.serial = "a serial number that is too long";
    QCOMPARE(SimulatedBoard::create(broken).error().code, Errc::InvalidOption);
    broken = fine;
    broken.highestRateHz = 0.5;
    QCOMPARE(SimulatedBoard::create(broken).error().code, Errc::InvalidOption);
    QVERIFY(SimulatedBoard::create(fine).ok());
}

QTEST_APPLESS_MAIN(TestDeviceSimulatedBridge)
#include "tst_device_simulated_bridge.moc"
