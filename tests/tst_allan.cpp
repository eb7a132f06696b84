#include "engine/base/random.h"
#include "engine/evaluation/allan.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace driftbench;

class TestAllan : public QObject
{
    Q_OBJECT

private slots:
    void allanDeviation_testSetOfNist_isThePublishedOne();
    void allanDeviation_whiteNoise_fallsWithTheRootOfTau();
    void allanDeviation_randomWalk_risesWithTheRootOfTau();
    void allanDeviation_ramp_isSlopeTimesTauOverRootTwo();
    void allanDeviation_gap_usesTheLongestStretch();
    void allanDeviation_eightSamples_isEmpty();
    void biasInstability_whiteNoiseAndRandomWalk_isReadWhereTheyMeet();
};

static Eigen::VectorXd times(Eigen::Index count, double intervalS)
{
    return Eigen::VectorXd::LinSpaced(count, 0.0, intervalS * static_cast<double>(count - 1));
}

static Eigen::Index indexOf(const AllanCurve &curve, double tauS)
{
    Eigen::Index nearest = 0;
    (curve.tauS.array() / tauS - 1.0).abs().minCoeff(&nearest);
    return nearest;
}

void TestAllan::allanDeviation_testSetOfNist_isThePublishedOne()
{
    // NIST SP 1065, section 12.4: 1000 values n / (2^31 - 1), n <- 16807 n mod (2^31 - 1), first n
    // 1234567890; Table 31 gives the overlapping Allan deviation to seven digits.
    constexpr std::uint64_t kModulus = 2147483647;
    std::uint64_t n = 1234567890;
    Eigen::MatrixX3d rate(1000, 3);
    for (Eigen::Index i = 0; i < 1000; ++i) {
        rate.row(i).setConstant(static_cast<double>(n) / static_cast<double>(kModulus));
        n = 16807 * n % kModulus;
    }
    const AllanCurve curve = allanDeviation(times(1000, 1.0), rate);
    const double published[3][2] = {{1.0, 2.922319e-01}, {10.0, 9.159953e-02}, {100.0, 3.241343e-02}};
    for (const auto &[tauS, deviation] : published) {
        const Eigen::Index row = indexOf(curve, tauS);
        QVERIFY(std::abs(curve.tauS[row] - tauS) < 1e-9);
        QVERIFY2(std::abs(curve.deviationDps(row, 1) / deviation - 1.0) < 3e-7,
                 qPrintable(QString::number(curve.deviationDps(row, 1), 'g', 9)));
    }
}

void TestAllan::allanDeviation_whiteNoise_fallsWithTheRootOfTau()
{
    constexpr std::uint64_t kSeed = 21;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    Eigen::MatrixX3d rate(100000, 3);
    for (Eigen::Index i = 0; i < rate.size(); ++i)
        rate.data()[i] = 0.14 * random.normal() + 25.0;
    const AllanCurve curve = allanDeviation(times(100000, 0.1), rate);
    for (const double tauS : {0.1, 1.0, 10.0, 100.0}) {
        const double expected = 0.14 * std::sqrt(0.1 / tauS);
        QVERIFY((curve.deviationDps.row(indexOf(curve, tauS)).array() / expected - 1.0).abs().maxCoeff() <
                0.12);
    }
}

void TestAllan::allanDeviation_randomWalk_risesWithTheRootOfTau()
{
    // A walk with steps of variance q each tau0: sigma^2(m) = q (2 m^2 + 1) / (6 m).
    Random random(22);
    Eigen::MatrixX3d rate(200000, 3);
    Eigen::RowVector3d walk = Eigen::RowVector3d::Zero();
    for (Eigen::Index i = 0; i < rate.rows(); ++i) {
        walk += 0.01 * Eigen::RowVector3d(random.normal(), random.normal(), random.normal());
        rate.row(i) = walk;
    }
    const AllanCurve curve = allanDeviation(times(200000, 1.0), rate);
    for (const double m : {1.0, 10.0, 100.0, 1000.0}) {
        const double expected = 0.01 * std::sqrt((2.0 * m * m + 1.0) / (6.0 * m));
        QVERIFY((curve.deviationDps.row(indexOf(curve, m)).array() / expected - 1.0).abs().maxCoeff() < 0.15);
    }
}

