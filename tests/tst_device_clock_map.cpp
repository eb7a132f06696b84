// The device's clock on the host's time line, against a device whose clock and delays are known.
#include "device/clock_map.h"
#include "engine/base/random.h"

#include <QTest>

#include <cmath>

using namespace driftbench;

class TestDeviceClockMap : public QObject
{
    Q_OBJECT

private slots:
    void map_exactClock_isTheDevicesTime();
    void drift_simulatedJitter_isFound_data();
    void drift_simulatedJitter_isFound();
    void map_wraps_areUnwrapped();
    void map_silenceOfManyWraps_isTheHosts();
    void map_backwards_neverGoesBack();
    void restart_clockAnew_goesOnFromTheHost();
    void drift_longStalls_doNoHarm();
    void drift_tooSoon_isNotKnown();
};

namespace {

constexpr std::uint64_t kSeed = 77;

// Reports every intervalS of true time: a device clock with an error, and a delay that is at least 0.3 ms,
// usually a little more and now and then very much more.
struct World
{
    double ppm;
    double intervalS;
    std::uint32_t startUs;
    Random random{kSeed};
    double lateUntilS = 0.0;

    std::uint32_t deviceUs(double trueS) const
    {
        return startUs +
               static_cast<std::uint32_t>(static_cast<std::uint64_t>(std::llround(trueS * (1e6 + ppm))));
    }
    double hostS(double trueS)
    {
        if (random.uniform() < 0.002)
            lateUntilS = trueS + random.uniform(0.05, 0.5);
        const double jitterS = -0.0005 * std::log(1.0 - random.uniform());
        return 1000.0 + std::max(trueS + 0.0003 + jitterS, lateUntilS);
    }
};

} // namespace

void TestDeviceClockMap::map_exactClock_isTheDevicesTime()
{
    ClockMap map;
    for (std::uint32_t i = 0; i < 1000; ++i)
        QCOMPARE(map.map(5000000u + 7000u * i, 42.0 + 0.007 * i), 7000.0 * i * 1e-6);
    QCOMPARE(map.driftPpm(), 0.0);
}

void TestDeviceClockMap::drift_simulatedJitter_isFound_data()
{
    QTest::addColumn<double>("ppm");
    QTest::addColumn<double>("intervalS");
    QTest::addColumn<double>("durationS");
    QTest::addColumn<double>("allowedPpm");
    for (const double ppm : {-200.0, -20.0, 0.0, 20.0, 200.0}) {
        QTest::addRow("%g ppm, 140 Hz, 2 min", ppm) << ppm << 0.007 << 120.0 << 3.0;
        QTest::addRow("%g ppm, 25 Hz, 1 h", ppm) << ppm << 0.04 << 3600.0 << 0.5;
        QTest::addRow("%g ppm, 5 Hz, 3 h", ppm) << ppm << 0.2 << 10800.0 << 0.5;
    }
}

void TestDeviceClockMap::drift_simulatedJitter_isFound()
{
    QFETCH(double, ppm);
    QFETCH(double, intervalS);
    QFETCH(double, durationS);
    QFETCH(double, allowedPpm);
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    World world{ppm, intervalS, 0xFFF00000u};
    ClockMap map;
    double lastS = -1.0;
    double settledS = 0.0; // error after the first minute, which stays
    double worstS = 0.0;
    for (double trueS = 0.0; trueS < durationS; trueS += intervalS) {
        const double timeS = map.map(world.deviceUs(trueS), world.hostS(trueS));
        QVERIFY(timeS > lastS);
        lastS = timeS;
        if (trueS < 60.0)
            settledS = timeS - trueS;
        worstS = std::max(worstS, std::abs(timeS - trueS - settledS));
    }
    QVERIFY(map.driftKnown());
    QVERIFY2(std::abs(map.driftPpm() - ppm) < allowedPpm, qPrintable(QString::number(map.driftPpm())));
    // What is left of 200 ppm would be 0.7 s in an hour.
    QVERIFY2(worstS < 0.02, qPrintable(QString::number(worstS)));
}

