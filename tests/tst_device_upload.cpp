// A table on its way into the device: whole, refused, cancelled, and cut off at every exchange and at every
// flash operation.
#include "device/table_upload.h"
#include "engine/exports/device_image.h"
#include "support/firmware_device.h"
#include "support/simulated_device.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceUpload : public QObject
{
    Q_OBJECT

private slots:
    void uploadTable_firstTable_isInUseAndReadsBack();
    void uploadTable_withoutActivation_leavesTheOldInUse();
    void uploadTable_otherSensor_isRefusedBeforeAnythingIsSent();
    void uploadTable_kindOrLengthThatDoesNotFit_isRefused();
    void uploadTable_noImage_isRefused();
    void uploadTable_cancelledAnywhere_leavesTheOldInUse();
    void uploadTable_unpluggedAtEveryExchange_oldOrNewWhole();
    void uploadTable_powerCutAtEveryFlashOperation_oldOrNewWhole_data();
    void uploadTable_powerCutAtEveryFlashOperation_oldOrNewWhole();
    void rollBackTable_afterTwoUploads_bringsTheFirstBack();
    void rollBackTable_noTable_isRefused();
    void readTable_bank_isItsImage();
};

namespace {

constexpr int kKnots = 12;

struct Bench
{
    std::shared_ptr<SimulatedBoard> board = *SimulatedBoard::create(quickBoard(10.0));
    Random random{11};
    Bytes oldImage = randomImage(random, kKnots);
    Bytes newImage = randomImage(random, kKnots + 5);

    // With the old table in use.
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
    // The table in use, whole and one of the two; and the status names it.
    bool oldOrNewWhole()
    {
        BridgeClient client = connectTo(board);
        const Bytes image = inUse();
        const auto status = client.status();
        return (image == oldImage || image == newImage) && status->activeBank &&
               status->banks[*status->activeBank].state == BRIDGE_BANK_ACTIVATED;
    }
};

} // namespace

void TestDeviceUpload::uploadTable_firstTable_isInUseAndReadsBack()
{
    Bench bench;
    BridgeClient client = connectTo(bench.board);
    QVERIFY(!readTable(client)->has_value());
    double last = 0.0;
    const auto upload = uploadTable(client, bench.newImage, {}, [&last](const Progress &progress) {
        if (progress.fraction < last)
            qFatal("progress goes back");
        last = progress.fraction;
        return Flow::Continue;
    });
    QVERIFY(upload.ok());
    QCOMPARE(last, 1.0);
    QVERIFY(upload->activated && !upload->before.activeBank);
    QCOMPARE(*upload->after.activeBank, upload->bank);
    QCOMPARE(upload->after.banks[upload->bank].generation, upload->generation);
    QCOMPARE(upload->crc, deviceImageCrc(bench.newImage));
    QCOMPARE(bench.inUse(), bench.newImage);
}

void TestDeviceUpload::uploadTable_withoutActivation_leavesTheOldInUse()
{
    Bench bench = Bench::prepared();
    BridgeClient client = connectTo(bench.board);
    const auto upload = uploadTable(client, bench.newImage, {false});
    QVERIFY(upload.ok());
    QVERIFY(!upload->activated);
    QCOMPARE(upload->after.banks[upload->bank].state, std::uint8_t(BRIDGE_BANK_COMMITTED));
    QCOMPARE(bench.inUse(), bench.oldImage);
    QVERIFY(client.activateTable(upload->generation).ok());
    QCOMPARE(bench.inUse(), bench.newImage);
}

void TestDeviceUpload::uploadTable_otherSensor_isRefusedBeforeAnythingIsSent()
{
    Bench bench = Bench::prepared();
    BridgeClient client = connectTo(bench.board);
    const int operations = bench.board->flashOperations();
    CompensationTable table = randomTable(bench.random, kKnots);
    table.provenance.sensor.serial = "SIM-0002";
    const auto upload = uploadTable(client, imageOf(table, DeviceTableKind::FixedPoint));
    QCOMPARE(upload.error().code, Errc::WrongSensor);
    QVERIFY(upload.error().message.find("SIM-0002") != std::string::npos);
    QVERIFY(upload.error().message.find("SIM-0001") != std::string::npos);
    QCOMPARE(bench.board->flashOperations(), operations);
}

void TestDeviceUpload::uploadTable_kindOrLengthThatDoesNotFit_isRefused()
{
    SimulatedBoardOptions options = quickBoard(10.0);
    options.bankBytes = 1024;
    options.externalThermometer = false;
    const auto board = *SimulatedBoard::create(std::move(options));
    BridgeClient client = connectTo(board);
    Random random(12);
    const auto tooLong = uploadTable(client, randomImage(random, 200));
    QCOMPARE(tooLong.error().code, Errc::DeviceRefused);
    const Bytes external =
        imageOf(randomTable(random, 4), DeviceTableKind::Float, DeviceThermometer::External);
    QCOMPARE(uploadTable(client, external).error().code, Errc::DeviceRefused);
    QCOMPARE(board->flashOperations(), 0);
}