void TestAllan::allanDeviation_ramp_isSlopeTimesTauOverRootTwo()
{
    Eigen::MatrixX3d rate(5000, 3);
    for (Eigen::Index i = 0; i < rate.rows(); ++i)
        rate.row(i).setConstant(0.002 * static_cast<double>(i));
    const AllanCurve curve = allanDeviation(times(5000, 0.5), rate);
    for (Eigen::Index i = 0; i < curve.tauS.size(); ++i) {
        const double expected = 0.004 * curve.tauS[i] / std::numbers::sqrt2;
        QVERIFY(std::abs(curve.deviationDps(i, 0) / expected - 1.0) < 1e-6);
    }
}

void TestAllan::allanDeviation_gap_usesTheLongestStretch()
{
    Random random(23);
    Eigen::MatrixX3d rate(3000, 3);
    for (Eigen::Index i = 0; i < rate.size(); ++i)
        rate.data()[i] = random.normal();
    Eigen::VectorXd timeS = times(3000, 0.1);
    timeS.tail(2000).array() += 5.0;
    rate.topRows(1000).array() += 1000.0; // what is before the gap must not be seen
    const AllanCurve broken = allanDeviation(timeS, rate);
    const AllanCurve whole = allanDeviation(times(2000, 0.1), rate.bottomRows(2000));
    QCOMPARE(broken.tauS.size(), whole.tauS.size());
    QVERIFY((broken.tauS - whole.tauS).cwiseAbs().maxCoeff() < 1e-9);
    QVERIFY((broken.deviationDps - whole.deviationDps).cwiseAbs().maxCoeff() == 0.0);
}

void TestAllan::allanDeviation_eightSamples_isEmpty()
{
    const Eigen::MatrixX3d eight = Eigen::MatrixX3d::Random(8, 3);
    QCOMPARE(allanDeviation(times(8, 1.0), eight).tauS.size(), Eigen::Index{0});
    const Eigen::MatrixX3d nine = Eigen::MatrixX3d::Random(9, 3);
    const AllanCurve curve = allanDeviation(times(9, 1.0), nine);
    QVERIFY(curve.tauS.size() > 0);
    QVERIFY(curve.biasInstabilityDps.minCoeff() > 0.0);
    QCOMPARE(allanDeviation(Eigen::VectorXd(), Eigen::MatrixX3d(0, 3)).tauS.size(), Eigen::Index{0});
}

void TestAllan::biasInstability_whiteNoiseAndRandomWalk_isReadWhereTheyMeet()
{
    // N^2 / tau + K^2 tau / 3 is lowest at tau = sqrt(3) N / K, where it is 2 N K / sqrt(3).
    Random random(24);
    constexpr double kNoise = 0.1;
    constexpr double kWalk = 0.002;
    Eigen::MatrixX3d rate(200000, 3);
    Eigen::RowVector3d walk = Eigen::RowVector3d::Zero();
    for (Eigen::Index i = 0; i < rate.rows(); ++i) {
        walk += kWalk * Eigen::RowVector3d(random.normal(), random.normal(), random.normal());
        rate.row(i) = walk + kNoise * Eigen::RowVector3d(random.normal(), random.normal(), random.normal());
    }
    const AllanCurve curve = allanDeviation(times(200000, 1.0), rate);
    const double lowest = std::sqrt(2.0 * kNoise * kWalk / std::sqrt(3.0));
    const double expected = lowest / std::sqrt(2.0 * std::numbers::ln2 / std::numbers::pi);
    QVERIFY((curve.biasInstabilityDps.array() / expected - 1.0).abs().maxCoeff() < 0.08);
    const double tauS = std::sqrt(3.0) * kNoise / kWalk;
    QVERIFY((curve.biasInstabilityTauS.array() / tauS).log().abs().maxCoeff() < 0.8);
}

QTEST_APPLESS_MAIN(TestAllan)
#include "tst_allan.moc"
