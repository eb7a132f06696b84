#include "engine/base/random.h"
#include "engine/features/thermal_curve.h"
#include "support/test_data.h"

#include <QTest>

using namespace driftbench;

class TestThermalCurve : public QObject
{
    Q_OBJECT

private slots:
    void merge_partsInAnyOrder_equalsWhole();
    void shift_everySample_movesMeansAndKeepsVariance();
    void pooledVariance_whiteNoise_isItsVariance();
};

static Eigen::Vector3d noisyTde(Random &random, double deltaT)
{
    return {0.02 * deltaT + 0.1 * random.normal(), 3.0 + 0.2 * random.normal(), 0.3 * random.normal()};
}

void TestThermalCurve::merge_partsInAnyOrder_equalsWhole()
{
    constexpr std::uint64_t kSeed = 20261121;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    ThermalCurve whole;
    std::vector<ThermalCurve> parts(7);
    for (int i = 0; i < 20000; ++i) {
        const double deltaT = random.uniform(-20.0, 60.0);
        const Eigen::Vector3d tde = noisyTde(random, deltaT);
        whole.add(deltaT, tde);
        parts[random.below(parts.size())].add(deltaT, tde);
    }
    ThermalCurve merged;
    for (auto part = parts.rbegin(); part != parts.rend(); ++part)
        merged.merge(*part);
    QCOMPARE(merged.firstKey(), whole.firstKey());
    QCOMPARE(merged.cells().size(), whole.cells().size());
    for (std::size_t i = 0; i < whole.cells().size(); ++i) {
        QCOMPARE(merged.cells()[i].count, whole.cells()[i].count);
        QVERIFY((merged.cells()[i].sumTdeDps - whole.cells()[i].sumTdeDps).norm() < 1e-11);
        QVERIFY((merged.cells()[i].sumTdeSquared - whole.cells()[i].sumTdeSquared).norm() < 1e-11);
    }
}

void TestThermalCurve::shift_everySample_movesMeansAndKeepsVariance()
{
    Random random(3);
    ThermalCurve curve;
    for (int i = 0; i < 5000; ++i)
        curve.add(random.uniform(0.0, 1.0), noisyTde(random, 0.0));
    ThermalCurve shifted = curve;
    const Eigen::Vector3d offset(1.0, -2.0, 0.5);
    shifted.shift(offset);
    QVERIFY((curve.pooledVariance() - shifted.pooledVariance()).norm() < 1e-12);
    QVERIFY((curve.cells()[3].meanTdeDps() - offset - shifted.cells()[3].meanTdeDps()).norm() < 1e-12);
}

void TestThermalCurve::pooledVariance_whiteNoise_isItsVariance()
{
    Random random(5);
    ThermalCurve curve;
    for (int i = 0; i < 200000; ++i)
        curve.add(random.uniform(0.0, 5.0), noisyTde(random, 0.0));
    const Eigen::Vector3d variance = curve.pooledVariance();
    QVERIFY(std::abs(variance[0] / 0.01 - 1.0) < 0.02);
    QVERIFY(std::abs(variance[1] / 0.04 - 1.0) < 0.02);
    QVERIFY(std::abs(variance[2] / 0.09 - 1.0) < 0.02);
}

QTEST_APPLESS_MAIN(TestThermalCurve)
#include "tst_thermal_curve.moc"
