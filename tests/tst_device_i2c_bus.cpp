// What holds for every I2C bus, whichever USB bridge is below it: run on the drivers of all three, on models
// of the chips.
#include "support/bridges.h"
#include "support/memory_model.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceI2cBus : public QObject
{
    Q_OBJECT

private slots:
    void registers_writtenThenRead_areEqual_data() { bridges(); }
    void registers_writtenThenRead_areEqual();
    void reads_anyLengthInAnyPieces_giveTheBytes_data() { bridges(); }
    void reads_anyLengthInAnyPieces_giveTheBytes();
    void transfers_allKinds_happenOnce_data() { bridges(); }
    void transfers_allKinds_happenOnce();
    void address_nobodyAnswers_isNamedAndBusGoesOn_data() { bridges(); }
    void address_nobodyAnswers_isNamedAndBusGoesOn();
    void data_notAcknowledged_isAnError_data() { bridges(); }
    void data_notAcknowledged_isAnError();
    void bus_heldLow_isStuckAndRecovers_data() { bridges(); }
    void bus_heldLow_isStuckAndRecovers();
    void bridge_unpluggedAtAnyReport_saysSo_data() { bridges(); }
    void bridge_unpluggedAtAnyReport_saysSo();
    void bridge_silent_endsInTime_data() { bridges(); }
    void bridge_silent_endsInTime();
    void reports_lateOnes_areDropped_data() { bridges(); }
    void reports_lateOnes_areDropped();
    void requests_outsideLimits_sendNothing_data() { bridges(); }
    void requests_outsideLimits_sendNothing();
    void speeds_outsideLimits_areRefused_data() { bridges(); }
    void speeds_outsideLimits_areRefused();
    void answers_randomBytes_neverHarm_data() { bridges(); }
    void answers_randomBytes_neverHarm();
    void bridge_idleForLong_wakes_data() { bridges(); }
    void bridge_idleForLong_wakes();

private:
    static void bridges();
};

namespace {

constexpr std::uint8_t kAddress = 0x50;

void fill(MemoryModel &memory)
{
    for (std::size_t i = 0; i < memory.bytes.size(); ++i)
        memory.bytes[i] = static_cast<std::uint8_t>(7 * i + 3);
}

struct Fixture
{
    explicit Fixture(const QString &name, int kHz = 400) : bridge(makeBridge(name.toStdString(), kHz))
    {
        Q_ASSERT(bridge);
        fill(memory);
        bridge->wires.attach(kAddress, memory);
    }

    I2cBus &bus() { return *bridge->bus; }
    bool works() // a register goes there and back
    {
        const auto value = static_cast<std::uint8_t>(memory.bytes[9] + 1);
        if (!bus().writeRegister(kAddress, 9, value))
            return false;
        const Result<std::uint8_t> back = bus().readRegister(kAddress, 9);
        return back && *back == value;
    }

    MemoryModel memory;
    std::unique_ptr<Bridge> bridge;
};

} // namespace

void TestDeviceI2cBus::bridges()
{
    QTest::addColumn<QString>("name");
    for (const char *name : kBridgeNames)
        QTest::newRow(name) << QString(name);
}

void TestDeviceI2cBus::registers_writtenThenRead_areEqual()
{
    QFETCH(QString, name);
    Fixture fixture(name);
    Random random(11);
    for (int round = 0; round < 200; ++round) {
        const auto reg = static_cast<std::uint8_t>(random.bits());
        const auto value = static_cast<std::uint8_t>(random.bits());
        QVERIFY(fixture.bus().writeRegister(kAddress, reg, value).ok());
        QCOMPARE(fixture.memory.bytes[reg], value);
        const Result<std::uint8_t> back = fixture.bus().readRegister(kAddress, reg);
        QVERIFY(back.ok());
        QCOMPARE(*back, value);
    }
}

void TestDeviceI2cBus::reads_anyLengthInAnyPieces_giveTheBytes()
{
    QFETCH(QString, name);
    for (const int kHz : {100, 400}) {
        Fixture fixture(name, kHz);
        Random random(12);
        const std::size_t longest = std::min<std::size_t>(fixture.bus().limits().longestRead, 250);
        for (std::size_t length = 1; length <= longest; ++length) {
            if (length % 3 == 0)
                fixture.bridge->chip->splitData(length);
            const auto reg = static_cast<std::uint8_t>(random.bits());
            std::vector<std::uint8_t> bytes(length);
            const Status read = fixture.bus().writeThenRead(kAddress, std::array{reg}, bytes);
            QVERIFY2(read.ok(), read.ok() ? "" : read.error().message.c_str());
            for (std::size_t i = 0; i < length; ++i)
                QCOMPARE(bytes[i], fixture.memory.bytes[(reg + i) % 256]);
            // Without an address before it the read goes on from there.
            QVERIFY(fixture.bus().read(kAddress, bytes).ok());
            for (std::size_t i = 0; i < length; ++i)
                QCOMPARE(bytes[i], fixture.memory.bytes[(reg + length + i) % 256]);
        }
    }
}

