// Reports of the CP2112 against the bytes of its interface specification, and its life cycle.
#include "device/i2c/cp2112.h"
#include "support/bridges.h"
#include "support/memory_model.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;
using namespace driftbench::cp2112;

class TestDeviceCp2112 : public QObject
{
    Q_OBJECT

private slots:
    void requests_allKinds_haveTheBytesOfTheSpecification();
    void config_always_endsByItself();
    void status_everyState_isUnderstood();
    void decoders_randomBytes_stayInside();
    void open_afterAnotherProgramStopped_startsClean();
};

void TestDeviceCp2112::requests_allKinds_haveTheBytesOfTheSpecification()
{
    const std::array<std::uint8_t, 2> bytes{0x20, 0x0F};
    QCOMPARE(readRequest(0x6B, 0x0102), (Request{0x10, 0xD6, 0x01, 0x02}));
    QCOMPARE(writeReadRequest(0x6B, bytes, 192), (Request{0x11, 0xD6, 0x00, 192, 2, 0x20, 0x0F}));
    QCOMPARE(writeRequest(0x68, bytes), (Request{0x14, 0xD0, 2, 0x20, 0x0F}));
    QCOMPARE(fetchRequest(61), (Request{0x12, 0, 61}));
    QCOMPARE(statusRequest(), (Request{0x15, 0x01}));
    QCOMPARE(cancelRequest(), (Request{0x17, 0x01}));
}

void TestDeviceCp2112::config_always_endsByItself()
{
    const Request config = configRequest(400);
    QCOMPARE(config.size(), std::size_t(14));
    QCOMPARE(Request(config.begin(), config.begin() + 5), (Request{0x06, 0x00, 0x06, 0x1A, 0x80})); // 400000
    QCOMPARE(int(config[6]), 0);                 // no data unasked
    QVERIFY((config[7] << 8 | config[8]) > 0);   // write timeout
    QVERIFY((config[9] << 8 | config[10]) > 0);  // read timeout
    QCOMPARE(int(config[11]), 1);                // SCL low timeout
    QVERIFY((config[12] << 8 | config[13]) > 0); // retries that end
}

void TestDeviceCp2112::status_everyState_isUnderstood()
{
    const auto progress = [](std::uint8_t state, std::uint8_t condition) {
        return decodeStatus(Report{0x16, state, condition, 0, 1, 0x01, 0x02})->progress;
    };
    QCOMPARE(progress(0, 0), Progress::Idle);
    QCOMPARE(progress(1, 2), Progress::Busy);
    QCOMPARE(progress(2, 5), Progress::Complete);
    QCOMPARE(progress(3, 0), Progress::NoAcknowledge);
    QCOMPARE(progress(3, 1), Progress::BusNotFree);
    QCOMPARE(progress(3, 2), Progress::BusNotFree);
    QCOMPARE(progress(3, 4), Progress::NoAcknowledge);
    QCOMPARE(progress(3, 9), Progress::Failed);
    QCOMPARE(int(decodeStatus(Report{0x16, 2, 5, 0, 1, 0x01, 0x02})->bytes), 0x0102);
    QVERIFY(!decodeStatus(Report{0x16, 4, 0, 0, 0, 0, 0}));
    QVERIFY(!decodeStatus(Report{0x16, 2, 5, 0, 1, 0x01}));
    QVERIFY(!decodeStatus(Report{0x13, 2, 5, 0, 1, 0x01, 0x02}));
    QVERIFY(!decodeData(Report{0x13, 2, 3, 1, 2}));
    QCOMPARE(decodeData(Report{0x13, 2, 2, 1, 2})->size(), std::size_t(2));
}

void TestDeviceCp2112::decoders_randomBytes_stayInside()
{
    Random random(22);
    int understood = 0;
    for (int round = 0; round < 200000; ++round) {
        Report report(random.below(66));
        for (std::uint8_t &byte : report)
            byte = static_cast<std::uint8_t>(random.bits());
        if (!report.empty())
            report[0] = random.below(2) == 0 ? kReadResponse : kStatusResponse;
        understood += decodeStatus(report).has_value();
        if (const auto data = decodeData(report)) {
            ++understood;
            QVERIFY(data->size() <= kDataPerReport);
            QVERIFY(data->data() + data->size() <= report.data() + report.size());
        }
    }
    QVERIFY(understood > 1000);
}

void TestDeviceCp2112::open_afterAnotherProgramStopped_startsClean()
{
    Bridge bridge;
    MemoryModel memory;
    memory.bytes[5] = 42;
    bridge.wires.attach(0x50, memory);
    std::unique_ptr<HidTransport> chip = makeChip("CP2112", bridge);
    // The other one left data unfetched, and answers unread.
    QVERIFY(chip->write(readRequest(0x50, 100)).ok());
    QVERIFY(chip->write(statusRequest()).ok());
    QVERIFY(chip->write(fetchRequest(61)).ok());
    const auto bus = Cp2112::open(std::move(chip), 400);
    QVERIFY(bus.ok());
    QCOMPARE(*(*bus)->readRegister(0x50, 5), std::uint8_t(42));
}

QTEST_APPLESS_MAIN(TestDeviceCp2112)
#include "tst_device_cp2112.moc"
