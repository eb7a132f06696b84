// The real device path, first part: the unmodified libhidapi, over umockdev, with the reference firmware
// behind it. Found, opened, asked, refused, unplugged and plugged in again.
#include "device/bridge/bridge_client.h"
#include "device/hidapi_transport.h"
#include "device/table_upload.h"
#include "support/firmware_device.h"
#include "support/mocked_hidraw.h"
#include "support/real_device.h"

#include <QTest>

#include <cerrno>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceUmockdev : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();

    void list_pluggedIn_isFoundWithItsNames();
    void list_unplugged_isNotFound();
    void open_unpluggedSinceItWasListed_isNotFound();
    void open_whileOpen_isInUse();
    void client_infoConfigStatus_areTheBoards();
    void client_otherProtocolVersion_isRefused();
    void configure_everyRange_readsBack();
    void configure_impossibleRate_isRefusedWithTheReason();
    void configure_refusalStalledOnTheBus_isRefusedWithTheReason();
    void getFeature_unknownReport_isRefused();
    void exchange_unplugged_saysSo();
    void exchange_cutOffByTheCable_isUnplugged();
    void exchange_damagedButStillThere_isRefused();
    void upload_wholeTable_isInUseAndReadsBack();
    void upload_otherSensor_isRefused();
    void upload_unpluggedAtEveryExchange_oldOrNewWhole();
    void rollBack_afterTwoUploads_bringsTheFirstBack();
};

namespace {

constexpr int kKnots = 12;

struct Bench
{
    std::shared_ptr<SimulatedBoard> board = *SimulatedBoard::create(realTimeBoard());
    MockedHidraw mock{board};
    SteadyClock clock;

    std::unique_ptr<HidTransport> open()
    {
        auto device = openListed(board->identity().serial);
        if (!device)
            qFatal("%s", device.error().message.c_str());
        return *std::move(device);
    }
    BridgeClient client()
    {
        auto client = BridgeClient::open(open(), clock);
        if (!client)
            qFatal("%s", client.error().message.c_str());
        return *std::move(client);
    }
    Bytes tableInUse()
    {
        BridgeClient reader = client();
        return tableInUse(reader);
    }
    // By the one who has it open: nobody else can.
    static Bytes tableInUse(BridgeClient &reader)
    {
        const auto image = readTable(reader);
        if (!image)
            qFatal("%s", image.error().message.c_str());
        return image->value_or(Bytes());
    }
};

} // namespace

void TestDeviceUmockdev::initTestCase()
{
    QVERIFY2(MockedHidraw::isPreloaded(), "run it by ctest, which preloads umockdev");
}

void TestDeviceUmockdev::list_pluggedIn_isFoundWithItsNames()
{
    Bench bench;
    const auto found = listed(bench.board->identity().serial);
    QVERIFY(found.has_value());
    const HidIdentity &truth = bench.board->identity();
    QCOMPARE(found->vendorId, truth.vendorId);
    QCOMPARE(found->productId, truth.productId);
    QCOMPARE(found->manufacturer, truth.manufacturer);
    QCOMPARE(found->product, truth.product);
    QCOMPARE(found->path, bench.mock.node());
    QCOMPARE(found->interfaceNumber, 0);
    QCOMPARE(listHidDevices().size(), std::size_t(1));
}

void TestDeviceUmockdev::list_unplugged_isNotFound()
{
    Bench bench;
    bench.mock.unplug();
    QVERIFY(listHidDevices().empty());
    bench.mock.plugIn();
    QCOMPARE(listed(bench.board->identity().serial)->path, bench.mock.node());
}

void TestDeviceUmockdev::open_unpluggedSinceItWasListed_isNotFound()
{
    Bench bench;
    const HidIdentity found = *listed(bench.board->identity().serial);
    bench.mock.unplug();
    QCOMPARE(openHidDevice(found).error().code, Errc::DeviceNotFound);
}

