#include "engine/base/random.h"
#include "engine/physics/lag_estimate.h"

#include <QTest>

#include <cmath>

using namespace driftbench;

class TestLagEstimate : public QObject
{
    Q_OBJECT

private slots:
    void steps_ofASampledSetpoint_areItsChanges();
    void estimate_singleStep_findsWhatWasPutIn_data();
    void estimate_singleStep_findsWhatWasPutIn();
    void estimate_paperRun_findsWhatWasPutIn();
    void estimate_noise_isWithinItsOwnUncertainty();
    void estimate_chamberNotAtItsSetpoint_isNoHindrance();
    void estimate_constantSetpoint_isRefused();
    void estimate_temperatureThatDoesNotFollow_isRefused();
    void estimate_middleOfARamp_isRefused();
    void estimate_stepAtTheVeryEnd_isRefused();
    void estimate_badData_isRefused();
};

namespace {

struct Truth
{
    double deadTimeS = 40.0;
    double timeConstantS = 200.0;
    double offsetC = 0.3;
    double startC = 0.0; // off at the start
    double noiseC = 0.01;
};

// Adds up the answers to single steps, each in closed form: nothing is shared with the estimator.
Eigen::VectorXd measured(const std::vector<ProfileStep> &setpoint, const Eigen::VectorXd &timeS,
                         const Truth &truth, Random &random)
{
    Eigen::VectorXd temperatureC(timeS.size());
    for (Eigen::Index i = 0; i < timeS.size(); ++i) {
        double valueC = setpoint.front().setpointC + truth.offsetC + truth.noiseC * random.normal() +
                        truth.startC * std::exp(-(timeS[i] - timeS[0]) / truth.timeConstantS);
        for (std::size_t k = 1; k < setpoint.size(); ++k) {
            const double ageS = timeS[i] - setpoint[k].startS - truth.deadTimeS;
            if (ageS > 0.0)
                valueC += (setpoint[k].setpointC - setpoint[k - 1].setpointC) *
                          -std::expm1(-ageS / truth.timeConstantS);
        }
        temperatureC[i] = valueC;
    }
    return temperatureC;
}

Eigen::VectorXd unevenTimes(double endS, double meanIntervalS, Random &random)
{
    std::vector<double> times{1000.0};
    while (times.back() < 1000.0 + endS)
        times.push_back(times.back() + meanIntervalS * random.uniform(0.2, 1.8));
    return Eigen::Map<Eigen::VectorXd>(times.data(), static_cast<Eigen::Index>(times.size()));
}

const std::vector<ProfileStep> kStep{{1000.0, 20.0}, {1600.0, 30.0}};

bool near(double value, double expected, double tolerance)
{
    return std::abs(value - expected) <= tolerance;
}

bool refused(const Result<LagEstimate> &estimate, Errc code)
{
    if (estimate.ok())
        qInfo("estimated: dead time %g +- %g s, time constant %g +- %g s, offset %g, rms %g",
              estimate->deadTimeS, estimate->deadTimeSdS, estimate->timeConstantS, estimate->timeConstantSdS,
              estimate->offsetC, estimate->residualRmsC);
    else
        qInfo("%s", estimate.error().message.c_str());
    return !estimate.ok() && estimate.error().code == code && estimate.error().message.ends_with('.');
}

} // namespace

void TestLagEstimate::steps_ofASampledSetpoint_areItsChanges()
{
    const auto steps = setpointSteps(Eigen::VectorXd::LinSpaced(6, 0.0, 5.0),
                                     (Eigen::VectorXd(6) << 1.0, 1.0, 2.0, 2.0, 1.0, 1.0).finished());
    QCOMPARE(steps.size(), std::size_t{3});
    QCOMPARE(steps[1].startS, 2.0);
    QCOMPARE(steps[2].startS, 4.0);
    QCOMPARE(steps[2].setpointC, 1.0);
}

