#include "engine/base/text.h"
#include "engine/physics/comb_capacitor.h"
#include "engine/physics/tangent_series.h"
#include "tests/support/random_combs.h"

#include <QTest>

#include <limits>
#include <string>

using namespace driftbench;
using test::CombIntegrals;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array kDisplacementsUm{-0.7, -1e-7, 1e-9, 1e-3, 0.1, 1.0, 1.9};

CombCapacitor comb(const CombParameters &parameters = {})
{
    return *CombCapacitor::create(parameters);
}

// The combs of the design's example: 100 um long, so that they touch at 27.8 C above T0.
CombParameters longCombs()
{
    CombParameters parameters;
    parameters.geometry.overlapLengthUm = 100.0;
    return parameters;
}

double relativeDifference(double value, long double truth)
{
    return static_cast<double>(std::abs((value - truth) / truth));
}

struct Worst
{
    double capacitance = 0.0;
    double change = 0.0;
    double error = 0.0;

    void add(const CombCapacitor &comb, double deltaTC, double displacementUm)
    {
        const CombIntegrals truth(comb.parameters(), deltaTC);
        capacitance = std::max(capacitance, relativeDifference(*comb.capacitanceFf(deltaTC, displacementUm),
                                                               truth.capacitanceFf(displacementUm)));
        change = std::max(change, relativeDifference(*comb.changeFf(deltaTC, displacementUm),
                                                     truth.changeFf(displacementUm)));
        if (deltaTC != 0.0)
            error = std::max(error, relativeDifference(*comb.errorFf(deltaTC, displacementUm),
                                                       truth.errorFf(displacementUm)));
    }
    double all() const { return std::max({capacitance, change, error}); }
    QByteArray text() const
    {
        return QByteArray("C' ") + QByteArray::number(capacitance) + ", dC' " + QByteArray::number(change) +
               ", dE " + QByteArray::number(error);
    }
};

} // namespace

class TestCombCapacitor : public QObject
{
    Q_OBJECT

private slots:
    void create_badParameter_saysWhichInOneSentence_data();
    void create_badParameter_saysWhichInOneSentence();
    void tangentSeries_overItsCircle_isItsClosedFormAndItsSlope();
    void closedForm_paperCombs_isTheQuadrature();
    void closedForm_randomCombs_isTheQuadrature();
    void closedForm_closeToContact_losesOnlyWhatTheGapLoses();
    void closedForm_aroundStraight_joinsSmoothly();
    void errorFf_tinyTemperatureAndDisplacement_keepsItsDigits();
    void errorFf_atStraight_isZero();
    void changeFf_atStraight_isEq4();
    void geometry_paperCombs_followsEqs5To9();
    void contact_longCombs_isNamedToTheNanodegree();
    void contact_displacedOrOpened_touchesAtTheNarrowestState();
    void contact_bisected_isWhereCapacitanceEnds();
    void value_outsideItsRange_isRefusedInOneSentence_data();
    void value_outsideItsRange_isRefusedInOneSentence();
    void asPrinted_lastLineOfEq10_isHalfTheIntegralAboveIt();
    void asPrinted_notWarmer_hasNoValue();
};

void TestCombCapacitor::create_badParameter_saysWhichInOneSentence_data()
{
    QTest::addColumn<int>("which");
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("named");
    QTest::newRow("a0 negative") << 0 << -4.0 << "thickness a0 is -4 µm";
    QTest::newRow("a0 not a number") << 0 << kNan << "thickness a0";
    QTest::newRow("b0 zero") << 1 << 0.0 << "length b0 is 0 µm";
    QTest::newRow("c0 negative") << 2 << -30.0 << "width c0 is -30 µm";
    QTest::newRow("c0 infinite") << 2 << std::numeric_limits<double>::infinity() << "width c0";
    QTest::newRow("d0 negative") << 3 << -2.0 << "gap d0 is -2 µm";
    QTest::newRow("n zero") << 4 << 0.0 << "number of gaps is 0";
    QTest::newRow("permittivity zero") << 5 << 0.0 << "permittivity is 0";
    QTest::newRow("alpha not a number") << 6 << kNan << "expansion coefficient";
    QTest::newRow("E negative") << 7 << -175.0 << "elastic modulus is -175 GPa";
    QTest::newRow("nu too large") << 8 << 0.6 << "Poisson ratio is 0.6";
    QTest::newRow("nu too small") << 8 << -1.1 << "Poisson ratio is -1.1";
    QTest::newRow("T0 too cold") << 9 << -274.0 << "straight is -274 °C";
}