void TestDeviceClockMap::map_wraps_areUnwrapped()
{
    World world{0.0, 30.0, 0xFFFFFFFFu - 1000u};
    ClockMap map;
    for (double trueS = 0.0; trueS < 30000.0; trueS += world.intervalS) {
        const double timeS = map.map(world.deviceUs(trueS), 1000.0 + trueS);
        QVERIFY(std::abs(timeS - trueS) < 1e-6);
    }
}

void TestDeviceClockMap::map_silenceOfManyWraps_isTheHosts()
{
    for (const double silenceS : {1000.0, 3000.0, 4294.0, 4296.0, 10000.0, 40000.0}) {
        World world{0.0, 0.01, 123u};
        ClockMap map;
        map.map(world.deviceUs(0.0), 1000.0);
        const double timeS = map.map(world.deviceUs(silenceS), 1000.4 + silenceS);
        QVERIFY2(std::abs(timeS - silenceS) < 1e-5, qPrintable(QString::number(timeS)));
    }
}

void TestDeviceClockMap::map_backwards_neverGoesBack()
{
    ClockMap map;
    map.map(1000000, 10.0);
    QCOMPARE(map.map(3000000, 12.0), 2.0);
    QCOMPARE(map.map(2500000, 12.1), 2.0);
    QCOMPARE(map.map(3000000, 12.2), 2.0);
    QCOMPARE(map.map(3500000, 12.5), 2.5);
    Random random(kSeed);
    double lastS = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const double timeS =
            map.map(static_cast<std::uint32_t>(random.bits()), 20.0 + i * random.uniform(0.0, 3.0));
        QVERIFY(timeS >= lastS && std::isfinite(timeS));
        lastS = timeS;
    }
}

void TestDeviceClockMap::restart_clockAnew_goesOnFromTheHost()
{
    World world{150.0, 0.01, 0u};
    ClockMap map;
    double trueS = 0.0;
    for (; trueS < 120.0; trueS += world.intervalS)
        map.map(world.deviceUs(trueS), world.hostS(trueS));
    const double beforePpm = map.driftPpm();
    const double lastS = map.map(world.deviceUs(trueS), 1000.0 + trueS);
    map.restart();
    // Power-up: the clock counts from 0 again.
    const double powerUpS = trueS + 7.0;
    const double resumedS = map.map(5000, 1000.0 + powerUpS);
    QVERIFY(std::abs(resumedS - lastS - 7.0) < 1e-9);
    QCOMPARE(map.driftPpm(), beforePpm);
    const double nextS = map.map(1005000, 1001.0 + powerUpS);
    QVERIFY(std::abs(nextS - resumedS - 1.0 / (1.0 + beforePpm * 1e-6)) < 1e-9);
}

void TestDeviceClockMap::drift_longStalls_doNoHarm()
{
    // A fifth of the time the host is 20 s behind.
    World world{-100.0, 0.02, 0u};
    ClockMap map;
    for (double trueS = 0.0; trueS < 1800.0; trueS += world.intervalS) {
        double hostS = world.hostS(trueS);
        if (std::fmod(trueS, 100.0) < 20.0)
            hostS = std::max(hostS, 1000.0 + std::floor(trueS / 100.0) * 100.0 + 20.0);
        map.map(world.deviceUs(trueS), hostS);
    }
    QVERIFY2(std::abs(map.driftPpm() + 100.0) < 1.0, qPrintable(QString::number(map.driftPpm())));
}

void TestDeviceClockMap::drift_tooSoon_isNotKnown()
{
    World world{200.0, 0.01, 0u};
    ClockMap map;
    for (double trueS = 0.0; trueS < 20.0; trueS += world.intervalS)
        map.map(world.deviceUs(trueS), world.hostS(trueS));
    QVERIFY(!map.driftKnown());
    QCOMPARE(map.driftPpm(), 0.0);
}

QTEST_APPLESS_MAIN(TestDeviceClockMap)
#include "tst_device_clock_map.moc"
