// The bridge's client against the reference firmware in the simulated board: commands, results, repeats.
#include "engine/exports/device_image.h"
#include "support/firmware_device.h"
#include "support/simulated_device.h"

#include <QTest>

#include <functional>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceClient : public QObject
{
    Q_OBJECT

private slots:
    void open_simulatedBoard_readsInfo();
    void open_otherMajor_isProtocolVersion();
    void open_unplugged_saysSo();
    void configure_anyConfig_readsBack();
    void configure_outOfRange_isRefusedWithReason();
    void table_wholeUpload_isActiveAndReadsBack();
    void table_rollback_bringsPreviousBack();
    void table_otherSensor_isWrongSensor();
    void table_wrongCrc_isTableMismatch();
    void command_ignoredTwice_isRepeated();
    void command_ignoredAlways_isSilent();
    void command_refusedByResult_saysWhyAndKeepsTheNumber();
    void command_stalledRefusal_isReadFromStatus();
    void command_unplugged_isUnpluggedAtOnce();
    void readImage_cancelled_stops();
};

namespace {

Status upload(BridgeClient &client, const Bytes &image, std::uint16_t transaction)
{
    const auto size = static_cast<std::uint32_t>(image.size());
    if (const Status ok = client.beginTable(transaction, size, deviceImageCrc(image)); !ok)
        return ok;
    for (std::uint32_t at = 0; at < size; at += BRIDGE_CHUNK_BYTES) {
        const std::size_t length = std::min<std::size_t>(BRIDGE_CHUNK_BYTES, size - at);
        if (const Status ok = client.sendChunk(transaction, at, std::span(image).subspan(at, length)); !ok)
            return ok;
    }
    if (const Status ok = client.verifyTable(transaction); !ok)
        return ok;
    return client.commitTable(transaction);
}

std::uint32_t newestGeneration(BridgeClient &client)
{
    const auto status = client.status();
    return std::max(status->banks[0].generation, status->banks[1].generation);
}

} // namespace

void TestDeviceClient::open_simulatedBoard_readsInfo()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    const BridgeClient client = connectTo(board);
    QCOMPARE(client.info().sensor.text(), std::string("L3GD20H SIM-0001"));
    QCOMPARE(client.name(), std::string("native bridge SIM-0001"));
    QCOMPARE(client.identity().path, std::string("simulated:SIM-0001"));
    QCOMPARE(client.info().ranges.front().sensitivity, std::uint16_t(875));
    QCOMPARE(client.info().highestRateMilliHz, 10000000u);
}

void TestDeviceClient::open_otherMajor_isProtocolVersion()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    board->inject([](SimulatedFaults &faults) { faults.pretendMajor(3); });
    const auto client = BridgeClient::open(*SimulatedBridge::open(board), board->clock());
    QVERIFY(!client.ok());
    QCOMPARE(client.error().code, Errc::ProtocolVersion);
}

void TestDeviceClient::open_unplugged_saysSo()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    auto transport = *SimulatedBridge::open(board);
    board->unplug();
    QCOMPARE(BridgeClient::open(std::move(transport), board->clock()).error().code, Errc::DeviceUnplugged);
    QCOMPARE(SimulatedBridge::open(board).error().code, Errc::DeviceNotFound);
    board->plugIn();
    QVERIFY(SimulatedBridge::open(board).ok());
}

void TestDeviceClient::configure_anyConfig_readsBack()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    for (const BridgeConfig &config :
         {BridgeConfig{1000000, 2, false, false}, BridgeConfig{100000, 1, true, false},
          BridgeConfig{100000, 1, false, false}, BridgeConfig{1000, 0, false, false}}) {
        QVERIFY(client.configure(config).ok());
        QVERIFY(*client.config() == config);
    }
}

void TestDeviceClient::configure_outOfRange_isRefusedWithReason()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    const Status refused = client.configure({20000000, 0, false, false});
    QCOMPARE(refused.error().code, Errc::DeviceRefused);
    QCOMPARE(client.lastResult(), BRIDGE_RESULT_BAD_VALUE);
    QCOMPARE(client.configure({100000, 0, false, true}).error().code, Errc::DeviceRefused);
    QCOMPARE(client.lastResult(), BRIDGE_RESULT_NOTHING_THERE);
    QVERIFY(client.configure({100000, 0, true, false}).ok());
    QCOMPARE(client.configure({200000, 0, true, false}).error().code, Errc::DeviceRefused);
    QCOMPARE(client.lastResult(), BRIDGE_RESULT_BUSY);
}

void TestDeviceClient::table_wholeUpload_isActiveAndReadsBack()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    Random random(5);
    const Bytes image = randomImage(random, 40);
    QVERIFY(upload(client, image, 0x1234).ok());
    const auto committed = client.status();
    QVERIFY(!committed->activeBank);
    QVERIFY(client.activateTable(newestGeneration(client)).ok());
    const auto status = client.status();
    QVERIFY(status->activeBank.has_value());
    QCOMPARE(status->banks[*status->activeBank].crc, deviceImageCrc(image));
    const auto back = client.readImage(*status->activeBank, static_cast<std::uint32_t>(image.size()));
    QVERIFY(back.ok());
    QCOMPARE(*back, image);
    QCOMPARE(client.readImage(*status->activeBank, static_cast<std::uint32_t>(image.size() + 1)).error().code,
             Errc::TableMismatch);
    QVERIFY(client.readBank(1, 0, 56)->empty());
}

