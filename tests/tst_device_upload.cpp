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
    void uploadTable_unpluggedAtEveryExchangeOfTheRollback_oldOrNewWhole();
    void uploadTable_powerCutAtEveryFlashOperation_oldOrNewWhole_data();
    void uploadTable_powerCutAtEveryFlashOperation_oldOrNewWhole();
    void uploadTable_otherBytesInTheBank_areFoundBeforeCommit();
    void rollBackTable_afterTwoUploads_bringsTheFirstBack();
    void rollBackTable_noTable_isRefused();
    void readTable_bank_isItsImage();
};

namespace {

constexpr int kKnots = 12;

// What the comparison is worth is shown by tst_device_compensation_check; here it is cut, too.
TableUploadOptions quick(bool activate = true)
{
    TableUploadOptions options;
    options.activate = activate;
    options.checkOptions = {21, 1000.0, 0.5};
    return options;
}

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
        if (!uploadTable(client, bench.oldImage, quick()))
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

// A link on which one bit of what is read back flips.
class FlippingTransport final : public HidTransport
{
public:
    explicit FlippingTransport(std::unique_ptr<HidTransport> below) : m_below(std::move(below)) {}

    const HidIdentity &identity() const override { return m_below->identity(); }
    Result<std::size_t> read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout) override
    {
        return m_below->read(report, timeout);
    }
    Status write(std::span<const std::uint8_t> report) override { return m_below->write(report); }
    Result<std::size_t> getFeature(std::span<std::uint8_t> report) override
    {
        const auto length = m_below->getFeature(report);
        if (report[0] == BRIDGE_REPORT_READ && report[BRIDGE_READ_OFFSET] == BRIDGE_READ_BYTES)
            report[BRIDGE_READ_DATA + 9] ^= 4;
        return length;
    }
    Status sendFeature(std::span<const std::uint8_t> report) override { return m_below->sendFeature(report); }

private:
    std::unique_ptr<HidTransport> m_below;
};

// A link that is cut so many exchanges after the host begins to roll a table back; 0 cuts that command
// itself.
class CutAfterRollback final : public HidTransport
{
public:
    CutAfterRollback(std::unique_ptr<HidTransport> below, std::shared_ptr<SimulatedBoard> board,
                     int exchanges)
        : m_below(std::move(below)), m_board(std::move(board)), m_exchanges(exchanges)
    {
    }

    const HidIdentity &identity() const override { return m_below->identity(); }
    Result<std::size_t> read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout) override
    {
        return m_below->read(report, timeout);
    }
    Status write(std::span<const std::uint8_t> report) override { return m_below->write(report); }
    Result<std::size_t> getFeature(std::span<std::uint8_t> report) override
    {
        return m_below->getFeature(report);
    }
    Status sendFeature(std::span<const std::uint8_t> report) override
    {
        if (report[0] == BRIDGE_REPORT_ROLLBACK && !m_begun) {
            m_begun = true;
            m_board->inject([this](SimulatedFaults &faults) { faults.unplugAtExchange(m_exchanges); });
        }
        return m_below->sendFeature(report);
    }

private:
    std::unique_ptr<HidTransport> m_below;
    std::shared_ptr<SimulatedBoard> m_board;
    int m_exchanges;
    bool m_begun = false;
};

} // namespace

void TestDeviceUpload::uploadTable_firstTable_isInUseAndReadsBack()
{
    Bench bench;
    BridgeClient client = connectTo(bench.board);
    QVERIFY(!readTable(client)->has_value());
    double last = 0.0;
    const auto upload = uploadTable(client, bench.newImage, quick(), [&last](const Progress &progress) {
        if (progress.fraction < last)
            qFatal("progress goes back");
        last = progress.fraction;
        return Flow::Continue;
    });
    QVERIFY(upload.ok());
    QCOMPARE(last, 1.0);
    QVERIFY(upload->activated && !upload->before.activeBank);
    QVERIFY(upload->check && upload->check->passed() && !upload->rolledBack);
    QCOMPARE(*upload->after.activeBank, upload->bank);
    QCOMPARE(upload->after.banks[upload->bank].generation, upload->generation);
    QCOMPARE(upload->crc, deviceImageCrc(bench.newImage));
    QCOMPARE(bench.inUse(), bench.newImage);
}