void TestDeviceI2cBus::transfers_allKinds_happenOnce()
{
    QFETCH(QString, name);
    Fixture fixture(name);
    I2cBusModel &wires = fixture.bridge->wires;
    std::array<std::uint8_t, 100> bytes{};
    int before = wires.transfers();
    QVERIFY(fixture.bus().write(kAddress, std::array<std::uint8_t, 3>{1, 2, 3}).ok());
    QCOMPARE(wires.transfers() - before, 1);
    before = wires.transfers();
    QVERIFY(fixture.bus().read(kAddress, bytes).ok());
    QCOMPARE(wires.transfers() - before, 1);
    before = wires.transfers();
    QVERIFY(fixture.bus().writeThenRead(kAddress, std::array<std::uint8_t, 1>{5}, bytes).ok());
    QCOMPARE(wires.transfers() - before, 2);
    before = wires.transfers();
    QVERIFY(!fixture.bus().write(0x6B, std::array<std::uint8_t, 1>{5}).ok());
    QCOMPARE(wires.transfers() - before, 1);
}

void TestDeviceI2cBus::address_nobodyAnswers_isNamedAndBusGoesOn()
{
    QFETCH(QString, name);
    Fixture fixture(name);
    std::array<std::uint8_t, 8> bytes{};
    const std::array<std::uint8_t, 1> reg{0x0F};
    const std::array<Status, 3> failures{fixture.bus().write(0x6B, reg), fixture.bus().read(0x6B, bytes),
                                         fixture.bus().writeThenRead(0x6B, reg, bytes)};
    for (const Status &failure : failures) {
        QVERIFY(!failure.ok());
        QCOMPARE(failure.error().code, Errc::BusNoAcknowledge);
        QVERIFY2(failure.error().message.find("0x6b") != std::string::npos, failure.error().message.c_str());
        QVERIFY(failure.error().message.find(name.toStdString()) != std::string::npos);
        QVERIFY(fixture.works());
    }
    // Acknowledged when written to, and not when read.
    for (int starts = 0; starts < 4; ++starts) {
        QVERIFY(fixture.works());
        fixture.bridge->wires.refuseNext(1);
        QCOMPARE(fixture.bus().read(kAddress, bytes).error().code, Errc::BusNoAcknowledge);
    }
    QVERIFY(fixture.works());
}

void TestDeviceI2cBus::data_notAcknowledged_isAnError()
{
    QFETCH(QString, name);
    Fixture fixture(name);
    fixture.bridge->wires.refuseData(true);
    const Status failure = fixture.bus().writeRegister(kAddress, 1, 2);
    QVERIFY(!failure.ok());
    QCOMPARE(failure.error().code, Errc::BusNoAcknowledge);
    fixture.bridge->wires.refuseData(false);
    QVERIFY(fixture.works());
}

void TestDeviceI2cBus::bus_heldLow_isStuckAndRecovers()
{
    QFETCH(QString, name);
    std::array<std::uint8_t, 8> bytes{};
    for (const int recoveries : {1, 2, 3}) {
        Fixture fixture(name);
        fixture.bridge->wires.holdLow(recoveries);
        int failures = 0;
        for (; failures < 4 && fixture.bridge->wires.heldLow(); ++failures) {
            const Status failure =
                fixture.bus().writeThenRead(kAddress, std::array<std::uint8_t, 1>{5}, bytes);
            QVERIFY(!failure.ok());
            QCOMPARE(failure.error().code, Errc::BusStuck);
            QVERIFY(failure.error().message.find("0x50") != std::string::npos);
        }
        QVERIFY2(failures >= 1 && failures <= recoveries, "the driver does not free the bus");
        QVERIFY(fixture.works());
    }
    Fixture fixture(name);
    fixture.bridge->wires.holdLow(1000000);
    const double beganS = fixture.bridge->clock.nowS();
    QCOMPARE(fixture.bus().read(kAddress, bytes).error().code, Errc::BusStuck);
    QVERIFY(fixture.bridge->clock.nowS() - beganS < 2.0);
}

void TestDeviceI2cBus::bridge_unpluggedAtAnyReport_saysSo()
{
    QFETCH(QString, name);
    std::vector<std::uint8_t> bytes(150);
    int cut = 0;
    for (bool whole = false; !whole; ++cut) {
        QVERIFY(cut < 100);
        Fixture fixture(name);
        fixture.bridge->chip->unplugAfter(cut);
        const Status read = fixture.bus().writeThenRead(kAddress, std::array<std::uint8_t, 1>{5}, bytes);
        whole = read.ok();
        if (!whole)
            QCOMPARE(read.error().code, Errc::DeviceUnplugged);
    }
    QVERIFY(cut > 5);
    for (cut = 0;; ++cut) {
        Bridge bridge;
        std::unique_ptr<HidTransport> chip = makeChip(name.toStdString(), bridge);
        bridge.chip->unplugAfter(cut);
        const Result<std::unique_ptr<I2cBus>> bus = openBus(name.toStdString(), std::move(chip), 100);
        if (bus.ok())
            break;
        QCOMPARE(bus.error().code, Errc::DeviceUnplugged);
    }
    QVERIFY(cut >= 2);
}

