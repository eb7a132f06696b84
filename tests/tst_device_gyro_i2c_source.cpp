// A gyro behind each of the bridges as a sample source: what it records is what the gyro model measured, each
// sample once, in order, at its time. What goes wrong on the way is in tst_device_gyro_i2c_faults,
// temperature in tst_device_gyro_i2c_temperature.
#include "support/gyro_bench.h"

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceGyroI2cSource : public QObject
{
    Q_OBJECT

private slots:
    void fifoClock_drawnLevels_findsPeriodAndPhase();
    void samples_everyBridgeGyroAndRate_areThoseMeasured_data();
    void samples_everyBridgeGyroAndRate_areThoseMeasured();
    void saturation_isCountedAndToldOnce();
    void open_wrongSensor_isNamed();
    void open_optionsNobodyHas_areRefused();
    void info_saysWhatIsMeasured();
};

void TestDeviceGyroI2cSource::fifoClock_drawnLevels_findsPeriodAndPhase()
{
    for (const double factor : {0.93, 1.0, 1.07}) {
        const double rateHz = 100.0 * factor;
        const double beganS = 17.3;
        FifoClock clock(100.0);
        Random random(31);
        double nowS = beganS + 0.1;
        double worst = 0.0;
        for (int look = 0; look < 4000; ++look, nowS += random.uniform(0.05, 0.15)) {
            const auto taken = static_cast<std::int64_t>(std::floor((nowS - beganS) * rateHz));
            if (look > 300) {
                worst = std::max(worst, std::abs(clock.takenAt(nowS) + 0.0 - (nowS - beganS) * rateHz + 0.5));
                worst = std::max(worst,
                                 std::abs(clock.timeS(taken) - (beganS + (taken + 1.0) / rateHz)) * rateHz);
            }
            clock.see(taken, nowS, 0.001);
        }
        QVERIFY2(worst < 0.15, qPrintable(QString("%1 samples off at %2").arg(worst).arg(factor)));
        QVERIFY(std::abs(clock.periodS() * rateHz - 1.0) < 1e-4);
    }
}

void TestDeviceGyroI2cSource::samples_everyBridgeGyroAndRate_areThoseMeasured_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("model");
    QTest::addColumn<double>("rateHz");
    QTest::addColumn<double>("factor");
    for (const char *name : kBridgeNames) {
        for (const char *model : {"L3GD20H", "I3G4250D"}) {
            for (const double rateHz : {100.0, 200.0, 400.0, 800.0}) {
                for (const double factor : {0.95, 1.0, 1.05})
                    QTest::addRow("%s %s %g Hz x %g", name, model, rateHz, factor)
                        << QString(name) << QString(model) << rateHz << factor;
            }
        }
        QTest::addRow("%s L3GD20H 12.5 Hz", name) << QString(name) << QString("L3GD20H") << 12.5 << 1.02;
    }
}

void TestDeviceGyroI2cSource::samples_everyBridgeGyroAndRate_areThoseMeasured()
{
    QFETCH(QString, name);
    QFETCH(QString, model);
    QFETCH(double, rateHz);
    QFETCH(double, factor);
    GyroBench bench(name, model, factor);
    if (rateHz < 800.0) // pieces cost time
        bench.bridge->chip->splitData(5);
    const auto source = bench.open(atRate(rateHz));
    QVERIFY(source != nullptr);
    GyroRecorder recorder(6000);
    const Result<SourceStats> stats = source->run(recorder, {});
    QVERIFY2(stats.ok(), stats.ok() ? "" : stats.error().message.c_str());
    QCOMPARE(flaw(recorder), QString());
    QCOMPARE(stats->samples, static_cast<std::int64_t>(recorder.rows.size()));
    QCOMPARE(stats->lostSamples, std::int64_t(0));
    QVERIFY(std::abs(stats->clockDriftPpm - (factor - 1.0) * 1e6) < 2000.0);
    // Once the true rate is found, every sample has its time, but for one offset common to all.
    const std::int64_t first = numberOf(recorder.rows[0].rateDps, kSensitivityDps);
    const auto error = [&](std::size_t i) {
        const double trueS =
            bench.gyro.timeOfSampleS(first + static_cast<std::int64_t>(i)) - bench.gyro.timeOfSampleS(first);
        return (recorder.rows[i].timeS - trueS) * bench.gyro.trueRateHz();
    };
    for (std::size_t i = 3000; i < recorder.rows.size(); ++i)
        QVERIFY2(std::abs(error(i) - error(3000)) < 0.5,
                 qPrintable(QString("row %1: %2").arg(i).arg(error(i))));
    QVERIFY(std::abs(error(3000)) < 2.0);
}