void TestDeviceUpload::uploadTable_withoutActivation_leavesTheOldInUse()
{
    Bench bench = Bench::prepared();
    BridgeClient client = connectTo(bench.board);
    const auto upload = uploadTable(client, bench.newImage, quick(false));
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
        const auto upload = uploadTable(client, bench.newImage, quick(), [&](const Progress &) {
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
        const auto upload = uploadTable(client, bench.newImage, quick());
        if (upload)
            break;
        QCOMPARE(upload.error().code, Errc::DeviceUnplugged);
        bench.board->plugIn();
        QVERIFY2(bench.oldOrNewWhole(), qPrintable(QString("cut at exchange %1").arg(cuts)));
        withNew += bench.inUse() == bench.newImage;
        BridgeClient again = connectTo(bench.board);
        QVERIFY(uploadTable(again, bench.newImage, quick()).ok());
        QCOMPARE(bench.inUse(), bench.newImage);
    }
    qInfo("%d exchanges, each cut once; after %d of the cuts the new table was in use", cuts, withNew);
    QVERIFY(cuts > 20 && withNew > 0 && withNew < cuts);
}

// A device that compensates wrongly: the first cut lies where the comparison has just found that.
void TestDeviceUpload::uploadTable_unpluggedAtEveryExchangeOfTheRollback_oldOrNewWhole()
{
    int cuts = 0;
    int withNew = 0;
    for (;; ++cuts) {
        Bench bench = Bench::prepared();
        auto link =
            std::make_unique<CutAfterRollback>(*SimulatedBridge::open(bench.board), bench.board, cuts);
        BridgeClient client = *BridgeClient::open(std::move(link), bench.board->clock());
        bench.board->inject([](SimulatedFaults &faults) { faults.compensateWrongly(3); });
        const auto upload = uploadTable(client, bench.newImage, quick());
        if (upload) {
            QVERIFY(upload->rolledBack && !upload->activated);
            // The cut that found no exchange is out of the way of the look at the table.
            bench.board->inject([](SimulatedFaults &faults) { faults.unplugAtExchange(1000000); });
            QCOMPARE(bench.inUse(), bench.oldImage);
            break;
        }
        QCOMPARE(upload.error().code, Errc::DeviceUnplugged);
        bench.board->plugIn();
        QVERIFY2(bench.oldOrNewWhole(), qPrintable(QString("cut at exchange %1").arg(cuts)));
        const bool isNew = bench.inUse() == bench.newImage;
        withNew += isNew;
        // No sentence says that the table stays, or is gone, where it is not so.
        const QString sentence = QString::fromStdString(upload.error().message);
        QVERIFY2(sentence.contains("did not pass the comparison") ||
                     (!isNew && sentence.contains("had not passed the comparison and was rolled back")),
                 qPrintable(sentence));
        BridgeClient again = connectTo(bench.board);
        if (isNew)
            QVERIFY(rollBackTable(again).ok());
        QCOMPARE(bench.inUse(), bench.oldImage);
    }
    qInfo("%d exchanges of the rollback, each cut once; after %d of the cuts the new table was in use", cuts,
          withNew);
    QVERIFY(cuts >= 3 && withNew > 0 && withNew < cuts);
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
        const auto upload = uploadTable(client, bench.newImage, quick());
        if (upload && bench.board->flashOperations() - operations <= cuts)
            break;
        if (!bench.board->pluggedIn())
            bench.board->plugIn();
        QVERIFY2(bench.oldOrNewWhole(), qPrintable(QString("cut at operation %1").arg(cuts)));
        BridgeClient again = connectTo(bench.board);
        QVERIFY(uploadTable(again, bench.newImage, quick()).ok());
        QCOMPARE(bench.inUse(), bench.newImage);
    }
    qInfo("%d flash operations, each cut once", cuts);
    QVERIFY(cuts > 20);
}

void TestDeviceUpload::uploadTable_otherBytesInTheBank_areFoundBeforeCommit()
{
    Bench bench = Bench::prepared();
    auto link = std::make_unique<FlippingTransport>(*SimulatedBridge::open(bench.board));
    BridgeClient client = *BridgeClient::open(std::move(link), bench.board->clock());
    const auto upload = uploadTable(client, bench.newImage, quick());
    QCOMPARE(upload.error().code, Errc::TableMismatch);
    QVERIFY(upload.error().message.find("Byte 65 ") != std::string::npos);
    const auto status = client.status();
    QCOMPARE(status->banks[1U - *status->activeBank].state, std::uint8_t(BRIDGE_BANK_EMPTY));
    QCOMPARE(bench.inUse(), bench.oldImage);
}

void TestDeviceUpload::rollBackTable_afterTwoUploads_bringsTheFirstBack()
{
    Bench bench = Bench::prepared();
    BridgeClient client = connectTo(bench.board);
    QVERIFY(uploadTable(client, bench.newImage, quick()).ok());
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
    const auto upload = uploadTable(client, bench.newImage, quick(false));
    QCOMPARE(readTable(client, upload->bank)->value(), bench.newImage);
    QCOMPARE(readTable(client, static_cast<std::uint8_t>(1 - upload->bank))->value(), bench.oldImage);
    QCOMPARE(readTable(client, std::uint8_t{2}).error().code, Errc::InvalidOption);
}

QTEST_APPLESS_MAIN(TestDeviceUpload)
#include "tst_device_upload.moc"
