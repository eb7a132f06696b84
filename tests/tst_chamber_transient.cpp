#include "engine/physics/chamber_transient.h"
#include "engine/physics/test_plan.h"

#include <QTest>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace driftbench;

class TestChamberTransient : public QObject
{
    Q_OBJECT

private slots:
    void slab_seriesAndImages_agree();
    void slab_atOnceAndAtTheWalls_isWhatWasSet();
    void slowestMode_paperChamber_is592s();
    void remaining_late_isTheSlowestMode();
    void remaining_finiteDifferences_convergeToIt();
    void settling_halfADegree_takesAbout35Minutes();
    void settling_accuracyBeyondTheStep_isNothing();
    void rampLag_isTheIntegralOfTheStepResponse();
    void temperature_twoSteps_isTheirSum();
    void centreLag_longRamp_reachesTheRampLag();
    void create_badDatasheet_isRefused();
};

namespace {

ChamberTransient paperChamber()
{
    return *ChamberTransient::create(*namedChamber("SET-Z-021"));
}

// Explicit differences in one octant of the unit cube, n cells from the wall to the plane of symmetry, at
// time F: the value at the centre and half-way between centre and walls in each direction.
struct OctantSolution
{
    double centre;
    double halfWay;
};

OctantSolution solveOctant(int n, double fourier)
{
    const int m = n + 2; // one more plane mirrors the one before the centre
    const double cell = 0.5 / n;
    const int steps = static_cast<int>(std::ceil(fourier / (cell * cell / 8.0)));
    const double r = fourier / steps / (cell * cell);
    const auto at = [m](int i, int j, int k) { return static_cast<std::size_t>((i * m + j) * m + k); };
    std::vector<double> now(static_cast<std::size_t>(m) * m * m, 0.0);
    for (int i = 1; i < m; ++i)
        for (int j = 1; j < m; ++j)
            for (int k = 1; k < m; ++k)
                now[at(i, j, k)] = 1.0;
    std::vector<double> next = now;
    for (int step = 0; step < steps; ++step) {
        for (int i = 1; i <= n; ++i) {
            for (int j = 1; j <= n; ++j) {
                for (int k = 1; k <= n; ++k) {
                    const double around = now[at(i - 1, j, k)] + now[at(i + 1, j, k)] + now[at(i, j - 1, k)] +
                                          now[at(i, j + 1, k)] + now[at(i, j, k - 1)] + now[at(i, j, k + 1)];
                    const double here = now[at(i, j, k)];
                    next[at(i, j, k)] = here + r * (around - 6.0 * here);
                }
            }
        }
        for (int j = 1; j <= n; ++j) {
            for (int k = 1; k <= n; ++k) {
                next[at(n + 1, j, k)] = next[at(n - 1, j, k)];
                next[at(j, n + 1, k)] = next[at(j, n - 1, k)];
                next[at(j, k, n + 1)] = next[at(j, k, n - 1)];
            }
        }
        now.swap(next);
    }
    return {now[at(n, n, n)], now[at(n / 2, n / 2, n / 2)]};
}

bool near(double value, double expected, double tolerance)
{
    return std::abs(value - expected) <= tolerance;
}

} // namespace

void TestChamberTransient::slab_seriesAndImages_agree()
{
    for (double fourier = 1e-3; fourier < 2.0; fourier *= 1.3) {
        for (double place = 0.01; place < 1.0; place += 0.049) {
            const double series = slabRemainingBySeries(place, fourier);
            QVERIFY(near(series, slabRemainingByImages(place, fourier), 2e-15));
            QVERIFY(near(series, slabRemaining(place, fourier), 2e-15));
        }
    }
}

void TestChamberTransient::slab_atOnceAndAtTheWalls_isWhatWasSet()
{
    QCOMPARE(slabRemaining(0.5, 0.0), 1.0);
    QCOMPARE(slabRemaining(0.5, 1e-9), 1.0);
    QCOMPARE(slabRemaining(0.0, 0.0), 0.0);
    QCOMPARE(slabRemaining(1.0, 0.3), 0.0);
    // Close to a wall nothing is known of the other one.
    QVERIFY(near(slabRemaining(0.01, 1e-5), std::erf(0.01 / (2.0 * std::sqrt(1e-5))), 1e-15));
}

void TestChamberTransient::slowestMode_paperChamber_is592s()
{
    QVERIFY(near(paperChamber().slowestModeS(), 592.0, 0.5));
    QVERIFY(near(paperChamber().diffusivityM2PerS(), 0.0267 / (1005.0 * 1.293), 1e-18));
}

void TestChamberTransient::remaining_late_isTheSlowestMode()
{
    const ChamberTransient chamber = paperChamber();
    const double tauS = chamber.slowestModeS();
    const double first = std::pow(4.0 / std::numbers::pi, 3);
    for (const double timeS : {3600.0, 7200.0, 36000.0}) {
        const double mode = first * std::exp(-timeS / tauS);
        QVERIFY(near(chamber.remainingAtCentre(timeS) / mode, 1.0, 1e-6));
        QVERIFY(near(chamber.remaining(timeS, {0.3, 0.3, 0.3}) / mode, 1.0, 1e-6));
        QVERIFY(near(chamber.remaining(timeS, {0.1, 0.3, 0.3}) / mode, 0.5, 1e-4));
    }
}