void TestDeviceI2cBus::bridge_silent_endsInTime()
{
    QFETCH(QString, name);
    Fixture fixture(name);
    std::array<std::uint8_t, 8> bytes{};
    const double beganS = fixture.bridge->clock.nowS();
    fixture.bridge->chip->goSilent(true);
    const Status failure = fixture.bus().read(kAddress, bytes);
    QVERIFY(!failure.ok());
    // The FT260 still tells its status, which is another kind of report.
    QCOMPARE(failure.error().code, name == "FT260" ? Errc::BusStuck : Errc::DeviceSilent);
    QVERIFY(fixture.bridge->clock.nowS() - beganS < 2.0);
    fixture.bridge->chip->goSilent(false);
    QVERIFY(fixture.works());
}

void TestDeviceI2cBus::reports_lateOnes_areDropped()
{
    QFETCH(QString, name);
    Fixture fixture(name);
    for (const std::uint8_t id : {0x01, 0x7F, 0xE0, 0xFF}) {
        Report late(64, 0xA5);
        late[0] = id;
        fixture.bridge->chip->inject(late);
        QVERIFY(fixture.works());
    }
}

void TestDeviceI2cBus::requests_outsideLimits_sendNothing()
{
    QFETCH(QString, name);
    Fixture fixture(name);
    const I2cLimits limits = fixture.bus().limits();
    const int before = fixture.bridge->chip->reports();
    std::vector<std::uint8_t> tooLong(limits.longestRead + 1);
    std::vector<std::uint8_t> nothing;
    const std::vector<std::uint8_t> tooMuch(limits.longestWrite + 1);
    const std::vector<std::uint8_t> tooMuchBefore(limits.longestWriteThenRead + 1);
    std::array<std::uint8_t, 1> one{};
    const std::array<Status, 7> refusals{
        fixture.bus().read(kAddress, tooLong),
        fixture.bus().read(kAddress, nothing),
        fixture.bus().write(kAddress, tooMuch),
        fixture.bus().write(kAddress, nothing),
        fixture.bus().writeThenRead(kAddress, tooMuchBefore, one),
        fixture.bus().read(0x07, one),
        fixture.bus().read(0x78, one),
    };
    for (const Status &refusal : refusals) {
        QVERIFY(!refusal.ok());
        QCOMPARE(refusal.error().code, Errc::InvalidOption);
    }
    QCOMPARE(fixture.bridge->chip->reports(), before);
    // And the limits themselves are kept.
    std::vector<std::uint8_t> longest(limits.longestRead);
    QVERIFY(fixture.bus().read(kAddress, longest).ok());
    QVERIFY(fixture.bus().write(kAddress, std::vector<std::uint8_t>(limits.longestWrite)).ok());
    QVERIFY(fixture.bus()
                .writeThenRead(kAddress, std::vector<std::uint8_t>(limits.longestWriteThenRead), longest)
                .ok());
}

void TestDeviceI2cBus::speeds_outsideLimits_areRefused()
{
    QFETCH(QString, name);
    const I2cLimits limits = makeBridge(name.toStdString())->bus->limits();
    for (const int kHz : {0, -1, limits.slowestKHz - 1, limits.fastestKHz + 1}) {
        Bridge bridge;
        const auto bus = openBus(name.toStdString(), makeChip(name.toStdString(), bridge), kHz);
        QVERIFY(!bus.ok());
        QCOMPARE(bus.error().code, Errc::InvalidOption);
    }
    for (const int kHz : {limits.slowestKHz, 100, 400, limits.fastestKHz}) {
        Fixture fixture(name, kHz);
        QVERIFY(std::abs(fixture.bridge->wires.kHz() / kHz - 1.0) < 0.02);
        QVERIFY(fixture.works());
    }
}

void TestDeviceI2cBus::answers_randomBytes_neverHarm()
{
    QFETCH(QString, name);
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        Fixture fixture(name);
        fixture.bridge->chip->answerWithRandomBytes(seed);
        const double beganS = fixture.bridge->clock.nowS();
        std::vector<std::uint8_t> bytes(1 + seed % fixture.bus().limits().longestRead);
        // Either outcome is right; what counts is that it ends, and inside the buffer (sanitizers).
        const Status read = fixture.bus().writeThenRead(kAddress, std::array<std::uint8_t, 1>{5}, bytes);
        const Status written = fixture.bus().writeRegister(kAddress, 1, 2);
        QVERIFY(read.ok() || !read.error().message.empty());
        QVERIFY(written.ok() || !written.error().message.empty());
        QVERIFY2(fixture.bridge->clock.nowS() - beganS < 20.0, qPrintable(QString("seed %1").arg(seed)));
    }
}

void TestDeviceI2cBus::bridge_idleForLong_wakes()
{
    QFETCH(QString, name);
    Fixture fixture(name);
    for (int round = 0; round < 3; ++round) {
        fixture.bridge->clock.waitS(7.0);
        QVERIFY(fixture.works());
    }
}

QTEST_APPLESS_MAIN(TestDeviceI2cBus)
#include "tst_device_i2c_bus.moc"
