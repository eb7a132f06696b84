// Reports of the MCP2221A against the bytes of its data sheet, and what is particular to its life cycle.
#include "device/i2c/mcp2221a.h"
#include "support/bridges.h"
#include "support/memory_model.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;
using namespace driftbench::mcp2221a;

class TestDeviceMcp2221a : public QObject
{
    Q_OBJECT

private slots:
    void requests_allKinds_haveTheBytesOfTheDataSheet();
    void status_everyEngineState_isUnderstood();
    void data_replies_areUnderstood();
    void decoders_randomBytes_stayInside();
    void open_afterAnotherProgramStopped_startsClean();
    void open_lineLow_namesTheLine();
};

namespace {

std::vector<int> firstBytes(const Request &request, std::size_t count)
{
    return {request.begin(), request.begin() + static_cast<std::ptrdiff_t>(count)};
}

Report reply(std::uint8_t command)
{
    Report report(64);
    report[0] = command;
    return report;
}

} // namespace

void TestDeviceMcp2221a::requests_allKinds_haveTheBytesOfTheDataSheet()
{
    using Bytes = std::vector<int>;
    QCOMPARE(statusRequest().size(), std::size_t(65));
    QCOMPARE(firstBytes(statusRequest(), 6), (Bytes{0, 0x10, 0, 0, 0, 0}));
    QCOMPARE(firstBytes(cancelRequest(), 6), (Bytes{0, 0x10, 0, 0x10, 0, 0}));
    QCOMPARE(firstBytes(speedRequest(400), 6), (Bytes{0, 0x10, 0, 0, 0x20, 27}));
    QCOMPARE(firstBytes(speedRequest(100), 6), (Bytes{0, 0x10, 0, 0, 0x20, 117}));
    QCOMPARE(firstBytes(getDataRequest(), 3), (Bytes{0, 0x40, 0}));
    const std::array<std::uint8_t, 2> bytes{0x20, 0x0F};
    QCOMPARE(firstBytes(writeRequest(Command::Write, 0x6B, bytes), 8),
             (Bytes{0, 0x90, 2, 0, 0xD6, 0x20, 0x0F, 0}));
    QCOMPARE(firstBytes(writeRequest(Command::WriteWithoutStop, 0x68, bytes), 8),
             (Bytes{0, 0x94, 2, 0, 0xD0, 0x20, 0x0F, 0}));
    QCOMPARE(firstBytes(readRequest(Command::Read, 0x6B, 0x0123), 5), (Bytes{0, 0x91, 0x23, 0x01, 0xD6}));
    QCOMPARE(firstBytes(readRequest(Command::ReadAfterRepeatedStart, 0x6B, 192), 5),
             (Bytes{0, 0x93, 192, 0, 0xD6}));
}

void TestDeviceMcp2221a::status_everyEngineState_isUnderstood()
{
    Report report = reply(0x10);
    report[22] = 1;
    const auto engine = [&](std::uint8_t state) {
        report[8] = state;
        return decodeStatus(report)->engine;
    };
    QCOMPARE(engine(0x00), Engine::Idle);
    QCOMPARE(engine(0x25), Engine::NoAcknowledge);
    QCOMPARE(engine(0x45), Engine::Waiting);
    QCOMPARE(engine(0x55), Engine::Waiting);
    for (const std::uint8_t timedOut : {0x12, 0x23, 0x44, 0x52, 0x62})
        QCOMPARE(engine(timedOut), Engine::TimedOut);
    for (const std::uint8_t working : {0x10, 0x21, 0x41, 0x50, 0x60})
        QCOMPARE(engine(working), Engine::Working);
    QVERIFY(decodeStatus(report)->sclHigh && !decodeStatus(report)->sdaHigh);
    QVERIFY(!decodeStatus(report)->speedSet);
    report[3] = 0x20;
    QVERIFY(decodeStatus(report)->speedSet);
    report[20] = 0x40;
    QCOMPARE(decodeStatus(report)->engine, Engine::NoAcknowledge);
    report[1] = 0x01;
    QVERIFY(!decodeStatus(report));
}

void TestDeviceMcp2221a::data_replies_areUnderstood()
{
    Report report = reply(0x40);
    report[2] = 0x54;
    report[3] = 3;
    report[4] = 10;
    report[6] = 12;
    QCOMPARE(decodeData(report)->state, DataReply::State::Partial);
    QCOMPARE(decodeData(report)->bytes.size(), std::size_t(3));
    QCOMPARE(int(decodeData(report)->bytes[2]), 12);
    report[2] = 0x55;
    QCOMPARE(decodeData(report)->state, DataReply::State::Complete);
    report[3] = 127;
    QCOMPARE(decodeData(report)->state, DataReply::State::Failed);
    report[3] = 61;
    QVERIFY(!decodeData(report));
    report[1] = 0x41;
    QCOMPARE(decodeData(report)->state, DataReply::State::NotReady);
    report.resize(3);
    QVERIFY(!decodeData(report));
    QVERIFY(!decodeAccepted(reply(0x94), Command::Write));
    QCOMPARE(decodeAccepted(reply(0x90), Command::Write), std::optional(true));
}

void TestDeviceMcp2221a::decoders_randomBytes_stayInside()
{
    Random random(21);
    int understood = 0;
    for (int round = 0; round < 200000; ++round) {
        Report report(random.below(66));
        for (std::uint8_t &byte : report)
            byte = static_cast<std::uint8_t>(random.bits());
        if (!report.empty() && random.below(2) == 0)
            report[0] = random.below(2) == 0 ? 0x40 : 0x10;
        if (report.size() > 1 && random.below(2) == 0)
            report[1] = 0;
        understood += decodeStatus(report).has_value();
        understood += decodeAccepted(report, Command::Read).has_value();
        if (const std::optional<DataReply> data = decodeData(report)) {
            ++understood;
            QVERIFY(data->bytes.size() <= kDataPerReport);
            QVERIFY(data->bytes.empty() ||
                    data->bytes.data() + data->bytes.size() <= report.data() + report.size());
        }
    }
    QVERIFY(understood > 1000);
}

void TestDeviceMcp2221a::open_afterAnotherProgramStopped_startsClean()
{
    Bridge bridge;
    MemoryModel memory;
    memory.bytes[5] = 42;
    bridge.wires.attach(0x50, memory);
    std::unique_ptr<HidTransport> chip = makeChip("MCP2221A", bridge);
    // The other one left a read unfetched and its last answers unread.
    const std::array<std::uint8_t, 1> reg{0};
    QVERIFY(chip->write(writeRequest(Command::WriteWithoutStop, 0x50, reg)).ok());
    QVERIFY(chip->write(readRequest(Command::ReadAfterRepeatedStart, 0x50, 100)).ok());
    const auto bus = Mcp2221a::open(std::move(chip), 400);
    QVERIFY(bus.ok());
    QCOMPARE(*(*bus)->readRegister(0x50, 5), std::uint8_t(42));
}

void TestDeviceMcp2221a::open_lineLow_namesTheLine()
{
    Bridge bridge;
    bridge.wires.holdLow(1000);
    const auto bus = Mcp2221a::open(makeChip("MCP2221A", bridge), 400);
    QVERIFY(!bus.ok());
    QCOMPARE(bus.error().code, Errc::BusStuck);
    QVERIFY(bus.error().message.find("SDA") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestDeviceMcp2221a)
#include "tst_device_mcp2221a.moc"
