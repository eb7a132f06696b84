#include "engine/physics/comb_sensitivities.h"
#include "engine/physics/comb_sweep.h"
#include "tests/support/random_combs.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace driftbench;
using test::CombIntegrals;

namespace {

struct State
{
    CombParameters comb;
    double displacementUm;
    double deltaTC;
};

// The parameter of a state that a row of the table stands for; null for those that dE does not know.
double *placeOf(State &state, std::size_t row)
{
    CombGeometry &geometry = state.comb.geometry;
    const std::array<double *, kCombSensitivityCount> places{&state.comb.material.expansionPerC,
                                                             nullptr,
                                                             nullptr,
                                                             &geometry.thicknessUm,
                                                             &geometry.overlapLengthUm,
                                                             &geometry.overlapWidthUm,
                                                             &geometry.gapUm,
                                                             &geometry.relativePermittivity,
                                                             &state.displacementUm,
                                                             &state.deltaTC};
    return places[row];
}

// The slope of the integral by differences of fourth order.
long double slopeByDifferences(const State &state, std::size_t row)
{
    State moved = state;
    double *place = placeOf(moved, row);
    const double at = *place;
    const double step = 1e-4 * at;
    const auto error = [&](int steps) {
        *place = at + steps * step;
        return CombIntegrals(moved.comb, moved.deltaTC).errorFf(moved.displacementUm);
    };
    return (8 * (error(1) - error(-1)) - (error(2) - error(-2))) / (12 * static_cast<long double>(step));
}

CombCapacitor comb(const CombParameters &parameters = {})
{
    return *CombCapacitor::create(parameters);
}

} // namespace

class TestCombSensitivities : public QObject
{
    Q_OBJECT

private slots:
    void combSensitivities_randomCombs_areTheSlopesOfTheIntegral();
    void combSensitivities_lengthsScaledTogether_followDimensions();
    void combSensitivities_modulusAndPoisson_areZero();
    void combSensitivities_aroundStraight_areFinite();
    void combSensitivities_contact_isTheErrorOfTheComb();
    void scaleFactor_atStraight_isTheSlopeOfEq4();
    void scaleFactor_badTransducer_isRefused();
    void sweepComb_range_hasItsEnds();
    void sweepComb_intoContact_endsThere();
    void sweepComb_badRange_saysWhichInOneSentence_data();
    void sweepComb_badRange_saysWhichInOneSentence();
};

void TestCombSensitivities::combSensitivities_randomCombs_areTheSlopesOfTheIntegral()
{
    constexpr std::uint64_t kSeed = 31;
    Random random(kSeed);
    double worst = 0.0;
    int compared = 0;
    for (int i = 0; i < 300; ++i) {
        State state{test::randomComb(random), 0.0, random.uniform(-125.0, 125.0)};
        state.displacementUm = state.comb.geometry.gapUm * random.uniform(-0.8, 0.8);
        if (CombIntegrals(state.comb, state.deltaTC).clearance(state.displacementUm) < 0.2L)
            continue;
        const auto all = combSensitivities(comb(state.comb), state.deltaTC, state.displacementUm);
        QVERIFY(all.ok());
        const auto error = CombIntegrals(state.comb, state.deltaTC).errorFf(state.displacementUm);
        for (std::size_t row = 0; row < kCombSensitivityCount; ++row) {
            if (placeOf(state, row) == nullptr)
                continue;
            const CombSensitivity &each = (*all)[row];
            QCOMPARE(each.value, *placeOf(state, row));
            const long double slope = slopeByDifferences(state, row);
            // In percent of dE per percent, as a slope may pass through zero.
            const auto difference =
                static_cast<double>(std::abs((each.slopeFfPerUnit - slope) * each.value / error));
            worst = std::max(worst, difference / std::max(1.0, std::abs(each.relative)));
            const auto relative = static_cast<double>(slope * each.value / error);
            QVERIFY(std::abs(each.relative - relative) <= 1e-8 * std::max(1.0, std::abs(relative)));
            ++compared;
        }
    }
    qInfo() << "seed" << kSeed << compared << "slopes, largest difference" << worst;
    QVERIFY(compared > 800);
    QVERIFY(worst < 1e-9);
}

// Euler: dE is a capacitance, permittivity times length, and a ratio of lengths for the rest. With all
// lengths scaled by one factor it scales by that factor.
void TestCombSensitivities::combSensitivities_lengthsScaledTogether_followDimensions()
{
    for (const double deltaTC : {-60.0, 0.01, 60.0}) {
        const auto all = *combSensitivities(comb(), deltaTC, 0.4);
        double lengths = 0.0;
        for (const CombSensitivity &each : all)
            lengths += each.unit == "µm" ? each.relative : 0.0;
        QVERIFY(std::abs(lengths - 1.0) < 1e-12);
        // Expansion and temperature difference stand together everywhere.
        QVERIFY(std::abs(all[0].relative - all[9].relative) < 1e-12);
        QVERIFY(std::abs(all[5].relative - 1.0) < 1e-14);
        QVERIFY(std::abs(all[7].relative - 1.0) < 1e-14);
    }
}

void TestCombSensitivities::combSensitivities_modulusAndPoisson_areZero()
{
    const auto all = *combSensitivities(comb(), 50.0, 0.4);
    QCOMPARE(all[1].name, std::string_view("elastic modulus"));
    QCOMPARE(all[1].slopeFfPerUnit, 0.0);
    QCOMPARE(all[2].slopeFfPerUnit, 0.0);
    CombParameters stiff;
    stiff.material.elasticModulusGPa = 1.0;
    stiff.material.poissonRatio = 0.4;
    QCOMPARE(*comb(stiff).errorFf(50.0, 0.4), *comb().errorFf(50.0, 0.4));
}

