#include "engine/evaluation/tcq_explained.h"
#include "engine/features/temperature_quantities.h"
#include "engine/physics/comb_capacitor.h"

#include <QTest>

#include <cmath>

using namespace driftbench;

namespace {

constexpr Eigen::Index kPoints = 20001;

Eigen::VectorXd over(double low, double high, Eigen::Index points = kPoints)
{
    return Eigen::VectorXd::LinSpaced(points, low, high);
}

std::vector<TcqShare> shares(const Eigen::VectorXd &deltaTC, const Eigen::VectorXd &error)
{
    return *explainedByQuantities(deltaTC, error);
}

Eigen::VectorXd combErrors(const CombParameters &parameters, const Eigen::VectorXd &deltaTC, double dispUm)
{
    const CombCapacitor comb = *CombCapacitor::create(parameters);
    return deltaTC.unaryExpr([&](double d) { return *comb.errorFf(d, dispUm); });
}

} // namespace

class TestTcqExplained : public QObject
{
    Q_OBJECT

private slots:
    void explained_straightLine_isWholeForEverySet();
    void explained_knownFunctions_isTheirKnownShare();
    void explained_rootItself_needsTheRoot();
    void explained_residual_addsUpToItsFigures();
    void explained_combs_rootAddsLessThanACube();
    void explained_nothingToExplain_isRefused();
};

void TestTcqExplained::explained_straightLine_isWholeForEverySet()
{
    const Eigen::VectorXd deltaTC = over(-65.0, 60.0);
    for (const TcqShare &share : shares(deltaTC, 3.0 - 0.02 * deltaTC.array())) {
        QVERIFY(share.unexplained < 1e-25);
        QVERIFY(share.residualRms < 1e-13);
    }
}

// Over 0 ... 1 a line explains 15/16 of x^2 and 0.96 of sqrt x, and nothing of x^2 over -1 ... 1.
void TestTcqExplained::explained_knownFunctions_isTheirKnownShare()
{
    const Eigen::VectorXd unit = over(0.0, 1.0);
    QVERIFY(std::abs(shares(unit, unit.array().square())[0].unexplained - 1.0 / 16.0) < 1e-4);
    QVERIFY(std::abs(shares(unit, unit.array().sqrt())[0].unexplained - 0.04) < 1e-4);
    const Eigen::VectorXd both = over(-1.0, 1.0);
    QVERIFY(std::abs(shares(both, both.array().square())[0].unexplained - 1.0) < 1e-12);
    // x^3 less its best line 3x/5: 1 - 21/25 of the variance.
    QVERIFY(std::abs(shares(both, both.array().cube())[0].unexplained - 0.16) < 1e-3);
}

void TestTcqExplained::explained_rootItself_needsTheRoot()
{
    const Eigen::VectorXd deltaTC = over(-40.0, 85.0);
    const auto all = shares(deltaTC, deltaTC.unaryExpr([](double d) { return signedRoot(d); }));
    QCOMPARE(all.size(), std::size_t{4});
    QVERIFY(all[1].unexplained > 0.01);
    QVERIFY(all[2].unexplained < 1e-24);
    QVERIFY(all[3].unexplained > 0.005);
}

void TestTcqExplained::explained_residual_addsUpToItsFigures()
{
    const Eigen::VectorXd deltaTC = over(-65.0, 60.0, 101);
    const Eigen::VectorXd error = combErrors({}, deltaTC, 0.1);
    Eigen::Index terms = 2;
    for (const TcqShare &share : shares(deltaTC, error)) {
        QCOMPARE(share.terms, std::min<Eigen::Index>(terms++, 4));
        QCOMPARE(share.explained, 1.0 - share.unexplained);
        QCOMPARE(share.residual.size(), deltaTC.size());
        QVERIFY(std::abs(share.residual.squaredNorm() / 101.0 / (share.residualRms * share.residualRms) - 1) <
                1e-12);
        QVERIFY(share.residualLargest >= share.residualRms);
        QVERIFY(std::abs(share.residual.sum()) < 1e-12 * error.cwiseAbs().sum());
    }
}

// dE is analytic in dT, so its next term after dT^2 is dT^3 and no root. The root is one more column and so
// never worse, yet it must leave more than the cube, in every range and for every sort of comb.
void TestTcqExplained::explained_combs_rootAddsLessThanACube()
{
    CombParameters longCombs;
    longCombs.geometry.overlapLengthUm = 60.0;
    for (const CombParameters &parameters : {CombParameters{}, longCombs}) {
        for (const auto &[low, high] :
             {std::pair(-65.0, 60.0), std::pair(0.0, 60.0), std::pair(-125.0, 50.0)}) {
            const Eigen::VectorXd deltaTC = over(low, high, 501);
            const auto all = shares(deltaTC, combErrors(parameters, deltaTC, 0.1));
            QVERIFY(all[0].unexplained >= all[1].unexplained);
            QVERIFY(all[1].unexplained >= all[2].unexplained);
            QVERIFY(all[2].unexplained > 2.0 * all[3].unexplained);
        }
    }
}

void TestTcqExplained::explained_nothingToExplain_isRefused()
{
    const Eigen::VectorXd deltaTC = over(-65.0, 60.0, 101);
    QCOMPARE(explainedByQuantities(over(0, 1, 7), over(0, 1, 7)).error().code, Errc::TooFewSamples);
    QCOMPARE(explainedByQuantities(Eigen::VectorXd::Ones(20), over(0, 1, 20)).error().code,
             Errc::ConstantTemperature);
    QCOMPARE(explainedByQuantities(deltaTC, combErrors({}, deltaTC, 0.0)).error().code, Errc::InvalidOption);
}

QTEST_APPLESS_MAIN(TestTcqExplained)
#include "tst_tcq_explained.moc"