void TestCombCapacitor::create_badParameter_saysWhichInOneSentence()
{
    QFETCH(int, which);
    QFETCH(double, value);
    QFETCH(QString, named);
    CombParameters bad;
    if (which == 4) {
        bad.geometry.gapCount = static_cast<int>(value);
    } else {
        const std::array<double *, 10> places{&bad.geometry.thicknessUm,
                                              &bad.geometry.overlapLengthUm,
                                              &bad.geometry.overlapWidthUm,
                                              &bad.geometry.gapUm,
                                              nullptr,
                                              &bad.geometry.relativePermittivity,
                                              &bad.material.expansionPerC,
                                              &bad.material.elasticModulusGPa,
                                              &bad.material.poissonRatio,
                                              &bad.straightAtC};
        *places[static_cast<std::size_t>(which)] = value;
    }
    const auto comb = CombCapacitor::create(bad);
    QVERIFY(!comb.ok());
    QCOMPARE(comb.error().code, Errc::InvalidOption);
    const QString message = QString::fromStdString(comb.error().message);
    QVERIFY2(message.contains(named), qPrintable(message));
    QVERIFY(message.endsWith('.') && message.count(". ") == 0);
}

void TestCombCapacitor::tangentSeries_overItsCircle_isItsClosedFormAndItsSlope()
{
    for (int i = -999; i <= 999; ++i) {
        const long double z = i / 1000.0L;
        const long double root = std::sqrt(std::abs(z));
        const long double first = i == 0 ? 1.0L : i < 0 ? std::atan(root) / root : std::atanh(root) / root;
        const double at = static_cast<double>(z);
        QVERIFY(relativeDifference(tangentSeries(1, at), first) < 2e-15 / (1.0 - at));
        if (i == 0)
            continue;
        const long double third = (first - 1) / z;
        const double thirdDigits = 5e-15 / (1.0 - at) + 1e-18 / std::abs(at);
        QVERIFY(relativeDifference(tangentSeries(3, at), third) < thirdDigits);
        const long double slope = (1 / (1 - z) - first) / (2 * z);
        QVERIFY(relativeDifference(tangentSeriesSlope(1, at), slope) <
                5e-15 / (1.0 - at) + 1e-18 / std::abs(at));
        const long double thirdSlope = (1 / (1 - z) - 3 * third) / (2 * z);
        QVERIFY(relativeDifference(tangentSeriesSlope(3, at), thirdSlope) <
                5e-14 / (1.0 - at) + 1e-18 / (at * at));
    }
}

void TestCombCapacitor::closedForm_paperCombs_isTheQuadrature()
{
    const CombCapacitor paper = comb();
    Worst worst;
    for (int deltaTC = -125; deltaTC <= 125; ++deltaTC) {
        for (const double displacementUm : kDisplacementsUm) {
            QVERIFY(CombIntegrals(paper.parameters(), deltaTC).clearance(displacementUm) > 0.0L);
            worst.add(paper, deltaTC, displacementUm);
        }
    }
    qInfo() << "largest relative difference" << worst.text();
    QVERIFY2(worst.all() < 1e-12, worst.text());
}

void TestCombCapacitor::closedForm_randomCombs_isTheQuadrature()
{
    constexpr std::uint64_t kSeed = 20260214;
    Random random(kSeed);
    Worst worst;
    int compared = 0;
    int touching = 0;
    for (int i = 0; i < 400; ++i) {
        const CombCapacitor each = comb(test::randomComb(random));
        for (int k = 0; k < 10; ++k) {
            const double deltaTC = -125.0 + 250.0 * random.uniform();
            const double displacementUm = each.parameters().geometry.gapUm * (1.8 * random.uniform() - 0.9);
            const long double clearance = CombIntegrals(each.parameters(), deltaTC).clearance(displacementUm);
            QCOMPARE(each.errorFf(deltaTC, displacementUm).ok(), clearance > 0.0L);
            if (clearance <= 0.0L)
                ++touching;
            if (clearance < 1e-3L)
                continue;
            worst.add(each, deltaTC, displacementUm);
            ++compared;
        }
    }
    qInfo() << "seed" << kSeed << compared << "states," << touching << "in contact, largest" << worst.text();
    QVERIFY(compared > 2000 && touching > 100);
    QVERIFY2(worst.all() < 1e-12, worst.text());
}