void TestDeviceClient::table_rollback_bringsPreviousBack()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    Random random(6);
    for (std::uint16_t transaction : {1, 2}) {
        QVERIFY(upload(client, randomImage(random, 4), transaction).ok());
        QVERIFY(client.activateTable(newestGeneration(client)).ok());
    }
    const auto before = client.status();
    QVERIFY(client.rollBackTable(before->banks[*before->activeBank].generation).ok());
    const auto after = client.status();
    QCOMPARE(*after->activeBank, static_cast<std::uint8_t>(1 - *before->activeBank));
    QCOMPARE(client.rollBackTable(99).error().code, Errc::DeviceRefused);
    QCOMPARE(client.lastResult(), BRIDGE_RESULT_NOTHING_THERE);
}

void TestDeviceClient::table_otherSensor_isWrongSensor()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    Random random(7);
    CompensationTable table = randomTable(random, 4);
    table.provenance.sensor.serial = "SIM-0002";
    const Status refused = upload(client, imageOf(table, DeviceTableKind::Float), 1);
    QCOMPARE(refused.error().code, Errc::WrongSensor);
    QCOMPARE(board->flashOperations(), 0);
}

void TestDeviceClient::table_wrongCrc_isTableMismatch()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    Random random(8);
    const Bytes image = randomImage(random, 2);
    QVERIFY(client.beginTable(1, static_cast<std::uint32_t>(image.size()), 42).ok());
    QVERIFY(client.sendChunk(1, 0, std::span(image).first(56)).ok());
    QVERIFY(client.sendChunk(1, 56, std::span(image).subspan(56)).ok());
    QCOMPARE(client.verifyTable(1).error().code, Errc::TableMismatch);
}

void TestDeviceClient::command_ignoredTwice_isRepeated()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    Random random(9);
    const Bytes image = randomImage(random, 12);
    const auto size = static_cast<std::uint32_t>(image.size());
    // The same command as the one before, so that only its effect tells that it was not heard.
    const auto deaf = [&](const std::function<Status()> &command) {
        board->inject([](SimulatedFaults &faults) { faults.ignoreSets(2); });
        return command().ok();
    };
    QVERIFY(deaf([&] { return client.configure({50000, 0, false, false}); }));
    QVERIFY(deaf([&] { return client.configure({60000, 0, false, false}); }));
    QVERIFY(client.config()->rateMilliHz == 60000u);
    QVERIFY(deaf([&] { return client.beginTable(1, size, deviceImageCrc(image)); }));
    for (std::uint32_t at = 0; at < size; at += 56) {
        const std::size_t length = std::min<std::size_t>(56, size - at);
        QVERIFY(deaf([&] { return client.sendChunk(1, at, std::span(image).subspan(at, length)); }));
    }
    QVERIFY(deaf([&] { return client.verifyTable(1); }));
    QVERIFY(deaf([&] { return client.commitTable(1); }));
    QVERIFY(deaf([&] { return client.activateTable(1); }));
    QCOMPARE(*client.readImage(0, size), image);
}

void TestDeviceClient::command_ignoredAlways_isSilent()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    board->inject([](SimulatedFaults &faults) { faults.ignoreSets(3); });
    QCOMPARE(client.verifyTable(1).error().code, Errc::DeviceSilent);
}

void TestDeviceClient::command_refusedByResult_saysWhyAndKeepsTheNumber()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    for (std::uint8_t result = 1; result <= 15; ++result) {
        board->inject([result](SimulatedFaults &faults) { faults.refuse(BRIDGE_REPORT_COMMIT, result); });
        const Status refused = client.commitTable(1);
        QVERIFY(!refused.ok());
        QCOMPARE(client.lastResult(), result);
        QVERIFY(refused.error().message.find(bridgeResultText(result)) != std::string::npos);
        QVERIFY(refused.error().message.starts_with("The bridge refused to commit the table: "));
    }
}

void TestDeviceClient::command_stalledRefusal_isReadFromStatus()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    board->inject([](SimulatedFaults &faults) { faults.stallRefusedSets(true); });
    QCOMPARE(client.commitTable(1).error().code, Errc::DeviceRefused);
    QCOMPARE(client.lastResult(), BRIDGE_RESULT_NO_UPLOAD);
}

void TestDeviceClient::command_unplugged_isUnpluggedAtOnce()
{
    for (std::int64_t exchange = 0; exchange < 4; ++exchange) {
        const auto board = *SimulatedBoard::create(quickBoard(10.0));
        BridgeClient client = connectTo(board);
        board->inject([exchange](SimulatedFaults &faults) { faults.unplugAtExchange(exchange); });
        const Status first = client.configure({50000, 0, false, false});
        const Status second = client.configure({60000, 0, false, false});
        QCOMPARE(first.ok(), exchange == 3);
        QCOMPARE(second.error().code, Errc::DeviceUnplugged);
    }
}

void TestDeviceClient::readImage_cancelled_stops()
{
    const auto board = *SimulatedBoard::create(quickBoard(10.0));
    BridgeClient client = connectTo(board);
    Random random(10);
    QVERIFY(upload(client, randomImage(random, 40), 1).ok());
    const auto hook = [](const Progress &progress) {
        return progress.fraction > 0.5 ? Flow::Stop : Flow::Continue;
    };
    QCOMPARE(client.readImage(0, 400, hook).error().code, Errc::Cancelled);
}

QTEST_APPLESS_MAIN(TestDeviceClient)
#include "tst_device_client.moc"
