// What a device compensates, compared with the host bit for bit: equal for every kind of table, different as
// soon as one count is; and an upload whose table does not do what it should is taken back.
#include "device/compensation_check.h"
#include "device/table_upload.h"
#include "support/firmware_device.h"
#include "support/models_for_export.h"
#include "support/simulated_device.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceCompensationCheck : public QObject
{
    Q_OBJECT

private slots:
    void check_randomTables_areEqualBitForBit();
    void check_otherTable_differs();
    void check_oneCountOff_differs();
    void check_lostAndDamagedReports_comparesTheRest();
    void check_configuration_isRestored_data();
    void check_configuration_isRestored();
    void check_deviceThatCannotPair_isRefused();
    void upload_wrongCompensation_isRolledBack();
    void upload_wrongCompensationOfFirstTable_leavesNone();
    void upload_streamThatStaysAway_isRolledBack();
    void upload_thermometerNotRead_isNotTaken();
    void upload_unpluggedAnywhereInTheComparison_saysSoWhereTheTableIsInUse();
    void upload_deviceThatCannotPair_saysThatNothingWasCompared();
};

namespace {

constexpr CompensationCheckOptions kShort{70, 1000.0, 0.5};

struct Bench
{
    explicit Bench(SimulatedBoardOptions options = quickBoard(10.0))
        : board(*SimulatedBoard::create(std::move(options)))
    {
    }
    // With a table in use that does what it should.
    static Bench prepared()
    {
        Bench bench;
        BridgeClient client = connectTo(bench.board);
        if (!uploadTable(client, bench.oldImage))
            qFatal("the first table could not be uploaded");
        return bench;
    }
    Bytes inUse()
    {
        BridgeClient client = connectTo(board);
        const auto image = readTable(client);
        if (!image)
            qFatal("%s", image.error().message.c_str());
        return image->value_or(Bytes());
    }
    void miscompensate(int counts)
    {
        board->inject([&](SimulatedFaults &faults) { faults.compensateWrongly(counts); });
    }

    std::shared_ptr<SimulatedBoard> board;
    Random random{21};
    Bytes oldImage = randomImage(random, 12);
    Bytes newImage = randomImage(random, 15);
};

DeviceImage decoded(const Bytes &image)
{
    return *decodeDeviceImage(image, "the table");
}

TableUploadOptions quickUpload()
{
    TableUploadOptions options;
    options.checkOptions = kShort;
    return options;
}

} // namespace

void TestDeviceCompensationCheck::check_randomTables_areEqualBitForBit()
{
    Bench bench;
    Random random = announced(20261311);
    BridgeClient client = connectTo(bench.board);
    for (int round = 0; round < 12; ++round) {
        const auto kind = round % 2 == 0 ? DeviceTableKind::FixedPoint : DeviceTableKind::Float;
        const auto thermometer = round % 3 == 0 ? DeviceThermometer::External : DeviceThermometer::Die;
        // The largest saturate what is sent.
        const Bytes image = imageOf(randomTable(random, 20, round % 4 == 0 ? 300.0 : 2.0), kind, thermometer);
        BridgeConfig config = *client.config();
        config.range = static_cast<std::uint8_t>(round % 3);
        QVERIFY(client.configure(config).ok());
        const auto upload = uploadTable(client, image, quickUpload());
        QVERIFY2(upload.ok(), upload ? "" : upload.error().message.c_str());
        QVERIFY(upload->activated && !upload->rolledBack && upload->check && upload->check->passed());
        QVERIFY(upload->check->samples >= kShort.samples);
        QCOMPARE(upload->check->worstCounts, 0);
        QVERIFY(upload->check->lowestC <= upload->check->highestC && upload->check->lowestC > 10.0);
        QCOMPARE(client.config()->range, config.range);
    }
}

void TestDeviceCompensationCheck::check_otherTable_differs()
{
    Bench bench = Bench::prepared();
    BridgeClient client = connectTo(bench.board);
    const auto own = checkCompensation(client, decoded(bench.oldImage), kShort);
    QVERIFY(own.ok() && own->passed());
    const auto other = checkCompensation(client, decoded(bench.newImage), kShort);
    QVERIFY(other.ok() && !other->passed());
    QVERIFY(other->differing == other->samples && other->worstCounts > 0);
    QCOMPARE(other->worstDps, client.info().ranges[0].rateDps(other->worstCounts));
}

void TestDeviceCompensationCheck::check_oneCountOff_differs()
{
    Bench bench = Bench::prepared();
    BridgeClient client = connectTo(bench.board);
    for (const int counts : {1, -1, 7}) {
        bench.miscompensate(counts);
        const auto check = checkCompensation(client, decoded(bench.oldImage), kShort);
        QVERIFY(check.ok() && !check->passed());
        QCOMPARE(check->worstCounts, std::abs(counts));
        QCOMPARE(check->differing, check->samples);
    }
}

void TestDeviceCompensationCheck::check_lostAndDamagedReports_comparesTheRest()
{
    Bench bench = Bench::prepared();
    BridgeClient client = connectTo(bench.board);
    // A twin, a compensated report, both, and two that can't be read.
    bench.board->inject([](SimulatedFaults &faults) {
        faults.loseReports(1, 1);
        faults.loseReports(4, 1);
        faults.loseReports(6, 2);
        faults.damageReports(9, 2);
    });
    const auto check = checkCompensation(client, decoded(bench.oldImage), kShort);
    QVERIFY(check.ok() && check->passed());
    QCOMPARE(check->rawSamples, 0);
}

