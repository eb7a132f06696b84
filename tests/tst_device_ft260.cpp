// Reports of the FT260 against the bytes of its user guide, and its life cycle.
#include "device/i2c/ft260.h"
#include "support/bridges.h"
#include "support/ft260_model.h"
#include "support/memory_model.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;
using namespace driftbench::ft260;

class TestDeviceFt260 : public QObject
{
    Q_OBJECT

private slots:
    void requests_allKinds_haveTheBytesOfTheUserGuide();
    void status_everyBit_isUnderstood();
    void decoders_randomBytes_stayInside();
    void open_uartInterface_isRefused();
    void transfer_asleep_losesNothing();
};

void TestDeviceFt260::requests_allKinds_haveTheBytesOfTheUserGuide()
{
    const std::array<std::uint8_t, 2> bytes{0x20, 0x0F};
    QCOMPARE(resetRequest(), (Request{0xA1, 0x20}));
    QCOMPARE(speedRequest(400), (Request{0xA1, 0x22, 0x90, 0x01}));
    QCOMPARE(enableRequest(), (Request{0xA1, 0x02, 0x01}));
    QCOMPARE(writeRequest(0x6B, Start | Stop, bytes), (Request{0xD0, 0x6B, 6, 2, 0x20, 0x0F}));
    QCOMPARE(readRequest(0x6B, RepeatedStart | Stop, 180), (Request{0xC2, 0x6B, 7, 180, 0}));
    for (std::size_t length = 1; length <= kDataPerReport; ++length) {
        const Request request = writeRequest(0x10, Start, std::vector<std::uint8_t>(length));
        QCOMPARE(std::size_t(request[0]), 0xD0 + (length - 1) / 4);
        QCOMPARE(request.size(), length + 4);
    }
}

void TestDeviceFt260::status_everyBit_isUnderstood()
{
    const auto status = [](std::uint8_t bits) { return *decodeStatus(Report{0xC0, bits, 0x90, 0x01, 0}); };
    QVERIFY(status(0x01).controllerBusy && !status(0x20).controllerBusy);
    QVERIFY(status(0x06).failed && status(0x06).noAcknowledge);
    QVERIFY(status(0x0A).noAcknowledge && !status(0x12).noAcknowledge);
    QVERIFY(status(0x12).arbitrationLost);
    QVERIFY(status(0x60).busBusy);
    QCOMPARE(status(0x20).kHz, 400);
    QVERIFY(!decodeStatus(Report{0xC0, 0x20, 0x90}));
    QVERIFY(!decodeStatus(Report{0xC1, 0x20, 0x90, 0x01, 0}));
    QVERIFY(isFt260(Report{0xA0, 0x02, 0x60, 0x02}) && !isFt260(Report{0xA0, 0x02, 0x61, 0x02}));
    QVERIFY(decodeSettings(Report{0xA1, 0, 2, 0, 1, 1})->i2cWired);
    QVERIFY(decodeSettings(Report{0xA1, 3, 2, 0, 1, 1})->i2cWired);
    QVERIFY(!decodeSettings(Report{0xA1, 2, 2, 0, 1, 1})->i2cWired);
    QVERIFY(!decodeSettings(Report{0xA1, 1, 2, 0, 0, 1})->ready);
    QCOMPARE(decodeData(Report{0xD0, 2, 7, 8, 0, 0})->size(), std::size_t(2));
    QVERIFY(!decodeData(Report{0xD0, 5, 7, 8, 0, 0}));
}

void TestDeviceFt260::decoders_randomBytes_stayInside()
{
    Random random(23);
    int understood = 0;
    for (int round = 0; round < 200000; ++round) {
        Report report(random.below(66));
        for (std::uint8_t &byte : report)
            byte = static_cast<std::uint8_t>(random.bits());
        if (!report.empty() && random.below(2) == 0)
            report[0] = static_cast<std::uint8_t>(0xD0 + random.below(15));
        understood += decodeStatus(report).has_value() + decodeSettings(report).has_value() + isFt260(report);
        if (const auto data = decodeData(report)) {
            ++understood;
            QVERIFY(data->data() + data->size() <= report.data() + report.size());
        }
    }
    QVERIFY(understood > 1000);
}

void TestDeviceFt260::open_uartInterface_isRefused()
{
    Bridge bridge;
    const auto bus = Ft260::open(std::make_unique<Ft260Model>(bridge.clock, bridge.wires, 1), 400);
    QVERIFY(!bus.ok());
    QCOMPARE(bus.error().code, Errc::DeviceRefused);
    QVERIFY(bus.error().message.find("interface 0") != std::string::npos);
}

void TestDeviceFt260::transfer_asleep_losesNothing()
{
    Bridge bridge;
    MemoryModel memory;
    bridge.wires.attach(0x50, memory);
    auto chip = std::make_unique<Ft260Model>(bridge.clock, bridge.wires);
    const Ft260Model &model = *chip;
    const auto bus = Ft260::open(std::move(chip), 400);
    QVERIFY(bus.ok());
    bridge.clock.waitS(6.0);
    QVERIFY((*bus)->writeRegister(0x50, 3, 99).ok());
    QCOMPARE(int(memory.bytes[3]), 99);
    QCOMPARE(model.lostInSleep(), 0);
}

QTEST_APPLESS_MAIN(TestDeviceFt260)
#include "tst_device_ft260.moc"