void TestChamberTransient::remaining_finiteDifferences_convergeToIt()
{
    const ChamberTransient chamber = paperChamber();
    constexpr double kFourier = 0.08;
    const double timeS = kFourier * 0.36 / chamber.diffusivityM2PerS();
    const double centre = chamber.remainingAtCentre(timeS);
    const double halfWay = chamber.remaining(timeS, {0.15, 0.15, 0.15});
    OctantSolution coarse = solveOctant(6, kFourier);
    for (const int n : {12, 24}) {
        const OctantSolution fine = solveOctant(n, kFourier);
        for (const auto [coarser, finer, truth] : {std::array{coarse.centre, fine.centre, centre},
                                                   std::array{coarse.halfWay, fine.halfWay, halfWay}}) {
            const double order = std::log2(std::abs(coarser - truth) / std::abs(finer - truth));
            QVERIFY2(near(order, 2.0, 0.15), qPrintable(QString::number(order)));
            // Richardson's extrapolation is two orders better.
            QVERIFY(near((4.0 * finer - coarser) / 3.0, truth, 0.1 * std::abs(finer - truth)));
        }
        coarse = fine;
    }
}

void TestChamberTransient::settling_halfADegree_takesAbout35Minutes()
{
    const ChamberTransient chamber = paperChamber();
    const double timeS = chamber.settlingTimeS(0.5, 0.03);
    QVERIFY(near(timeS / 60.0, 35.0, 0.5));
    QVERIFY(near(0.5 * chamber.remainingAtCentre(timeS), 0.03, 1e-9));
    QCOMPARE(chamber.settlingTimeS(-0.5, 0.03), timeS);
    QVERIFY(chamber.settlingTimeS(0.5, 0.499999) > 0.0);
}

void TestChamberTransient::settling_accuracyBeyondTheStep_isNothing()
{
    QCOMPARE(paperChamber().settlingTimeS(0.5, 0.5), 0.0);
    QCOMPARE(paperChamber().settlingTimeS(0.5, 2.0), 0.0);
}

void TestChamberTransient::rampLag_isTheIntegralOfTheStepResponse()
{
    const ChamberTransient chamber = paperChamber();
    constexpr double kStepS = 2.0;
    double sumS = 0.5 * kStepS; // trapezoids; all derivatives are 0 at both ends
    for (double timeS = kStepS; timeS < 40.0 * chamber.slowestModeS(); timeS += kStepS)
        sumS += kStepS * chamber.remainingAtCentre(timeS);
    QVERIFY(near(chamber.rampLagS() / sumS, 1.0, 1e-12));
}

void TestChamberTransient::temperature_twoSteps_isTheirSum()
{
    const ChamberTransient chamber = paperChamber();
    const auto profile = TemperatureProfile::build(
        "steps", 20.0, {HoldSegment{100.0}, RampSegment{30.0, 10.0, 500.0}, RampSegment{25.0, 5.0, 9000.0}});
    const Eigen::Vector3d place(0.1, 0.25, 0.4);
    QCOMPARE(chamber.temperatureC(*profile, 50.0, place), 20.0);
    for (const double timeS : {150.0, 599.0}) {
        const double expectedC = 30.0 - 10.0 * chamber.remaining(timeS - 100.0, place);
        QVERIFY(near(chamber.temperatureC(*profile, timeS, place), expectedC, 1e-12));
    }
    for (const double timeS : {601.0, 2000.0, 8000.0}) {
        const double expectedC = 25.0 - 10.0 * chamber.remaining(timeS - 100.0, place) +
                                 5.0 * chamber.remaining(timeS - 600.0, place);
        QVERIFY(near(chamber.temperatureC(*profile, timeS, place), expectedC, 1e-12));
    }
    QVERIFY(near(chamber.temperatureC(*profile, 1e9, place), 25.0, 1e-12));
}

// 0.5 C every 30 s: 1/60 C/s. The stair lies half a step above the ramp that it follows.
void TestChamberTransient::centreLag_longRamp_reachesTheRampLag()
{
    const ChamberTransient chamber = paperChamber();
    const auto plan = makeTestPlan(*namedSensor("L3GD20H"), *namedChamber("SET-Z-021"));
    const auto profile = plan->profile();
    constexpr double kRampEndsS = 9300.0;
    double meanC = 0.0;
    constexpr int kPlaces = 300;
    for (int i = 0; i < kPlaces; ++i)
        meanC += chamber.centreLagC(*profile, kRampEndsS - 30.0 * (i + 0.5) / kPlaces) / kPlaces;
    QVERIFY(near(meanC, chamber.rampLagS() / 60.0, 1e-3));
    QVERIFY(near(chamber.rampLagS() / 60.0, 16.4, 0.05));
    const auto outlook = stillAirOutlook(*plan);
    QVERIFY(outlook.ok());
    QVERIFY(near(outlook->rampLagC, chamber.rampLagS() / 60.0, 1e-12));
    // At the end of a period the stair is as far behind the ramp's end as the whole lag, less half a step.
    QVERIFY(near(outlook->lagAfterRampC, meanC, 0.26));
    QCOMPARE(outlook->lagAtEndC, chamber.centreLagC(*profile, 11100.0));
    QVERIFY(outlook->lagAtEndC > 0.5 && outlook->lagAtEndC < 2.0);
    QCOMPARE(outlook->settlingS, chamber.settlingTimeS(0.5, 0.03));
}

void TestChamberTransient::create_badDatasheet_isRefused()
{
    ChamberDatasheet chamber = *namedChamber("SET-Z-021");
    chamber.conductivityWPerMK = 0.0;
    const auto none = ChamberTransient::create(chamber);
    QVERIFY(!none.ok());
    QCOMPARE(none.error().code, Errc::InvalidOption);
}

QTEST_APPLESS_MAIN(TestChamberTransient)
#include "tst_chamber_transient.moc"