void TestDeviceCompensationCheck::check_configuration_isRestored_data()
{
    QTest::addColumn<bool>("stream");
    QTest::addColumn<bool>("compensate");
    QTest::addColumn<int>("counts");
    QTest::newRow("at rest") << false << true << 0;
    QTest::newRow("at rest, raw") << false << false << 0;
    QTest::newRow("streaming") << true << true << 0;
    QTest::newRow("streaming raw") << true << false << 0;
    QTest::newRow("streaming, not passed") << true << true << 5;
}

void TestDeviceCompensationCheck::check_configuration_isRestored()
{
    QFETCH(bool, stream);
    QFETCH(bool, compensate);
    QFETCH(int, counts);
    Bench bench = Bench::prepared();
    bench.miscompensate(counts);
    BridgeClient client = connectTo(bench.board);
    const BridgeConfig before{100000, 1, stream, compensate, false};
    QVERIFY(client.configure(before).ok());
    const auto check = checkCompensation(client, decoded(bench.oldImage), kShort);
    QVERIFY(check.ok());
    QCOMPARE(check->passed(), counts == 0);
    QVERIFY(*client.config() == before);
    // Stopped by the hook as well.
    const auto stopped = checkCompensation(client, decoded(bench.oldImage), kShort,
                                           [](const Progress &) { return Flow::Stop; });
    QCOMPARE(stopped.error().code, Errc::Cancelled);
    QVERIFY(*client.config() == before);
}

void TestDeviceCompensationCheck::check_deviceThatCannotPair_isRefused()
{
    SimulatedBoardOptions options = quickBoard(10.0);
    options.ringReports = 1;
    Bench bench(std::move(options));
    BridgeClient client = connectTo(bench.board);
    QCOMPARE(checkCompensation(client, decoded(bench.oldImage), kShort).error().code, Errc::DeviceRefused);
}

void TestDeviceCompensationCheck::upload_wrongCompensation_isRolledBack()
{
    Bench bench = Bench::prepared();
    bench.miscompensate(3);
    BridgeClient client = connectTo(bench.board);
    const auto upload = uploadTable(client, bench.newImage, quickUpload());
    QVERIFY(upload.ok());
    QVERIFY(upload->rolledBack && !upload->activated && upload->check && !upload->check->passed());
    QCOMPARE(upload->check->worstCounts, 3);
    QCOMPARE(upload->after.activeBank, upload->before.activeBank);
    QCOMPARE(upload->after.banks[upload->bank].state, std::uint8_t(BRIDGE_BANK_REVOKED));
    QCOMPARE(bench.inUse(), bench.oldImage);
}

void TestDeviceCompensationCheck::upload_wrongCompensationOfFirstTable_leavesNone()
{
    Bench bench;
    bench.miscompensate(-1);
    BridgeClient client = connectTo(bench.board);
    const auto upload = uploadTable(client, bench.newImage, quickUpload());
    QVERIFY(upload.ok() && upload->rolledBack && !upload->after.activeBank);
    QVERIFY(!client.config()->compensate);
    QVERIFY(bench.inUse().empty());
}

void TestDeviceCompensationCheck::upload_streamThatStaysAway_isRolledBack()
{
    Bench bench = Bench::prepared();
    bench.board->inject([](SimulatedFaults &faults) { faults.loseReports(0, 1000000); });
    BridgeClient client = connectTo(bench.board);
    const auto upload = uploadTable(client, bench.newImage, quickUpload());
    QVERIFY(upload.ok() && upload->rolledBack && upload->check);
    QCOMPARE(upload->check->samples, 0);
    QCOMPARE(bench.inUse(), bench.oldImage);
}

void TestDeviceCompensationCheck::upload_thermometerNotRead_isNotTaken()
{
    SimulatedBoardOptions options = quickBoard(10.0);
    options.externalThermometer = false;
    Bench bench(std::move(options));
    BridgeClient client = connectTo(bench.board);
    QVERIFY(uploadTable(client, bench.newImage, quickUpload()).ok());
    // The image of another thermometer than the one that the table in use is looked up with.
    DeviceImage image = decoded(bench.newImage);
    image.thermometer = DeviceThermometer::External;
    const auto check = checkCompensation(client, image, kShort);
    QVERIFY(check.ok() && !check->passed());
    QCOMPARE(check->samples, 0);
}

void TestDeviceCompensationCheck::upload_unpluggedAnywhereInTheComparison_saysSoWhereTheTableIsInUse()
{
    int cuts = 0;
    for (;; ++cuts) {
        Bench bench = Bench::prepared();
        BridgeClient client = connectTo(bench.board);
        bench.board->inject([&](SimulatedFaults &faults) { faults.unplugAtReport(cuts); });
        const auto upload = uploadTable(client, bench.newImage, quickUpload());
        if (upload)
            break;
        QCOMPARE(upload.error().code, Errc::DeviceUnplugged);
        QVERIFY(upload.error().message.find("was not compared") != std::string::npos);
        bench.board->plugIn();
        QCOMPARE(bench.inUse(), bench.newImage);
    }
    qInfo("%d reports, each cut once", cuts);
    QVERIFY(cuts >= 2 * kShort.samples / 7);
}

void TestDeviceCompensationCheck::upload_deviceThatCannotPair_saysThatNothingWasCompared()
{
    SimulatedBoardOptions options = quickBoard(10.0);
    options.ringReports = 1;
    Bench bench(std::move(options));
    BridgeClient client = connectTo(bench.board);
    const auto upload = uploadTable(client, bench.newImage);
    QVERIFY(upload.ok() && upload->activated && !upload->check && !upload->rolledBack);
}

QTEST_APPLESS_MAIN(TestDeviceCompensationCheck)
#include "tst_device_compensation_check.moc"