void TestLagEstimate::estimate_singleStep_findsWhatWasPutIn_data()
{
    QTest::addColumn<double>("deadTimeS");
    QTest::addColumn<double>("timeConstantS");
    QTest::addColumn<double>("tolerance");
    QTest::newRow("both") << 40.0 << 200.0 << 1e-4;
    QTest::newRow("no dead time") << 0.0 << 300.0 << 1e-4;
    QTest::newRow("mostly dead time") << 500.0 << 20.0 << 1e-4;
    QTest::newRow("slow") << 5.0 << 1500.0 << 1e-3;
    QTest::newRow("quick") << 3.0 << 4.0 << 1e-4;
}

void TestLagEstimate::estimate_singleStep_findsWhatWasPutIn()
{
    QFETCH(double, deadTimeS);
    QFETCH(double, timeConstantS);
    QFETCH(double, tolerance);
    Random random(3);
    const Eigen::VectorXd timeS = unevenTimes(4000.0, 2.0, random);
    const Truth truth{deadTimeS, timeConstantS, -0.7, 0.0, 0.0};
    const auto estimate = estimateLag(kStep, timeS, measured(kStep, timeS, truth, random));
    QVERIFY2(estimate.ok(), estimate.ok() ? "" : estimate.error().message.c_str());
    QVERIFY(near(estimate->deadTimeS, deadTimeS, tolerance));
    QVERIFY(near(estimate->timeConstantS, timeConstantS, tolerance));
    QVERIFY(near(estimate->offsetC, -0.7, 1e-6));
    QVERIFY(estimate->residualRmsC < 1e-6);
}

void TestLagEstimate::estimate_paperRun_findsWhatWasPutIn()
{
    constexpr std::uint64_t kSeed = 11;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    const auto profile = TemperatureProfile::named("paper");
    const Eigen::VectorXd timeS = Eigen::VectorXd::LinSpaced(111000, 0.0, 11099.9);
    const Truth truth{12.0, 75.0, 0.2, 0.0, 0.01};
    const Eigen::VectorXd temperatureC = measured(profile->steps(), timeS, truth, random);
    const auto estimate = estimateLag(profile->steps(), timeS, temperatureC);
    QVERIFY2(estimate.ok(), estimate.ok() ? "" : estimate.error().message.c_str());
    QVERIFY(near(estimate->deadTimeS, 12.0, 0.1));
    QVERIFY(near(estimate->timeConstantS, 75.0, 0.1));
    QVERIFY(near(estimate->offsetC, 0.2, 1e-3));
    QVERIFY(near(estimate->residualRmsC, 0.01, 1e-4));
    QCOMPARE(estimate->samples, Eigen::Index{111000});
}

// 60 recordings: of each figure 95 % should lie within two standard deviations; under 85 % is no accident.
void TestLagEstimate::estimate_noise_isWithinItsOwnUncertainty()
{
    constexpr std::uint64_t kSeed = 5;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    constexpr int kRecordings = 60;
    int deadTimes = 0;
    int timeConstants = 0;
    for (int i = 0; i < kRecordings; ++i) {
        const Eigen::VectorXd timeS = unevenTimes(3000.0, 5.0, random);
        const Truth truth{40.0, 200.0, 0.3, 0.0, 0.2};
        const auto estimate = estimateLag(kStep, timeS, measured(kStep, timeS, truth, random));
        QVERIFY2(estimate.ok(), estimate.ok() ? "" : estimate.error().message.c_str());
        QVERIFY(estimate->deadTimeSdS < 10.0 && estimate->timeConstantSdS < 30.0);
        deadTimes += near(estimate->deadTimeS, 40.0, 2.0 * estimate->deadTimeSdS);
        timeConstants += near(estimate->timeConstantS, 200.0, 2.0 * estimate->timeConstantSdS);
    }
    qInfo("within two standard deviations: %d and %d of %d", deadTimes, timeConstants, kRecordings);
    QVERIFY(deadTimes >= 51 && timeConstants >= 51);
}

