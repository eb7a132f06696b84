#include "engine/physics/comb_drift.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace driftbench;

class TestCombDrift : public QObject
{
    Q_OBJECT

private slots:
    void straightCombs_haveNoDrift();
    void parallelPlates_driftByTheirGrowth();
    void bentCombs_toFirstOrder_changeSensitivityByTheMeanGap();
    void restAndReference_addUp();
    void packageTerm_isAddedAsItIs();
    void touchingCombs_areNotANumber();
    void badFigures_areRefusedInOneSentence_data();
    void badFigures_areRefusedInOneSentence();
};

namespace {

CombDrift withRest(double restDps)
{
    CombDrift drift;
    for (CombAxis &axis : drift.axes)
        axis.restDps = restDps;
    return drift;
}

DriftCurves curvesOf(const CombDrift &drift, const Eigen::Vector3d &referenceRateDps = {0.0, 0.0, 0.0})
{
    auto curves = combDriftCurves(drift, referenceRateDps);
    if (!curves)
        qFatal("%s", curves.error().message.c_str());
    return *std::move(curves);
}

} // namespace

void TestCombDrift::straightCombs_haveNoDrift()
{
    const DriftCurves drifting = curvesOf(withRest(170.0), {25.0, 5.0, 53.0});
    const DriftCurves symmetrical = curvesOf(withRest(0.0));
    QCOMPARE(drifting.name, std::string(kCombDriftName));
    for (int axis = 0; axis < kAxisCount; ++axis) {
        QVERIFY(std::abs(drifting.rateDps[axis](25.0)) < 1e-9);
        for (const double temperatureC : {-40.0, 0.0, 85.0})
            QVERIFY(std::abs(symmetrical.rateDps[axis](temperatureC)) < 1e-9);
    }
}

// A plate of an overlap that is short against its thickness hardly bends: what is left of Eq. (10) is the
// growth (1 + 2 alpha dT)^2 of its area.
void TestCombDrift::parallelPlates_driftByTheirGrowth()
{
    CombDrift drift = withRest(200.0);
    for (CombAxis &axis : drift.axes) {
        axis.combs.geometry.overlapLengthUm = 1e-3;
        axis.combs.geometry.thicknessUm = 1e3;
        axis.combs.material.expansionPerC = 1e-4;
    }
    const DriftCurves curves = curvesOf(drift, {0.0, -300.0, 45.0});
    const std::array<double, kAxisCount> displacedDps{200.0, -100.0, 245.0};
    for (int axis = 0; axis < kAxisCount; ++axis) {
        for (const double temperatureC : {-40.0, 10.0, 85.0}) {
            const double growth = 1.0 + 2.0 * 1e-4 * (temperatureC - 25.0);
            // S is the slope at rest; a displacement of v makes 1 / (1 - v / d0) of it.
            const double bent = displacedDps[axis] / (1.0 - displacedDps[axis] * 1e-5 / 2.0);
            QVERIFY(std::abs(curves.rateDps[axis](temperatureC) - bent * (growth * growth - 1.0)) < 1e-6);
        }
    }
}

void TestCombDrift::bentCombs_toFirstOrder_changeSensitivityByTheMeanGap()
{
    // The mean of 2x^2 - 2 b0 x + b0^2 over 0 .. b0 is 2/3 b0^2, and sensitivity goes with 1 / gap^2: per
    // degree 2 * 12 alpha / a0 * 2/3 b0^2 / d0, and 4 alpha from growth.
    const CombDrift drift = withRest(170.0);
    const double perC = 16.0 * 2.4e-6 / 4.0 * 64.0 / 2.0 + 4.0 * 2.4e-6;
    const DriftCurves curves = curvesOf(drift);
    const double slope = (curves.rateDps[0](25.5) - curves.rateDps[0](24.5)) / 170.0;
    QVERIFY2(std::abs(slope / perC - 1.0) < 2e-3, qPrintable(QString::number(slope / perC)));
    // The datasheets' 2 % over half of -40 ... 85 C.
    QVERIFY(std::abs(curves.rateDps[0](87.5) / 170.0 - 0.02) < 0.001);
}

void TestCombDrift::restAndReference_addUp()
{
    const DriftCurves asRest = curvesOf(withRest(130.0));
    const DriftCurves asBoth = curvesOf(withRest(30.0), {100.0, 100.0, 100.0});
    for (const double temperatureC : {-40.0, 0.0, 60.0})
        QCOMPARE(asBoth.rateDps[2](temperatureC), asRest.rateDps[2](temperatureC));
}

void TestCombDrift::packageTerm_isAddedAsItIs()
{
    CombDrift drift = withRest(-170.0);
    const DriftCurves without = curvesOf(drift);
    drift.axes[1].package = {0.3, 40.0, 10.0};
    const DriftCurves with = curvesOf(drift);
    for (const double temperatureC : {-40.0, 35.0, 85.0}) {
        const double term = with.rateDps[1](temperatureC) - without.rateDps[1](temperatureC);
        QVERIFY(std::abs(term - 0.3 * std::tanh((temperatureC - 40.0) / 10.0)) < 1e-12);
        QCOMPARE(with.rateDps[0](temperatureC), without.rateDps[0](temperatureC));
    }
}

void TestCombDrift::touchingCombs_areNotANumber()
{
    CombDrift drift = withRest(100.0);
    drift.axes[0].combs.geometry.overlapLengthUm = 100.0; // they touch before 85 C
    const DriftCurves curves = curvesOf(drift);
    const double touchC = CombCapacitor::create(drift.axes[0].combs)->contactTemperatureC(100.0 * 1e-5);
    QVERIFY(touchC > 25.0 && touchC < 85.0);
    QVERIFY(std::isfinite(curves.rateDps[0](touchC - 0.1)));
    QVERIFY(std::isnan(curves.rateDps[0](touchC + 0.1)));
    QVERIFY(std::isfinite(curves.rateDps[1](85.0)));
}

void TestCombDrift::badFigures_areRefusedInOneSentence_data()
{
    using Change = void (*)(CombDrift &);
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *says, Change change) { QTest::newRow(says) << change << QString(says); };
    row("displacement of the combs by one dps is 0 µm",
        [](CombDrift &drift) { drift.displacementPerDpsUm = 0.0; });
    row("width of the package term on y is -1 °C",
        [](CombDrift &drift) { drift.axes[1].package.stepWidthC = -1.0; });
    row("comb drift on z is nan",
        [](CombDrift &drift) { drift.axes[2].restDps = std::numeric_limits<double>::quiet_NaN(); });
    row("gap", [](CombDrift &drift) { drift.axes[0].combs.geometry.gapUm = -2.0; });
}

void TestCombDrift::badFigures_areRefusedInOneSentence()
{
    using Change = void (*)(CombDrift &);
    QFETCH(Change, change);
    QFETCH(QString, says);
    CombDrift drift;
    change(drift);
    const auto curves = combDriftCurves(drift, Eigen::Vector3d::Zero());
    QVERIFY(!curves.ok());
    QCOMPARE(curves.error().code, Errc::InvalidOption);
    const QString message = QString::fromStdString(curves.error().message);
    QVERIFY2(message.contains(says), qPrintable(message));
    QVERIFY(message.endsWith('.') && !message.contains(". "));
}

QTEST_APPLESS_MAIN(TestCombDrift)
#include "tst_comb_drift.moc"