void TestDeviceGyroI2cSource::saturation_isCountedAndToldOnce()
{
    GyroBench bench("CP2112", "L3GD20H");
    bench.gyro.counts = [](std::int64_t sample) {
        return driftbench::test::Counts{0, static_cast<std::int16_t>(sample % 10 == 0 ? 32767 : 5), 0};
    };
    const auto source = bench.open(atRate(100.0));
    QVERIFY(source != nullptr);
    GyroRecorder recorder(1000);
    const Result<SourceStats> stats = source->run(recorder, {});
    QVERIFY(stats.ok());
    QVERIFY(std::abs(static_cast<double>(stats->saturatedSamples) -
                     0.1 * static_cast<double>(stats->samples)) < 2.0);
    QCOMPARE(
        std::count_if(recorder.events.begin(), recorder.events.end(),
                      [](const std::string &event) { return event.find("axis y") != std::string::npos; }),
        1);
    QVERIFY(!recorder.told("axis x"));
}

void TestDeviceGyroI2cSource::open_wrongSensor_isNamed()
{
    GyroBench bench("MCP2221A", "I3G4250D");
    GyroI2cOptions options;
    options.model = "L3GD20H";
    options.address = 0x68;
    const auto source = GyroI2cSource::open(std::move(bench.bridge->bus), options, *bench.clock);
    QVERIFY(!source.ok());
    QCOMPARE(source.error().code, Errc::WrongSensor);
    QVERIFY(source.error().message.find("I3G4250D") != std::string::npos);
}

void TestDeviceGyroI2cSource::open_optionsNobodyHas_areRefused()
{
    const auto code = [](const GyroI2cOptions &options) {
        GyroBench bench("CP2112", "L3GD20H");
        const auto source = GyroI2cSource::open(std::move(bench.bridge->bus), options, *bench.clock);
        return source ? Errc::Cancelled : source.error().code;
    };
    GyroI2cOptions options;
    options.model = "MPU6050";
    QCOMPARE(code(options), Errc::InvalidOption);
    options.model.clear();
    options.address = 0x50;
    QCOMPARE(code(options), Errc::InvalidOption);
    QCOMPARE(code(atRate(5000.0)), Errc::InvalidOption);
    options = {};
    options.model = "I3G4250D";
    QCOMPARE(code(options), Errc::BusNoAcknowledge);
}

void TestDeviceGyroI2cSource::info_saysWhatIsMeasured()
{
    GyroBench bench("CP2112", "L3GD20H");
    GyroI2cOptions options = atRate(150.0);
    options.serial = "board 7";
    options.address = 0x6B;
    options.gyro.rangeDps = 400.0;
    const auto source = bench.open(options);
    QVERIFY(source != nullptr);
    QCOMPARE(source->info().name, std::string("CP2112 00A1B2C3 with L3GD20H at 0x6b"));
    QCOMPARE(source->info().sensor.model, std::string("L3GD20H"));
    QCOMPARE(source->info().sensor.serial, std::string("board 7"));
    QCOMPARE(source->info().sampleRateHz, 200.0);
    QCOMPARE(source->info().rangeDps, 500.0);
    QVERIFY(!source->info().simulated && !source->info().compensated);
}

QTEST_APPLESS_MAIN(TestDeviceGyroI2cSource)
#include "tst_device_gyro_i2c_source.moc"