// The gap that is left is a difference of two lengths: at a clearance of e it has lost a factor 1/e of its
// digits before any formula starts.
void TestCombCapacitor::closedForm_closeToContact_losesOnlyWhatTheGapLoses()
{
    const CombCapacitor combs = comb(longCombs());
    for (const double displacementUm : {-0.5, 1e-6, 0.3}) {
        const double contactDeltaC = combs.contactTemperatureC(std::max(displacementUm, 0.0)) - 25.0;
        for (const double clearance : {1e-2, 1e-4, 1e-6, 1e-8}) {
            Worst worst;
            worst.add(combs, contactDeltaC * (1.0 - clearance), displacementUm);
            QVERIFY2(worst.all() < 1e-15 / clearance, worst.text());
        }
    }
}

void TestCombCapacitor::closedForm_aroundStraight_joinsSmoothly()
{
    const CombCapacitor combs = comb(longCombs());
    constexpr double kDisplacementUm = 0.2;
    const double before = *combs.capacitanceFf(0.0, kDisplacementUm);
    for (const double step : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const double cold = *combs.capacitanceFf(-step, kDisplacementUm);
        const double warm = *combs.capacitanceFf(step, kDisplacementUm);
        QVERIFY(std::abs(cold + warm - 2.0 * before) <= 1e-15 * before + before * step * step);
        const double errorCold = *combs.errorFf(-step, kDisplacementUm);
        const double errorWarm = *combs.errorFf(step, kDisplacementUm);
        QVERIFY(errorCold < 0.0 && errorWarm > 0.0);
        QVERIFY(std::abs(errorWarm + errorCold) <= 0.2 * step * errorWarm + 1e-15 * errorWarm);
    }
}

void TestCombCapacitor::errorFf_tinyTemperatureAndDisplacement_keepsItsDigits()
{
    Worst worst;
    for (const CombParameters &parameters : {CombParameters{}, longCombs()}) {
        const CombCapacitor each = comb(parameters);
        for (const double deltaTC : {-1e-3, -1e-7, -1e-12, 1e-12, 1e-7, 1e-3, 0.1}) {
            for (const double displacementUm : {-1e-12, 1e-12, 1e-6, 0.5})
                worst.add(each, deltaTC, displacementUm);
        }
    }
    QVERIFY2(worst.all() < 1e-14, worst.text());
}

void TestCombCapacitor::errorFf_atStraight_isZero()
{
    QCOMPARE(*comb().errorFf(0.0, 0.5), 0.0);
    QCOMPARE(*comb().errorFf(50.0, 0.0), 0.0);
}

void TestCombCapacitor::changeFf_atStraight_isEq4()
{
    // Eq. (4) by hand: 100 gaps of 8.854 aF/um x 8 um x 30 um at 2 um, and at 1.5 um.
    const double scaleFf = 100 * 8.8541878188e-3 * 8.0 * 30.0;
    const CombCapacitor paper = comb();
    QVERIFY(relativeDifference(*paper.capacitanceFf(0.0, 0.0), scaleFf / 2.0) < 1e-15);
    QVERIFY(relativeDifference(*paper.changeFf(0.0, 0.5), scaleFf / 1.5 - scaleFf / 2.0) < 2e-15);
    QVERIFY(relativeDifference(*paper.restChangeFf(0.5), scaleFf / 1.5 - scaleFf / 2.0) < 2e-15);
}