void TestCombSensitivities::combSensitivities_aroundStraight_areFinite()
{
    const auto straight = *combSensitivities(comb(), 0.0, 0.4);
    const auto warm = *combSensitivities(comb(), 1e-9, 0.4);
    QVERIFY(std::isnan(straight[0].relative));
    QCOMPARE(straight[0].slopeFfPerUnit, 0.0);
    QVERIFY(std::abs(straight[9].slopeFfPerUnit / warm[9].slopeFfPerUnit - 1.0) < 1e-9);
    QVERIFY(std::abs(warm[9].relative - 1.0) < 1e-9);
}

void TestCombSensitivities::combSensitivities_contact_isTheErrorOfTheComb()
{
    CombParameters longCombs;
    longCombs.geometry.overlapLengthUm = 100.0;
    const auto all = combSensitivities(comb(longCombs), 60.0, 0.0);
    QVERIFY(!all.ok());
    QVERIFY(all.error().message.find("touch") != std::string::npos);
}

void TestCombSensitivities::scaleFactor_atStraight_isTheSlopeOfEq4()
{
    const CombTransducer transducer{2e-3, 0.3};
    const double scale = *scaleFactorFfPerDps(comb(), transducer);
    // n eps b0 c0 k / (d0 - r)^2
    QVERIFY(std::abs(scale / (100 * 8.8541878188e-3 * 240.0 * 2e-3 / (1.7 * 1.7)) - 1.0) < 1e-14);
    const double slope = (*comb().restChangeFf(0.3 + 1e-6) - *comb().restChangeFf(0.3 - 1e-6)) / 2e-6 * 2e-3;
    QVERIFY(std::abs(scale / slope - 1.0) < 1e-8);
    QCOMPARE(equivalentRateDps(3.0 * scale, scale), 3.0);
}

void TestCombSensitivities::scaleFactor_badTransducer_isRefused()
{
    QVERIFY(!scaleFactorFfPerDps(comb(), {0.0, 0.1}).ok());
    QVERIFY(!scaleFactorFfPerDps(comb(), {std::nan(""), 0.1}).ok());
    QVERIFY(!scaleFactorFfPerDps(comb(), {1e-3, 2.0}).ok());
}

void TestCombSensitivities::sweepComb_range_hasItsEnds()
{
    const auto sweep = sweepComb(comb(), {}, {-40.0, 85.0, 10.0});
    QVERIFY(sweep.ok());
    QCOMPARE(sweep->rows.size(), std::size_t{14});
    QCOMPARE(sweep->rows.front().temperatureC, -40.0);
    QCOMPARE(sweep->rows[12].temperatureC, 80.0);
    QCOMPARE(sweep->rows.back().temperatureC, 85.0);
    QVERIFY(!sweep->endsAtContact);
    for (const CombRow &row : sweep->rows) {
        QCOMPARE(row.deltaTC, row.temperatureC - 25.0);
        QCOMPARE(row.rateDps, row.errorFf / sweep->scaleFactorFfPerDps);
        QCOMPARE(row.printedChangeFfUm.has_value(), row.deltaTC > 0.0);
        QVERIFY(std::abs(row.changeFf - row.restChangeFf - row.errorFf) < 1e-14 * row.changeFf);
    }
    QCOMPARE(sweepComb(comb(), {}, {0.0, 0.3, 0.1})->rows.size(), std::size_t{4});
}

void TestCombSensitivities::sweepComb_intoContact_endsThere()
{
    CombParameters longCombs;
    longCombs.geometry.overlapLengthUm = 100.0;
    const auto sweep = sweepComb(comb(longCombs), {1e-3, 0.2}, {-40.0, 85.0, 1.0});
    QVERIFY(sweep.ok());
    QVERIFY(sweep->endsAtContact);
    QVERIFY(std::abs(sweep->contactC - 50.0) < 1e-9); // 25 + 1.8 x 4 / (12 x 2.4e-6 x 100^2)
    QCOMPARE(sweep->rows.back().temperatureC, 49.0);
    QVERIFY(!sweepComb(comb(longCombs), {1e-3, 0.2}, {60.0, 85.0, 1.0}).ok());
}

void TestCombSensitivities::sweepComb_badRange_saysWhichInOneSentence_data()
{
    QTest::addColumn<double>("lowestC");
    QTest::addColumn<double>("highestC");
    QTest::addColumn<double>("stepC");
    QTest::addColumn<QString>("named");
    QTest::newRow("turned round") << 85.0 << -40.0 << 1.0 << "from 85 to -40";
    QTest::newRow("not a number") << double(NAN) << 85.0 << 1.0 << "range of temperature";
    QTest::newRow("no step") << -40.0 << 85.0 << 0.0 << "step of temperature is 0";
    QTest::newRow("endless") << -40.0 << 85.0 << 1e-9 << "more than 100000 rows";
    QTest::newRow("below absolute zero") << -300.0 << 85.0 << 1.0 << "absolute zero";
}

void TestCombSensitivities::sweepComb_badRange_saysWhichInOneSentence()
{
    QFETCH(double, lowestC);
    QFETCH(double, highestC);
    QFETCH(double, stepC);
    QFETCH(QString, named);
    const auto sweep = sweepComb(comb(), {}, {lowestC, highestC, stepC});
    QVERIFY(!sweep.ok());
    QCOMPARE(sweep.error().code, Errc::InvalidOption);
    const QString message = QString::fromStdString(sweep.error().message);
    QVERIFY2(message.contains(named) && message.endsWith('.'), qPrintable(message));
}

QTEST_APPLESS_MAIN(TestCombSensitivities)
#include "tst_comb_sensitivities.moc"
