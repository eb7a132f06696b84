// ST's gyros: registers against the data sheets' tables, set-up and identity against register-level models.
#include "device/gyros/st_gyro.h"
#include "support/bridges.h"
#include "support/gyro_model.h"
#include "support/memory_model.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::st_gyro;
using driftbench::test::Bridge;
using driftbench::test::GyroModel;
using driftbench::test::makeBridge;
using driftbench::test::MemoryModel;

class TestDeviceStGyro : public QObject
{
    Q_OBJECT

private slots:
    void descriptions_everyModel_haveTheDataSheetsNumbers();
    void settings_anyWish_areTheSmallestThatHolds();
    void fifoState_everyByte_isUnderstood();
    void counts_extremes_keepTheirSign();
    void setUp_everyModelRangeAndRate_reachesTheRegisters_data();
    void setUp_everyModelRangeAndRate_reachesTheRegisters();
    void open_anotherSensor_isNamed();
    void find_eitherAddress_isFound();
    void find_nothingThere_namesTheAddresses();
    void setUp_beyondTheGyro_isRefused();
    void fifo_readInBursts_givesEachSampleOnce();
};

namespace {

// Acknowledges everything, keeps nothing, and reads 0xD7 everywhere.
class StuckModel final : public driftbench::test::I2cDeviceModel
{
public:
    void start(bool) override {}
    bool write(std::uint8_t) override { return true; }
    std::uint8_t read() override { return 0xD7; }
};

} // namespace

void TestDeviceStGyro::descriptions_everyModel_haveTheDataSheetsNumbers()
{
    const Description *l3gd20h = descriptionOf("L3GD20H");
    const Description *i3g4250d = descriptionOf("I3G4250D");
    QVERIFY(l3gd20h && i3g4250d && descriptionOf("L3GD20") == nullptr);
    QCOMPARE(int(l3gd20h->whoAmI), 0xD7);
    QCOMPARE(int(i3g4250d->whoAmI), 0xD3);
    QCOMPARE(l3gd20h->addresses, (std::array<std::uint8_t, 2>{0x6A, 0x6B}));
    QCOMPARE(i3g4250d->addresses, (std::array<std::uint8_t, 2>{0x68, 0x69}));
    QVERIFY(l3gd20h->blockDataUpdate && !i3g4250d->blockDataUpdate);
    for (const Description *description : {l3gd20h, i3g4250d}) {
        QCOMPARE(rangeFor(*description, 245.0)->sensitivityDps, 0.00875);
        QCOMPARE(rangeFor(*description, 500.0)->sensitivityDps, 0.0175);
        QCOMPARE(rangeFor(*description, 2000.0)->sensitivityDps, 0.07);
    }
}

void TestDeviceStGyro::settings_anyWish_areTheSmallestThatHolds()
{
    const Description &l3gd20h = *descriptionOf("L3GD20H");
    QCOMPARE(rangeFor(l3gd20h, 1.0)->rangeDps, 245.0);
    QCOMPARE(rangeFor(l3gd20h, 245.1)->rangeDps, 500.0);
    QVERIFY(!rangeFor(l3gd20h, 2000.1));
    QCOMPARE(rateFor(l3gd20h, 1.0)->rateHz, 12.5);
    QCOMPARE(rateFor(l3gd20h, 60.0)->rateHz, 100.0);
    QCOMPARE(rateFor(*descriptionOf("I3G4250D"), 1.0)->rateHz, 100.0);
    QVERIFY(!rateFor(l3gd20h, 801.0));
}

void TestDeviceStGyro::fifoState_everyByte_isUnderstood()
{
    for (int byte = 0; byte < 256; ++byte) {
        const FifoState state = decodeFifoState(static_cast<std::uint8_t>(byte));
        const bool full = (byte & 0x40) != 0;
        const bool empty = (byte & 0x20) != 0;
        QCOMPARE(state.full, full);
        QCOMPARE(state.samples, full ? 32 : empty ? 0 : byte & 31);
    }
}

void TestDeviceStGyro::counts_extremes_keepTheirSign()
{
    const std::array<std::uint8_t, 12> bytes{0, 0, 0, 0, 0, 0, 0x00, 0x80, 0xFF, 0x7F, 0xFE, 0xFF};
    const Counts counts = decodeCounts(bytes, 1);
    QCOMPARE(counts, (Counts{-32768, 32767, -2}));
    QVERIFY(saturated(counts) && !saturated({1, 2, -32767}));
    QCOMPARE(decodeDieCount(0xFF), -1);
    QCOMPARE(decodeDieCount(0x14), 20);
}

void TestDeviceStGyro::setUp_everyModelRangeAndRate_reachesTheRegisters_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<double>("rangeDps");
    QTest::addColumn<double>("rateHz");
    for (const Description &description : descriptions()) {
        for (const RangeSetting &range : description.ranges) {
            for (const RateSetting &rate : description.rates) {
                const QString model = QString::fromUtf8(description.model.data());
                QTest::addRow("%s %g dps %g Hz", qPrintable(model), range.rangeDps, rate.rateHz)
                    << model << range.rangeDps << rate.rateHz;
            }
        }
    }
}

