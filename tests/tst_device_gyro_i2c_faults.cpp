// A gyro behind each of the bridges when something goes wrong: what is missing is counted, what fails is
// told, and what came before is delivered.
#include "support/gyro_bench.h"

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceGyroI2cFaults : public QObject
{
    Q_OBJECT

private slots:
    void samples_slowReader_lossIsCountedExactly_data() { addBridges(); }
    void samples_slowReader_lossIsCountedExactly();
    void transfers_thatFail_areOvercomeAndCounted_data() { addBridges(); }
    void transfers_thatFail_areOvercomeAndCounted();
    void bus_thatKeepsFailing_endsTheRunWithItsError_data() { addBridges(); }
    void bus_thatKeepsFailing_endsTheRunWithItsError();
    void bridge_unpluggedAnywhere_deliversWhatCameBefore_data() { addBridges(); }
    void bridge_unpluggedAnywhere_deliversWhatCameBefore();
    void answers_randomBytes_endOrGoOn_data() { addBridges(); }
    void answers_randomBytes_endOrGoOn();
};

void TestDeviceGyroI2cFaults::samples_slowReader_lossIsCountedExactly()
{
    QFETCH(QString, name);
    for (const double rateHz : {100.0, 200.0, 400.0}) {
        for (const std::uint64_t seed : {41, 42, 43}) {
            GyroBench bench(name, "L3GD20H", 1.03);
            const auto source = bench.open(atRate(rateHz));
            QVERIFY(source != nullptr);
            GyroRecorder recorder(20000);
            Random random(seed);
            std::int64_t nextStall = 3000;
            std::int64_t overwrittenBefore = -1; // while the source was set up
            recorder.onBlock = [&](std::int64_t rows) {
                if (overwrittenBefore < 0)
                    overwrittenBefore = bench.gyro.overwritten();
                if (rows < nextStall || rows > 19000) // the last gap has samples after it
                    return;
                nextStall = rows + 700;
                bench.clock->waitS(random.uniform(0.01, 1.0)); // the host is busy
            };
            const Result<SourceStats> stats = source->run(recorder, {});
            QVERIFY(stats.ok());
            QVERIFY2(flaw(recorder).isEmpty(),
                     qPrintable(QString("%1 Hz, seed %2: %3").arg(rateHz).arg(seed).arg(flaw(recorder))));
            QVERIFY(recorder.gaps.size() >= 6);
            for (const SampleGap &gap : recorder.gaps)
                QCOMPARE(gap.cause, GapCause::DeviceOverrun);
            QCOMPARE(stats->lostSamples, bench.gyro.overwritten() - overwrittenBefore);
            QCOMPARE(stats->gaps, static_cast<std::int64_t>(recorder.gaps.size()));
        }
    }
}

void TestDeviceGyroI2cFaults::transfers_thatFail_areOvercomeAndCounted()
{
    QFETCH(QString, name);
    GyroBench bench(name, "I3G4250D", 0.98);
    const auto source = bench.open(atRate(100.0));
    QVERIFY(source != nullptr);
    GyroRecorder recorder(8000);
    std::int64_t nextFault = 2000;
    bool stuck = false;
    recorder.onBlock = [&](std::int64_t rows) {
        if (rows < nextFault)
            return;
        nextFault = rows + 700;
        if (stuck)
            bench.bridge->wires.holdLow(1);
        else
            bench.bridge->wires.refuseNext(1);
        stuck = !stuck;
    };
    const Result<SourceStats> stats = source->run(recorder, {});
    QVERIFY(stats.ok());
    QCOMPARE(flaw(recorder), QString());
    QVERIFY(recorder.told("Nothing answers at I2C address 0x68"));
    QVERIFY(recorder.told("is stuck"));
    for (const SampleGap &gap : recorder.gaps)
        QCOMPARE(gap.cause, GapCause::ReportsLost);
}

void TestDeviceGyroI2cFaults::bus_thatKeepsFailing_endsTheRunWithItsError()
{
    QFETCH(QString, name);
    for (const bool heldLow : {false, true}) {
        GyroBench bench(name, "L3GD20H");
        const auto source = bench.open(atRate(100.0));
        QVERIFY(source != nullptr);
        GyroRecorder recorder(1000000);
        recorder.onBlock = [&](std::int64_t rows) {
            if (rows > 1000)
                heldLow ? bench.bridge->wires.holdLow(1000000) : bench.bridge->wires.detach(0x6B);
        };
        const Result<SourceStats> stats = source->run(recorder, {});
        QVERIFY(!stats.ok());
        QCOMPARE(stats.error().code, heldLow ? Errc::BusStuck : Errc::BusNoAcknowledge);
        QCOMPARE(flaw(recorder), QString());
        // What was fetched before the bus failed has been delivered.
        QVERIFY(endsWith(recorder, bench.gyro.lastPopped()));
    }
}

void TestDeviceGyroI2cFaults::bridge_unpluggedAnywhere_deliversWhatCameBefore()
{
    QFETCH(QString, name);
    for (int calls = 0; calls < 60; ++calls) {
        GyroBench bench(name, "L3GD20H");
        const auto source = bench.open(atRate(100.0));
        QVERIFY(source != nullptr);
        GyroRecorder recorder(1000000);
        recorder.onBlock = [&](std::int64_t rows) {
            if (rows > 200) {
                bench.bridge->chip->unplugAfter(calls);
                recorder.onBlock = {};
            }
        };
        const Result<SourceStats> stats = source->run(recorder, {});
        QVERIFY(!stats.ok());
        QCOMPARE(stats.error().code, Errc::DeviceUnplugged);
        QCOMPARE(flaw(recorder), QString());
        QVERIFY(recorder.rows.size() > 200);
    }
}

void TestDeviceGyroI2cFaults::answers_randomBytes_endOrGoOn()
{
    QFETCH(QString, name);
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        GyroBench bench(name, "L3GD20H");
        const auto source = bench.open(atRate(400.0));
        QVERIFY(source != nullptr);
        GyroRecorder recorder(5000);
        recorder.onBlock = [&](std::int64_t rows) {
            if (rows > 500) {
                bench.bridge->chip->answerWithRandomBytes(seed);
                recorder.onBlock = {};
            }
        };
        const Result<SourceStats> stats = source->run(recorder, {});
        QVERIFY(stats.ok() || !stats.error().message.empty());
        QVERIFY(recorder.rows.size() > 500);
        for (std::size_t i = 1; i < recorder.rows.size(); ++i)
            QVERIFY(recorder.rows[i].timeS > recorder.rows[i - 1].timeS);
    }
}

QTEST_APPLESS_MAIN(TestDeviceGyroI2cFaults)
#include "tst_device_gyro_i2c_faults.moc"