void TestCombCapacitor::geometry_paperCombs_followsEqs5To9()
{
    const CombCapacitor paper = comb();
    // M = alpha E b0 a0^2 dT / 8 = 2.4e-6 x 175e9 Pa x 8e-6 m x 16e-12 m^2 x 100 / 8
    QVERIFY(relativeDifference(paper.bendingMomentNm(100.0), 2.4e-6L * 175e9L * 8e-6L * 16e-12L * 100 / 8) <
            1e-15);
    QCOMPARE(paper.overlapLengthUm(100.0), 8.0 * 1.00048);
    QCOMPARE(paper.overlapWidthUm(-100.0), 30.0 * 0.99952);
    // K = 12 x 2.4e-6 x 100 / 4 = 7.2e-4 per um
    QCOMPARE(paper.thicknessUm(100.0, 8.0), 4.0 + 7.2e-4 * 64.0);
    QCOMPARE(paper.gapUm(100.0, 0.0), 2.0 - 7.2e-4 * 64.0);
    QCOMPARE(paper.gapUm(100.0, 8.0), 2.0 - 7.2e-4 * 64.0);
    QCOMPARE(paper.gapUm(100.0, 4.0), 2.0 - 7.2e-4 * 32.0);
    // Two combs face each other, one reversed: what both gain in thickness, the gap loses.
    for (const double x : {0.0, 1.5, 4.0, 7.0}) {
        const double gained = paper.thicknessUm(60.0, x) + paper.thicknessUm(60.0, 8.0 - x) - 8.0;
        QVERIFY(std::abs(2.0 - paper.gapUm(60.0, x) - gained) < 1e-14);
    }
}

void TestCombCapacitor::contact_longCombs_isNamedToTheNanodegree()
{
    const CombCapacitor combs = comb(longCombs());
    // D = kappa b0^2 / 2: dT = 2 x 4 / (12 x 2.4e-6 x 100^2) = 27.777... C
    const double contactC = 25.0 + 250.0 / 9.0;
    QVERIFY(std::abs(combs.contactTemperatureC(0.0) - contactC) < 1e-9);
    QVERIFY(combs.gapUm(250.0 / 9.0, 0.0) < 1e-14 && combs.gapUm(250.0 / 9.0, 50.0) > 0.9);
    const auto touching = combs.capacitanceFf(60.0, 0.0);
    QVERIFY(!touching.ok());
    QCOMPARE(touching.error().code, Errc::InvalidOption);
    const std::string message = touching.error().message;
    const std::string before = "touch at ";
    const auto start = message.find(before) + before.size();
    const auto named = parseNumber(message.substr(start, message.find(' ', start) - start));
    QVERIFY(named.has_value());
    QVERIFY(std::abs(*named - contactC) < 1e-9);
}

void TestCombCapacitor::contact_displacedOrOpened_touchesAtTheNarrowestState()
{
    const CombCapacitor combs = comb(longCombs());
    QVERIFY(std::abs(combs.contactTemperatureC(1.0) - (25.0 + 125.0 / 9.0)) < 1e-9);
    QVERIFY(combs.capacitanceFf(20.0, 0.0).ok());
    QVERIFY(!combs.changeFf(20.0, 1.0).ok());
    // Opened by 1 um the combs clear each other at 30 C above T0, yet at rest they touch.
    QVERIFY(combs.capacitanceFf(30.0, -1.0).ok());
    QVERIFY(!combs.changeFf(30.0, -1.0).ok());

    CombParameters shrinking = longCombs();
    shrinking.material.expansionPerC = -2.4e-6;
    QVERIFY(comb(shrinking).capacitanceFf(100.0, 0.0).ok());
    QVERIFY(!comb(shrinking).capacitanceFf(-30.0, 0.0).ok());
    CombParameters rigid = longCombs();
    rigid.material.expansionPerC = 0.0;
    QVERIFY(std::isinf(comb(rigid).contactTemperatureC(0.0)));
    QCOMPARE(*comb(rigid).errorFf(1000.0, 0.5), 0.0);
}