void TestDeviceStGyro::setUp_everyModelRangeAndRate_reachesTheRegisters()
{
    QFETCH(QString, model);
    QFETCH(double, rangeDps);
    QFETCH(double, rateHz);
    const auto bridge = makeBridge("CP2112");
    GyroModel part(model.toStdString(), bridge->clock);
    const Description &description = *descriptionOf(model.toStdString());
    bridge->wires.attach(description.addresses[1], part);
    Result<StGyro> gyro = StGyro::open(*bridge->bus, description, description.addresses[1]);
    QVERIFY(gyro.ok());
    // Whoever used it before had the high-pass filter on.
    QVERIFY(bridge->bus->writeRegister(gyro->address(), Ctrl5, kHighPassEnable).ok());
    const Status ok = gyro->setUp({rangeDps, rateHz});
    QVERIFY2(ok.ok(), ok.ok() ? "" : ok.error().message.c_str());
    QCOMPARE(part.trueRateHz(), rateHz);
    QCOMPARE(gyro->nominalRateHz(), rateHz);
    QCOMPARE(gyro->rangeDps(), rangeDps);
    QCOMPARE(part.reg(0x23) & 0x30, rangeDps == 245.0 ? 0x00 : rangeDps == 500.0 ? 0x10 : 0x20);
    QCOMPARE((part.reg(0x23) & 0x80) != 0, model == "L3GD20H");
    QCOMPARE(part.reg(0x24) & 0x50, 0x40); // FIFO on, high-pass filter off
    QCOMPARE(part.reg(0x20) & 0x0F, 0x0F); // measuring on all axes
    QCOMPARE(part.reg(0x2E) >> 5, 2);      // stream mode
    QVERIFY(!part.reservedWritten());
}

void TestDeviceStGyro::open_anotherSensor_isNamed()
{
    const auto bridge = makeBridge("CP2112");
    GyroModel part("I3G4250D", bridge->clock);
    bridge->wires.attach(0x6B, part);
    const Result<StGyro> gyro = StGyro::open(*bridge->bus, *descriptionOf("L3GD20H"), 0x6B);
    QVERIFY(!gyro.ok());
    QCOMPARE(gyro.error().code, Errc::WrongSensor);
    for (const char *named : {"0x6b", "0xd3", "I3G4250D", "L3GD20H", "0xd7"})
        QVERIFY2(gyro.error().message.find(named) != std::string::npos, gyro.error().message.c_str());
    MemoryModel unknown;
    unknown.bytes[0x0F] = 0x33;
    bridge->wires.attach(0x6B, unknown);
    const Result<StGyro> other = StGyro::find(*bridge->bus);
    QCOMPARE(other.error().code, Errc::WrongSensor);
    QVERIFY(other.error().message.find("unknown device") != std::string::npos);
}

void TestDeviceStGyro::find_eitherAddress_isFound()
{
    for (const Description &description : descriptions()) {
        for (const std::uint8_t address : description.addresses) {
            const auto bridge = makeBridge("MCP2221A");
            GyroModel part(std::string(description.model), bridge->clock);
            bridge->wires.attach(address, part);
            const Result<StGyro> gyro = StGyro::find(*bridge->bus);
            QVERIFY(gyro.ok());
            QCOMPARE(gyro->address(), address);
            QCOMPARE(gyro->description().model, description.model);
        }
    }
}

void TestDeviceStGyro::find_nothingThere_namesTheAddresses()
{
    const auto bridge = makeBridge("FT260");
    const Result<StGyro> gyro = StGyro::find(*bridge->bus);
    QVERIFY(!gyro.ok());
    QCOMPARE(gyro.error().code, Errc::BusNoAcknowledge);
    QVERIFY(gyro.error().message.find("0x68, 0x69, 0x6a, 0x6b") != std::string::npos);
}

void TestDeviceStGyro::setUp_beyondTheGyro_isRefused()
{
    const auto bridge = makeBridge("CP2112");
    GyroModel part("L3GD20H", bridge->clock);
    bridge->wires.attach(0x6A, part);
    Result<StGyro> gyro = StGyro::find(*bridge->bus);
    QVERIFY(gyro.ok());
    QCOMPARE(gyro->setUp({3000.0, 100.0}).error().code, Errc::InvalidOption);
    QCOMPARE(gyro->setUp({245.0, 1000.0}).error().code, Errc::InvalidOption);
    // What sits at the address keeps nothing that is written.
    StuckModel stuck;
    bridge->wires.attach(0x6A, stuck);
    const Status kept = gyro->setUp({});
    QVERIFY(!kept.ok());
    QCOMPARE(kept.error().code, Errc::DeviceRefused);
}

void TestDeviceStGyro::fifo_readInBursts_givesEachSampleOnce()
{
    const auto bridge = makeBridge("CP2112");
    GyroModel part("L3GD20H", bridge->clock);
    bridge->wires.attach(0x6A, part);
    Result<StGyro> gyro = StGyro::find(*bridge->bus);
    QVERIFY(gyro.ok() && gyro->setUp({245.0, 200.0}).ok());
    QVERIFY(gyro->restartFifo().ok());
    std::optional<Counts> first;
    std::int64_t read = 0;
    while (read < 500) {
        bridge->clock.waitS(0.05);
        const Result<FifoState> state = gyro->fifoState();
        QVERIFY(state.ok() && !state->full);
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(state->samples) * kBytesPerSample);
        if (bytes.empty())
            continue;
        QVERIFY(gyro->readFifo(bytes).ok());
        for (int i = 0; i < state->samples; ++i, ++read) {
            const Counts counts = decodeCounts(bytes, static_cast<std::size_t>(i));
            first = first.value_or(counts);
            QCOMPARE(counts, GyroModel::numbered((*first)[0] + read));
        }
    }
    QCOMPARE(part.popped(), read);
}

QTEST_APPLESS_MAIN(TestDeviceStGyro)
#include "tst_device_st_gyro.moc"
