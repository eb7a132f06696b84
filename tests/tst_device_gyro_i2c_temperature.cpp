// The temperature of a gyro behind a bridge: from a thermometer beside it or from the die, and in step with
// the samples.
#include "support/gyro_bench.h"

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceGyroI2cTemperature : public QObject
{
    Q_OBJECT

private slots:
    void temperature_external_isPreferredAndInStep();
    void temperature_die_hasOffsetAndScale();
    void temperature_warmUp_confirmsTheSign();
    void temperature_deadThermometer_isAnError();
};

void TestDeviceGyroI2cTemperature::temperature_external_isPreferredAndInStep()
{
    GyroBench bench("MCP2221A", "L3GD20H");
    const double startS = bench.clock->nowS();
    const auto chamberC = [startS](double timeS) { return 20.0 + 0.5 * (timeS - startS); };
    bench.tmp117.temperatureC = chamberC;
    bench.bridge->wires.attach(0x48, bench.tmp117);
    const auto source = bench.open(atRate(100.0));
    QVERIFY(source != nullptr);
    GyroRecorder recorder(3000);
    QVERIFY(source->run(recorder, {}).ok());
    QVERIFY(recorder.told("TMP117"));
    const std::int64_t first = numberOf(recorder.rows[0].rateDps, kSensitivityDps);
    for (std::size_t i = 0; i < recorder.rows.size(); ++i) {
        const double trueS = bench.gyro.timeOfSampleS(first + static_cast<std::int64_t>(i));
        // A conversion takes 1 s, and a reading serves until the next one 0.5 s later.
        const double ageS = (chamberC(trueS) - recorder.rows[i].temperatureC) / 0.5;
        QVERIFY2(ageS > -0.05 && ageS < 1.8, qPrintable(QString("row %1: %2 s old").arg(i).arg(ageS)));
    }
}

void TestDeviceGyroI2cTemperature::temperature_die_hasOffsetAndScale()
{
    GyroBench bench("CP2112", "I3G4250D");
    bench.gyro.dieCount = [](double) { return -15; };
    GyroI2cOptions options = atRate(100.0);
    options.temperature.dieOffsetC = 10.0;
    GyroRecorder falling(100);
    QVERIFY(bench.open(options)->run(falling, {}).ok());
    QCOMPARE(falling.rows.back().temperatureC, 25.0);
    QVERIFY(falling.told("relative"));

    GyroBench other("CP2112", "I3G4250D");
    other.gyro.dieCount = [](double) { return -15; };
    other.bridge->wires.attach(0x48, other.tmp117);
    options.temperature.dieCPerCount = 1.0;
    options.temperature.useExternal = false;
    GyroRecorder rising(100);
    QVERIFY(other.open(options)->run(rising, {}).ok());
    QCOMPARE(rising.rows.back().temperatureC, -5.0);
}

void TestDeviceGyroI2cTemperature::temperature_warmUp_confirmsTheSign()
{
    for (const double sign : {-1.0, 1.0}) {
        GyroBench bench("FT260", "L3GD20H");
        const double startS = bench.clock->nowS();
        bench.tmp117.temperatureC = [startS](double timeS) { return 20.0 + 0.2 * (timeS - startS); };
        bench.gyro.dieCount = [&, startS](double timeS) {
            return static_cast<int>(std::round(3.0 + sign * 0.2 * (timeS - startS)));
        };
        bench.bridge->wires.attach(0x4A, bench.tmp117);
        const auto source = bench.open(atRate(100.0));
        QVERIFY(source != nullptr);
        GyroRecorder recorder(4000);
        QVERIFY(source->run(recorder, {}).ok());
        QVERIFY(recorder.told(sign < 0.0 ? "confirms its sign" : "set its scale to 1.0"));
    }
}

void TestDeviceGyroI2cTemperature::temperature_deadThermometer_isAnError()
{
    GyroBench bench("CP2112", "L3GD20H");
    bench.tmp117.temperatureC = [](double) { return -256.0; }; // as before its first conversion, for ever
    bench.bridge->wires.attach(0x48, bench.tmp117);
    const auto source = bench.open(atRate(100.0));
    QVERIFY(source != nullptr);
    GyroRecorder recorder(100);
    const Result<SourceStats> stats = source->run(recorder, {});
    QVERIFY(!stats.ok());
    QCOMPARE(stats.error().code, Errc::DeviceSilent);
    QVERIFY(stats.error().message.find("0x48") != std::string::npos);

    GyroBench pulled("CP2112", "L3GD20H");
    pulled.bridge->wires.attach(0x48, pulled.tmp117);
    const auto other = pulled.open(atRate(100.0));
    QVERIFY(other != nullptr);
    GyroRecorder longer(1000000);
    longer.onBlock = [&](std::int64_t rows) {
        if (rows > 500)
            pulled.bridge->wires.detach(0x48);
    };
    const Result<SourceStats> ended = other->run(longer, {});
    QVERIFY(!ended.ok());
    QCOMPARE(ended.error().code, Errc::BusNoAcknowledge);
    QVERIFY(ended.error().message.find("0x48") != std::string::npos);
    QVERIFY(endsWith(longer, pulled.gyro.lastPopped()));
}

QTEST_APPLESS_MAIN(TestDeviceGyroI2cTemperature)
#include "tst_device_gyro_i2c_temperature.moc"