void TestDeviceUmockdev::open_whileOpen_isInUse()
{
    Bench bench;
    {
        const auto first = bench.open();
        const auto second = openListed(bench.board->identity().serial);
        QVERIFY(!second.ok());
        QCOMPARE(second.error().code, Errc::DeviceInUse);
        QVERIFY(second.error().message.find("Another program") != std::string::npos);
    }
    QVERIFY(openListed(bench.board->identity().serial).ok());
}

void TestDeviceUmockdev::client_infoConfigStatus_areTheBoards()
{
    Bench bench;
    BridgeClient client = bench.client();
    QCOMPARE(client.info().sensor.model, std::string("L3GD20H"));
    QCOMPARE(client.info().sensor.serial, bench.board->identity().serial);
    QCOMPARE(client.info().ranges.size(), std::size_t(3));
    QVERIFY(!client.config()->stream);
    const auto status = client.status();
    QVERIFY(!status->activeBank);
    QCOMPARE(status->producedSamples, 0u);
}

void TestDeviceUmockdev::client_otherProtocolVersion_isRefused()
{
    Bench bench;
    bench.board->inject([](SimulatedFaults &faults) { faults.pretendMajor(9); });
    QCOMPARE(BridgeClient::open(bench.open(), bench.clock).error().code, Errc::ProtocolVersion);
}

void TestDeviceUmockdev::configure_everyRange_readsBack()
{
    Bench bench;
    BridgeClient client = bench.client();
    for (std::uint8_t range = 0; range < client.info().ranges.size(); ++range) {
        BridgeConfig config = *client.config();
        config.range = range;
        config.rateMilliHz = 100000u + range;
        QVERIFY(client.configure(config).ok());
        QCOMPARE(client.config()->range, range);
        QCOMPARE(client.config()->rateMilliHz, 100000u + range);
    }
}

void TestDeviceUmockdev::configure_impossibleRate_isRefusedWithTheReason()
{
    Bench bench;
    BridgeClient client = bench.client();
    const BridgeConfig before = *client.config();
    BridgeConfig config = before;
    config.rateMilliHz = 20000000;
    QCOMPARE(client.configure(config).error().code, Errc::DeviceRefused);
    QCOMPARE(client.lastResult(), std::uint8_t(BRIDGE_RESULT_BAD_VALUE));
    QCOMPARE(client.config()->rateMilliHz, before.rateMilliHz);
}

void TestDeviceUmockdev::configure_refusalStalledOnTheBus_isRefusedWithTheReason()
{
    Bench bench;
    bench.board->inject([](SimulatedFaults &faults) { faults.stallRefusedSets(true); });
    BridgeClient client = bench.client();
    BridgeConfig config = *client.config();
    config.compensate = true; // without a table
    QCOMPARE(client.configure(config).error().code, Errc::DeviceRefused);
    QCOMPARE(client.lastResult(), std::uint8_t(BRIDGE_RESULT_NOTHING_THERE));
}

void TestDeviceUmockdev::getFeature_unknownReport_isRefused()
{
    Bench bench;
    const auto device = bench.open();
    std::array<std::uint8_t, 65> report{0x55};
    QCOMPARE(device->getFeature(report).error().code, Errc::DeviceRefused);
    report[0] = BRIDGE_REPORT_INFO;
    QCOMPARE(*device->getFeature(report), std::size_t(BRIDGE_REPORT_SIZE));
}

void TestDeviceUmockdev::exchange_unplugged_saysSo()
{
    Bench bench;
    const auto device = bench.open();
    bench.mock.unplug();
    std::array<std::uint8_t, 65> report{BRIDGE_REPORT_INFO};
    QCOMPARE(device->getFeature(report).error().code, Errc::DeviceUnplugged);
    report[0] = BRIDGE_REPORT_CONFIG;
    QCOMPARE(device->sendFeature(std::span(report).first(64)).error().code, Errc::DeviceUnplugged);
    QCOMPARE(device->read(report, std::chrono::milliseconds(100)).error().code, Errc::DeviceUnplugged);
}