void TestDeviceUpload::uploadTable_noImage_isRefused()
{
    Bench bench;
    BridgeClient client = connectTo(bench.board);
    QCOMPARE(uploadTable(client, Bytes(100, 7)).error().code, Errc::ModelDamaged);
    QCOMPARE(uploadTable(client, {}).error().code, Errc::ModelDamaged);
}

void TestDeviceUpload::uploadTable_cancelledAnywhere_leavesTheOldInUse()
{
    Bench bench = Bench::prepared();
    for (int stopAt = 0;; ++stopAt) {
        BridgeClient client = connectTo(bench.board);
        int reports = 0;
        const auto upload = uploadTable(client, bench.newImage, {}, [&](const Progress &) {
            return reports++ == stopAt ? Flow::Stop : Flow::Continue;
        });
        if (upload) {
            // The last report is of what is done already: nothing is left to be stopped.
            QVERIFY(stopAt > 5);
            break;
        }
        QCOMPARE(upload.error().code, Errc::Cancelled);
        QCOMPARE(bench.inUse(), bench.oldImage);
    }
    QCOMPARE(bench.inUse(), bench.newImage);
}

// A get or a set each; the upload ends when no exchange is left to be cut.
void TestDeviceUpload::uploadTable_unpluggedAtEveryExchange_oldOrNewWhole()
{
    int cuts = 0;
    int withNew = 0;
    for (;; ++cuts) {
        Bench bench = Bench::prepared();
        BridgeClient client = connectTo(bench.board);
        bench.board->inject([&](SimulatedFaults &faults) { faults.unplugAtExchange(cuts); });
        const auto upload = uploadTable(client, bench.newImage);
        if (upload)
            break;
        QCOMPARE(upload.error().code, Errc::DeviceUnplugged);
        bench.board->plugIn();
        QVERIFY2(bench.oldOrNewWhole(), qPrintable(QString("cut at exchange %1").arg(cuts)));
        withNew += bench.inUse() == bench.newImage;
        BridgeClient again = connectTo(bench.board);
        QVERIFY(uploadTable(again, bench.newImage).ok());
        QCOMPARE(bench.inUse(), bench.newImage);
    }
    qInfo("%d exchanges, each cut once; after %d of the cuts the new table was in use", cuts, withNew);
    QVERIFY(cuts > 20 && withNew > 0 && withNew < cuts);
}

void TestDeviceUpload::uploadTable_powerCutAtEveryFlashOperation_oldOrNewWhole_data()
{
    QTest::addColumn<int>("how");
    QTest::newRow("before") << static_cast<int>(PowerCut::Before);
    QTest::newRow("torn") << static_cast<int>(PowerCut::Torn);
    QTest::newRow("after") << static_cast<int>(PowerCut::After);
}

void TestDeviceUpload::uploadTable_powerCutAtEveryFlashOperation_oldOrNewWhole()
{
    QFETCH(int, how);
    int cuts = 0;
    for (;; ++cuts) {
        Bench bench = Bench::prepared();
        BridgeClient client = connectTo(bench.board);
        const int operations = bench.board->flashOperations();
        bench.board->cutPowerAt(cuts, static_cast<PowerCut>(how), 17 + static_cast<std::uint64_t>(cuts));
        const auto upload = uploadTable(client, bench.newImage);
        if (upload && bench.board->flashOperations() - operations <= cuts)
            break;
        if (!bench.board->pluggedIn())
            bench.board->plugIn();
        QVERIFY2(bench.oldOrNewWhole(), qPrintable(QString("cut at operation %1").arg(cuts)));
        BridgeClient again = connectTo(bench.board);
        QVERIFY(uploadTable(again, bench.newImage).ok());
        QCOMPARE(bench.inUse(), bench.newImage);
    }
    qInfo("%d flash operations, each cut once", cuts);
    QVERIFY(cuts > 20);
}

void TestDeviceUpload::rollBackTable_afterTwoUploads_bringsTheFirstBack()
{
    Bench bench = Bench::prepared();
    BridgeClient client = connectTo(bench.board);
    QVERIFY(uploadTable(client, bench.newImage).ok());
    const auto report = rollBackTable(client);
    QVERIFY(report.ok());
    QVERIFY(report->before.activeBank != report->after.activeBank);
    QCOMPARE(bench.inUse(), bench.oldImage);
    QVERIFY(rollBackTable(client).ok());
    QVERIFY(!readTable(client)->has_value());
}

void TestDeviceUpload::rollBackTable_noTable_isRefused()
{
    Bench bench;
    BridgeClient client = connectTo(bench.board);
    QCOMPARE(rollBackTable(client).error().code, Errc::DeviceRefused);
}

void TestDeviceUpload::readTable_bank_isItsImage()
{
    Bench bench = Bench::prepared();
    BridgeClient client = connectTo(bench.board);
    const auto upload = uploadTable(client, bench.newImage, {false});
    QCOMPARE(readTable(client, upload->bank)->value(), bench.newImage);
    QCOMPARE(readTable(client, static_cast<std::uint8_t>(1 - upload->bank))->value(), bench.oldImage);
    QCOMPARE(readTable(client, std::uint8_t{2}).error().code, Errc::InvalidOption);
}

QTEST_APPLESS_MAIN(TestDeviceUpload)
#include "tst_device_upload.moc"
