// Holds of the temperature, found while it comes.
#include "engine/base/random.h"
#include "engine/physics/temperature_profile.h"
#include "engine/recording/hold_detector.h"

#include <QTest>

#include <cmath>

using namespace driftbench;

namespace {

constexpr std::uint64_t kSeed = 31;

// T at 10 Hz over a profile, followed with a lag of 20 s, thermometer noise of 0.03 degrees, in blocks of odd
// sizes as a source delivers them.
HoldDetector detectorOver(const TemperatureProfile &profile, double untilS, Random &random)
{
    HoldDetector detector;
    double temperatureC = profile.startC();
    double timeS = 0.0;
    while (timeS < untilS) {
        const auto rows = static_cast<Eigen::Index>(1 + std::floor(300.0 * random.uniform()));
        Eigen::VectorXd times(rows), temperatures(rows);
        for (Eigen::Index i = 0; i < rows; ++i, timeS += 0.1) {
            temperatureC += (profile.setpointC(timeS) - temperatureC) * 0.1 / 20.0;
            times[i] = timeS;
            temperatures[i] = temperatureC + 0.03 * random.normal();
        }
        detector.add(times, temperatures);
    }
    return detector;
}

} // namespace

class TestHoldDetector : public QObject
{
    Q_OBJECT

private slots:
    void holds_paperProfile_areTheTwoOfThePlan();
    void holds_inTheMiddleOfAHold_lastOneGoesOn();
    void holds_slowDrift_isNoHold();
    void holds_cycles_haveOneForEachHold();
    void add_badRows_areLeftOut();
    void holds_oneSampleOrNone_areNone();
};

void TestHoldDetector::holds_paperProfile_areTheTwoOfThePlan()
{
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    const TemperatureProfile profile = *TemperatureProfile::named("paper");
    const auto holds = detectorOver(profile, profile.durationS(), random).holds();
    QCOMPARE(holds.size(), std::size_t{2});
    QVERIFY(holds[0].startS < 1.0 && std::abs(holds[0].endS - 1800.0) < 30.0);
    QVERIFY(std::abs(holds[0].meanC + 40.0) < 0.1);
    QVERIFY(std::abs(holds[1].startS - 9300.0) < 60.0 && holds[1].endS > 11080.0);
    QVERIFY(std::abs(holds[1].meanC - 85.0) < 0.1);
}

void TestHoldDetector::holds_inTheMiddleOfAHold_lastOneGoesOn()
{
    Random random(kSeed);
    const TemperatureProfile profile = *TemperatureProfile::named("paper");
    const HoldDetector holding = detectorOver(profile, 600.0, random);
    QVERIFY(holding.isHolding());
    QVERIFY(holding.holds().back().endS > 580.0);
    QVERIFY(!detectorOver(profile, 4000.0, random).isHolding());
}

void TestHoldDetector::holds_slowDrift_isNoHold()
{
    HoldDetector detector;
    const Eigen::VectorXd timeS = Eigen::VectorXd::LinSpaced(36000, 0.0, 3600.0);
    detector.add(timeS, timeS / 60.0 * 0.4); // 0.4 degrees a minute
    QVERIFY(detector.holds().empty());
}

void TestHoldDetector::holds_cycles_haveOneForEachHold()
{
    Random random(kSeed + 1);
    const auto profile = TemperatureProfile::build(
        "cycle", 0.0,
        {HoldSegment{300.0}, RampSegment{20.0, 0.5, 15.0}, HoldSegment{300.0}, RampSegment{0.0, 0.5, 15.0}},
        2);
    QVERIFY(profile.ok());
    const auto holds = detectorOver(*profile, profile->durationS(), random).holds();
    QCOMPARE(holds.size(), std::size_t{4});
    for (std::size_t i = 1; i < holds.size(); ++i)
        QVERIFY(holds[i].startS >= holds[i - 1].endS);
}

void TestHoldDetector::add_badRows_areLeftOut()
{
    HoldDetector detector;
    Eigen::VectorXd timeS = Eigen::VectorXd::LinSpaced(1000, 0.0, 100.0);
    Eigen::VectorXd temperatureC = Eigen::VectorXd::Constant(1000, 25.0);
    temperatureC[300] = NAN;
    timeS[500] = NAN;
    detector.add(timeS, temperatureC);
    QCOMPARE(detector.holds().size(), std::size_t{1});
    QCOMPARE(detector.holds().front().meanC, 25.0);
}

void TestHoldDetector::holds_oneSampleOrNone_areNone()
{
    HoldDetector detector;
    QVERIFY(detector.holds().empty());
    detector.add(Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1));
    QVERIFY(detector.holds().empty() && !detector.isHolding());
}

QTEST_GUILESS_MAIN(TestHoldDetector)
#include "tst_hold_detector.moc"