// The kernel's words are those of a bad exchange; the end of the device follows.
void TestDeviceUmockdev::exchange_cutOffByTheCable_isUnplugged()
{
    for (const bool taken : {false, true}) {
        Bench bench;
        const auto device = bench.open();
        bench.mock.failWith(EIO);
        bench.board->inject([](SimulatedFaults &faults) { faults.unplugAtExchange(0); });
        std::array<std::uint8_t, 64> report{BRIDGE_REPORT_CONFIG};
        const Error error = taken ? device->sendFeature(report).error() : device->getFeature(report).error();
        QVERIFY2(error.code == Errc::DeviceUnplugged, error.message.c_str());
    }
}

void TestDeviceUmockdev::exchange_damagedButStillThere_isRefused()
{
    Bench bench;
    const auto device = bench.open();
    bench.mock.failWith(EIO);
    std::array<std::uint8_t, 65> report{0x55};
    const Error error = device->getFeature(report).error();
    QCOMPARE(error.code, Errc::DeviceRefused);
    QVERIFY(error.message.find("Input/output error") != std::string::npos);
    report[0] = BRIDGE_REPORT_INFO;
    QVERIFY(device->getFeature(report).ok());
}

void TestDeviceUmockdev::upload_wholeTable_isInUseAndReadsBack()
{
    Bench bench;
    Random random(21);
    const Bytes image = randomImage(random, 200);
    BridgeClient client = bench.client();
    const auto upload = uploadTable(client, image);
    QVERIFY2(upload.ok(), upload ? "" : upload.error().message.c_str());
    QVERIFY(upload->activated);
    QCOMPARE(Bench::tableInUse(client), image);
}

void TestDeviceUmockdev::upload_otherSensor_isRefused()
{
    Bench bench;
    Random random(22);
    CompensationTable table = randomTable(random, kKnots);
    table.provenance.sensor.serial = "SIM-0002";
    BridgeClient client = bench.client();
    QCOMPARE(uploadTable(client, imageOf(table, DeviceTableKind::Float)).error().code, Errc::WrongSensor);
    QCOMPARE(bench.board->flashOperations(), 0);
}

// A get or a set each; the upload ends when no exchange is left to be cut.
void TestDeviceUmockdev::upload_unpluggedAtEveryExchange_oldOrNewWhole()
{
    Bench bench;
    Random random(23);
    const Bytes oldImage = randomImage(random, kKnots);
    const Bytes newImage = randomImage(random, kKnots + 5);
    int cuts = 0;
    int withNew = 0;
    for (;; ++cuts) {
        if (bench.tableInUse() != oldImage) {
            BridgeClient client = bench.client();
            QVERIFY(uploadTable(client, oldImage).ok());
        }
        BridgeClient client = bench.client();
        bench.board->inject([cuts](SimulatedFaults &faults) { faults.unplugAtExchange(cuts); });
        const auto upload = uploadTable(client, newImage);
        if (upload)
            break;
        const QByteArray where = QByteArray("cut at exchange ") + QByteArray::number(cuts);
        QVERIFY2(upload.error().code == Errc::DeviceUnplugged, where + upload.error().message.c_str());
        bench.mock.plugIn();
        const Bytes inUse = bench.tableInUse();
        QVERIFY2(inUse == oldImage || inUse == newImage, where);
        withNew += inUse == newImage;
    }
    qInfo("%d exchanges, each cut once; after %d of the cuts the new table was in use", cuts, withNew);
    QVERIFY(cuts > 20 && withNew > 0 && withNew < cuts);
}

void TestDeviceUmockdev::rollBack_afterTwoUploads_bringsTheFirstBack()
{
    Bench bench;
    Random random(24);
    const Bytes first = randomImage(random, kKnots);
    const Bytes second = randomImage(random, kKnots);
    BridgeClient client = bench.client();
    QVERIFY(uploadTable(client, first).ok());
    QVERIFY(uploadTable(client, second).ok());
    QCOMPARE(Bench::tableInUse(client), second);
    QVERIFY(rollBackTable(client).ok());
    QCOMPARE(Bench::tableInUse(client), first);
}

QTEST_APPLESS_MAIN(TestDeviceUmockdev)
#include "tst_device_umockdev.moc"
