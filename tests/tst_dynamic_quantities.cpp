// Against closed forms: ramps, a parabola and exponentials.
#include "engine/features/dynamic_quantities.h"

#include <QTest>

#include <cmath>

using namespace driftbench;

class TestDynamicQuantities : public QObject
{
    Q_OBJECT

private slots:
    void rate_ofARamp_isItsSlope();
    void rate_ofAParabola_isItsDerivativeInside();
    void rate_doesNotReachAcrossAGap();
    void lag_ofARamp_isTheClosedForm();
    void lag_afterAStep_decaysExponentially();
    void lag_isIndependentOfTheSampling();
    void lag_startsAnewAfterAGap();
};

static Eigen::VectorXd times(Eigen::Index size, double intervalS)
{
    return Eigen::VectorXd::LinSpaced(size, 0.0, intervalS * static_cast<double>(size - 1));
}

void TestDynamicQuantities::rate_ofARamp_isItsSlope()
{
    const Eigen::VectorXd timeS = times(1000, 0.1).array() + 5.0e5;
    const Eigen::VectorXd temperatureC = -40.0 + 0.0167 * (timeS.array() - 5.0e5);
    const Eigen::VectorXd rate = temperatureRate(timeS, temperatureC, 10.0);
    QVERIFY((rate.array() - 0.0167).abs().maxCoeff() < 1e-7);
}

void TestDynamicQuantities::rate_ofAParabola_isItsDerivativeInside()
{
    const Eigen::VectorXd timeS = times(1001, 0.5);
    const Eigen::VectorXd temperatureC = 0.001 * timeS.array().square();
    const Eigen::VectorXd rate = temperatureRate(timeS, temperatureC, 20.0);
    for (Eigen::Index i = 25; i < 976; ++i)
        QVERIFY(std::abs(rate[i] - 0.002 * timeS[i]) < 1e-9);
}

void TestDynamicQuantities::rate_doesNotReachAcrossAGap()
{
    Eigen::VectorXd timeS = times(400, 1.0);
    timeS.tail(200).array() += 8.0;
    Eigen::VectorXd temperatureC = 0.02 * timeS;
    temperatureC.tail(200) = (30.0 - 0.03 * (timeS.tail(200).array() - timeS[200])).matrix();
    const Eigen::VectorXd rate = temperatureRate(timeS, temperatureC, 60.0);
    QVERIFY((rate.head(200).array() - 0.02).abs().maxCoeff() < 1e-10);
    QVERIFY((rate.tail(200).array() + 0.03).abs().maxCoeff() < 1e-10);
}

// T = r t: lag = r tau (1 - exp(-t / tau)).
void TestDynamicQuantities::lag_ofARamp_isTheClosedForm()
{
    constexpr double kSlope = 0.05;
    constexpr double kTau = 300.0;
    const Eigen::VectorXd timeS = times(3000, 1.0);
    const Eigen::VectorXd lag = temperatureLag(timeS, 20.0 + (kSlope * timeS).array(), kTau);
    for (Eigen::Index i = 0; i < timeS.size(); ++i)
        QVERIFY(std::abs(lag[i] - kSlope * kTau * (1.0 - std::exp(-timeS[i] / kTau))) < 1e-9);
}

// A step of 10 degrees between two samples h apart leaves 10 tau / h (1 - exp(-h / tau)), then decays.
void TestDynamicQuantities::lag_afterAStep_decaysExponentially()
{
    constexpr double kTau = 50.0;
    const Eigen::VectorXd timeS = times(400, 1.0);
    Eigen::VectorXd temperatureC = Eigen::VectorXd::Constant(400, 20.0);
    temperatureC.tail(300).setConstant(30.0);
    const Eigen::VectorXd lag = temperatureLag(timeS, temperatureC, kTau);
    const double atStep = 10.0 * kTau * (1.0 - std::exp(-1.0 / kTau));
    QCOMPARE(lag[99], 0.0);
    for (Eigen::Index i = 100; i < 400; ++i)
        QVERIFY(std::abs(lag[i] - atStep * std::exp(-(timeS[i] - 100.0) / kTau)) < 1e-9);
}

void TestDynamicQuantities::lag_isIndependentOfTheSampling()
{
    const auto lastLag = [](double intervalS) {
        const auto size = static_cast<Eigen::Index>(std::lround(600.0 / intervalS)) + 1;
        const Eigen::VectorXd timeS = times(size, intervalS);
        return temperatureLag(timeS, 0.02 * timeS, 120.0)[size - 1];
    };
    QVERIFY(std::abs(lastLag(0.1) - lastLag(7.5)) < 1e-9);
}

void TestDynamicQuantities::lag_startsAnewAfterAGap()
{
    Eigen::VectorXd timeS = times(200, 1.0);
    timeS.tail(100).array() += 1000.0;
    const Eigen::VectorXd lag = temperatureLag(timeS, 0.1 * timeS, 30.0);
    QVERIFY(lag[99] > 2.0);
    QCOMPARE(lag[100], 0.0);
    QVERIFY(std::abs(lag[110] - 3.0 * (1.0 - std::exp(-10.0 / 30.0))) < 1e-9);
}

QTEST_APPLESS_MAIN(TestDynamicQuantities)
#include "tst_dynamic_quantities.moc"