void TestCombCapacitor::contact_bisected_isWhereCapacitanceEnds()
{
    constexpr std::uint64_t kSeed = 77;
    Random random(kSeed);
    for (int i = 0; i < 50; ++i) {
        const CombCapacitor each = comb(test::randomComb(random));
        const double displacementUm = each.parameters().geometry.gapUm * 0.9 * random.uniform();
        double free = 0.0;
        double touching = 2.0 * (each.contactTemperatureC(displacementUm) - each.parameters().straightAtC);
        for (int step = 0; step < 200; ++step) {
            const double middle = (free + touching) / 2.0;
            (each.capacitanceFf(middle, displacementUm).ok() ? free : touching) = middle;
        }
        const double contactC = each.contactTemperatureC(displacementUm);
        QVERIFY2(std::abs(each.parameters().straightAtC + touching - contactC) <=
                     1e-9 * std::max(1.0, std::abs(contactC) / 100.0),
                 qPrintable(QString("seed %1 comb %2").arg(kSeed).arg(i)));
    }
}

void TestCombCapacitor::value_outsideItsRange_isRefusedInOneSentence_data()
{
    QTest::addColumn<double>("deltaTC");
    QTest::addColumn<double>("displacementUm");
    QTest::addColumn<QString>("named");
    QTest::newRow("below absolute zero") << -300.0 << 0.1 << "absolute zero";
    QTest::newRow("temperature not a number") << kNan << 0.1 << "absolute zero";
    QTest::newRow("displacement closes the gap") << 0.0 << 2.0 << "less than the gap of 2 µm";
    QTest::newRow("displacement not a number") << 0.0 << kNan << "less than the gap";
    QTest::newRow("combs touch") << 60.0 << 0.0 << "52.77777";
}

void TestCombCapacitor::value_outsideItsRange_isRefusedInOneSentence()
{
    QFETCH(double, deltaTC);
    QFETCH(double, displacementUm);
    QFETCH(QString, named);
    const CombCapacitor combs = comb(longCombs());
    for (const auto &value :
         {combs.capacitanceFf(deltaTC, displacementUm), combs.changeFf(deltaTC, displacementUm),
          combs.errorFf(deltaTC, displacementUm)}) {
        QVERIFY(!value.ok());
        QCOMPARE(value.error().code, Errc::InvalidOption);
        const QString message = QString::fromStdString(value.error().message);
        QVERIFY2(message.contains(named), qPrintable(message));
        QVERIFY(message.endsWith('.') && message.count(". ") == 0);
    }
}

// Eq. (10) goes on from an integral to its closed form. The integral is taken by quadrature, with everything
// that is printed in front of it; the closed form is half of that, at every geometry and temperature.
void TestCombCapacitor::asPrinted_lastLineOfEq10_isHalfTheIntegralAboveIt()
{
    constexpr std::uint64_t kSeed = 5;
    Random random(kSeed);
    int compared = 0;
    for (int i = 0; i < 200; ++i) {
        const CombCapacitor each = comb(test::randomComb(random));
        const double deltaTC = 10.0 + 115.0 * random.uniform();
        const double displacementUm = each.parameters().geometry.gapUm * (0.1 + 0.8 * random.uniform());
        const CombIntegrals integrals(each.parameters(), deltaTC);
        if (integrals.clearance(displacementUm) < 0.01L)
            continue;
        ++compared;
        const long double line = integrals.b0 * integrals.changeFf(displacementUm);
        const double printed = *each.changeFf(deltaTC, displacementUm, CombFormula::AsPrinted);
        QVERIFY2(std::abs(static_cast<double>(printed / line) - 0.5) < 1e-11,
                 qPrintable(QString("seed %1 comb %2").arg(kSeed).arg(i)));
        const double error = *each.errorFf(deltaTC, displacementUm, CombFormula::AsPrinted);
        QCOMPARE(error, printed - *each.restChangeFf(displacementUm));
    }
    QVERIFY(compared > 50);
}

void TestCombCapacitor::asPrinted_notWarmer_hasNoValue()
{
    for (const double deltaTC : {0.0, -1.0}) {
        for (const auto &value : {comb().changeFf(deltaTC, 0.5, CombFormula::AsPrinted),
                                  comb().errorFf(deltaTC, 0.5, CombFormula::AsPrinted)}) {
            QVERIFY(!value.ok());
            QVERIFY(value.error().message.find("Eq. (10)") != std::string::npos);
        }
    }
}

QTEST_APPLESS_MAIN(TestCombCapacitor)
#include "tst_comb_capacitor.moc"