void TestLagEstimate::estimate_chamberNotAtItsSetpoint_isNoHindrance()
{
    Random random(8);
    const Eigen::VectorXd timeS = unevenTimes(4000.0, 1.0, random);
    const Truth truth{30.0, 150.0, 0.0, -45.0, 0.01};
    const auto estimate = estimateLag(kStep, timeS, measured(kStep, timeS, truth, random));
    QVERIFY(estimate.ok());
    QVERIFY(near(estimate->deadTimeS, 30.0, 0.5));
    QVERIFY(near(estimate->timeConstantS, 150.0, 0.5));
}

void TestLagEstimate::estimate_constantSetpoint_isRefused()
{
    Random random(2);
    const Eigen::VectorXd timeS = unevenTimes(1000.0, 1.0, random);
    const std::vector<ProfileStep> constant{{1000.0, 20.0}};
    const Eigen::VectorXd temperatureC = measured(constant, timeS, {}, random);
    QVERIFY(refused(estimateLag(constant, timeS, temperatureC), Errc::ConstantTemperature));
    // A step before and one after the recording do not count.
    const std::vector<ProfileStep> elsewhere{{0.0, 10.0}, {900.0, 20.0}, {9000.0, 30.0}};
    QVERIFY(refused(estimateLag(elsewhere, timeS, temperatureC), Errc::ConstantTemperature));
}

void TestLagEstimate::estimate_temperatureThatDoesNotFollow_isRefused()
{
    Random random(2);
    const Eigen::VectorXd timeS = unevenTimes(4000.0, 1.0, random);
    const std::vector<ProfileStep> down{{1000.0, 20.0}, {1600.0, 10.0}};
    QVERIFY(refused(estimateLag(kStep, timeS, measured(down, timeS, {}, random)), Errc::NothingUsable));
    QVERIFY(
        refused(estimateLag(kStep, timeS, measured({{0.0, 20.0}}, timeS, {}, random)), Errc::NothingUsable));
}

// With the ramp on from before the first to after the last sample only the whole lag and the offset show,
// and these two can't be told apart.
void TestLagEstimate::estimate_middleOfARamp_isRefused()
{
    Random random(4);
    std::vector<ProfileStep> ramp;
    for (int i = 0; i < 9000; ++i)
        ramp.push_back({static_cast<double>(i), 20.0 + 0.01 * i});
    const Eigen::VectorXd timeS = unevenTimes(600.0, 2.0, random);
    Eigen::VectorXd temperatureC = (0.01 * (timeS.array() - 240.0) + 20.3).matrix();
    for (double &valueC : temperatureC)
        valueC += 0.05 * random.normal();
    const auto estimate = estimateLag(ramp, timeS, temperatureC);
    QVERIFY(refused(estimate, Errc::NothingUsable));
}

void TestLagEstimate::estimate_stepAtTheVeryEnd_isRefused()
{
    Random random(4);
    const Eigen::VectorXd timeS = unevenTimes(1000.0, 1.0, random);
    const std::vector<ProfileStep> late{{1000.0, 20.0}, {1995.0, 30.0}};
    QVERIFY(!estimateLag(late, timeS, measured(late, timeS, {}, random)).ok());
}

void TestLagEstimate::estimate_badData_isRefused()
{
    Random random(2);
    const Eigen::VectorXd timeS = unevenTimes(4000.0, 2.0, random);
    const Eigen::VectorXd temperatureC = measured(kStep, timeS, {}, random);
    QVERIFY(refused(estimateLag(kStep, timeS.head(19), temperatureC.head(19)), Errc::TooFewSamples));
    Eigen::VectorXd bad = temperatureC;
    bad[7] = std::nan("");
    QVERIFY(refused(estimateLag(kStep, timeS, bad), Errc::NonFiniteValue));
    Eigen::VectorXd back = timeS;
    back[9] = back[8];
    QVERIFY(refused(estimateLag(kStep, back, temperatureC), Errc::TimeBackwards));
}

QTEST_APPLESS_MAIN(TestLagEstimate)
#include "tst_lag_estimate.moc"
