#include "support/simulated_runs.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestSimulatorPhysics : public QObject
{
    Q_OBJECT

private slots:
    void spread_manyRuns_isTheRelativeDeviationEverywhere();
    void turnOnBias_manyRuns_isConstantWithinARun();
    void noise_alone_isWhiteNormalAndIndependent();
    void lag_rampOfTheSetpoint_isTheClosedForm();
    void deadTime_delaysTheAirAndNothingElse();
    void truth_withoutNoise_isWhatTheGyroReads();
    void hysteresis_cycle_isHeatingMinusCooling();
};

void TestSimulatorPhysics::spread_manyRuns_isTheRelativeDeviationEverywhere()
{
    constexpr int kRuns = 4000;
    constexpr double kSpread = 0.002;
    const DriftCurves flat = sameOnEveryAxis([](double) { return 2.0; });
    const std::array<double, 4> temperaturesC{-40.0, 0.0, 31.0, 85.0};
    std::array<double, 4> sums{};
    std::array<double, 4> squares{};
    double axesTogether = 0.0;
    for (int i = 0; i < kRuns; ++i) {
        const DriftCurves one =
            withRunSpread(flat, kSpread, 0.0, Random(5).fork(static_cast<std::uint64_t>(i)));
        for (std::size_t k = 0; k < temperaturesC.size(); ++k) {
            const double relative = one.rateDps[0](temperaturesC[k]) / 2.0 - 1.0;
            sums[k] += relative;
            squares[k] += relative * relative;
        }
        axesTogether += (one.rateDps[0](20.0) / 2.0 - 1.0) * (one.rateDps[1](20.0) / 2.0 - 1.0);
    }
    for (std::size_t k = 0; k < temperaturesC.size(); ++k) {
        QVERIFY(std::abs(sums[k] / kRuns) < 4.0 * kSpread / std::sqrt(double(kRuns)));
        QVERIFY(within(std::sqrt(squares[k] / kRuns) / kSpread, 0.95, 1.05));
    }
    QVERIFY(std::abs(axesTogether / kRuns) < 4.0 * kSpread * kSpread / std::sqrt(double(kRuns)));
}

void TestSimulatorPhysics::turnOnBias_manyRuns_isConstantWithinARun()
{
    SimulationOptions options = optionsFor("quick", "curved");
    options.gyro.spread = 0.0;
    options.gyro.turnOnBiasDps = 0.2;
    const DriftTable campaign = campaignTruth(options);
    double squares = 0.0;
    constexpr int kRuns = 400;
    for (int number = 0; number < kRuns; ++number) {
        const GyroSimulator one = simulator(options, number);
        const Eigen::Vector3d bias = one.truth().rateDps(0.0) - campaign.rateDps(0.0);
        QVERIFY((one.truth().rateDps(70.0) - campaign.rateDps(70.0) - bias).norm() < 1e-12);
        squares += bias.squaredNorm() / kAxisCount;
    }
    QVERIFY(within(std::sqrt(squares / kRuns), 0.18, 0.22));
}

void TestSimulatorPhysics::noise_alone_isWhiteNormalAndIndependent()
{
    SimulationOptions options = optionsFor("quick", "none");
    options.gyro.sampleRateHz = 1000.0;
    options.gyro.sensitivityMdps = 0.0;
    options.seed = 20261121;
    qInfo("seed %llu", static_cast<unsigned long long>(options.seed));
    const Recording recording = run(options);
    const auto n = recording.size();
    const double standardError = 1.0 / std::sqrt(static_cast<double>(n));
    const Eigen::MatrixX3d noise = recording.rateDps / options.gyro.noiseDps;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const Eigen::ArrayXd z = noise.col(axis).array();
        QVERIFY(std::abs(z.mean()) < 4.5 * standardError);
        QVERIFY(std::abs(z.square().mean() - 1.0) < 4.5 * std::sqrt(2.0) * standardError);
        QVERIFY(std::abs(z.cube().mean()) < 4.5 * std::sqrt(15.0) * standardError);
        QVERIFY(std::abs(z.pow(4).mean() - 3.0) < 4.5 * std::sqrt(96.0) * standardError);
        for (const int lag : {1, 2, 3, 5, 10, 100, 1000})
            QVERIFY(std::abs((z.head(n - lag) * z.tail(n - lag)).mean()) < 4.5 * standardError);
        QVERIFY(std::abs((z * noise.col((axis + 1) % kAxisCount).array()).mean()) < 4.5 * standardError);
        // Allan deviation falls with the square root of the averaging length.
        for (const int length : {1, 10, 100}) {
            const Eigen::Index count = n / length;
            const Eigen::ArrayXd means =
                Eigen::Map<const Eigen::MatrixXd>(z.data(), length, count).colwise().mean().transpose();
            const double allan =
                std::sqrt(0.5 * (means.tail(count - 1) - means.head(count - 1)).square().mean());
            QVERIFY(within(allan * std::sqrt(double(length)), 0.95, 1.05));
        }
    }
}

void TestSimulatorPhysics::lag_rampOfTheSetpoint_isTheClosedForm()
{
    constexpr double kRampCPerS = 0.01;
    constexpr double kStepS = 0.1;
    constexpr double kLagS = 50.0;
    const auto ramp =
        TemperatureProfile::build("ramp", 0.0, {RampSegment{10.0, kRampCPerS * kStepS, kStepS}});
    QVERIFY(ramp.ok());
    SimulationOptions package = idealOptions(*ramp, thermometerCurves());
    package.gyro.packageLagS = kLagS;
    SimulationOptions chamber = idealOptions(*ramp, thermometerCurves());
    chamber.chamber.lagS = kLagS;
    const Recording behindPackage = run(package);
    const Recording behindChamber = run(chamber);
    // The ramp comes in steps of one sample, so the closed form holds to two of them.
    const double tolerance = 2.0 * kRampCPerS * kStepS;
    for (Eigen::Index i = 0; i < behindPackage.size(); ++i) {
        const double timeS = behindPackage.timeS[i];
        const double lagC = kRampCPerS * kLagS * (1.0 - std::exp(-timeS / kLagS));
        QVERIFY(std::abs(behindPackage.temperatureC[i] - kRampCPerS * timeS) <= tolerance);
        QVERIFY(std::abs(behindPackage.rateDps(i, 0) - (kRampCPerS * timeS - lagC)) <= tolerance);
        QVERIFY(std::abs(behindChamber.temperatureC[i] - (kRampCPerS * timeS - lagC)) <= tolerance);
        QCOMPARE(behindChamber.rateDps(i, 2), behindChamber.temperatureC[i]);
    }
}

void TestSimulatorPhysics::deadTime_delaysTheAirAndNothingElse()
{
    SimulationOptions options = idealOptions(*TemperatureProfile::named("quick"), thermometerCurves());
    options.chamber.lagS = 7.0;
    const Recording prompt = run(options);
    options.chamber.deadTimeS = 12.0;
    const Recording late = run(options);
    constexpr Eigen::Index kDelay = 120; // samples at 10 Hz
    QCOMPARE(late.size(), prompt.size());
    for (Eigen::Index i = 0; i < late.size(); ++i) {
        const double expectedC = prompt.temperatureC[std::max<Eigen::Index>(0, i - kDelay)];
        QVERIFY(std::abs(late.temperatureC[i] - expectedC) < 1e-9);
    }
}

void TestSimulatorPhysics::truth_withoutNoise_isWhatTheGyroReads()
{
    SimulationOptions options = idealOptions(*TemperatureProfile::named("quick"), *namedDriftCurves("steep"));
    options.chamber.lagS = 20.0;
    options.gyro.spread = 0.01;
    options.gyro.turnOnBiasDps = 0.1;
    options.gyro.referenceRateDps = {25.0, 5.0, 53.0};
    for (int number = 0; number < 3; ++number) {
        GyroSimulator one = simulator(options, number);
        const DriftTable campaign = campaignTruth(options);
        while (const auto sample = one.next()) {
            const Eigen::Vector3d expected =
                one.truth().rateDps(sample->temperatureC) + options.gyro.referenceRateDps;
            QVERIFY((sample->rateDps - expected).cwiseAbs().maxCoeff() < 1e-13);
        }
        QVERIFY((one.truth().rateDps(40.0) - campaign.rateDps(40.0)).norm() > 1e-3);
    }
}

void TestSimulatorPhysics::hysteresis_cycle_isHeatingMinusCooling()
{
    SimulationOptions options = idealOptions(*TemperatureProfile::named("cycle"), *namedDriftCurves("none"));
    options.gyro.hysteresisDps = 0.3;
    options.gyro.hysteresisPlayC = 4.0;
    const Recording recording = run(options);
    QCOMPARE(recording.rateDps(0, 0), 0.0);
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        const double temperatureC = recording.temperatureC[i];
        const bool heating = recording.timeS[i] >= 1800.0 && recording.timeS[i] < 9300.0;
        const bool cooling = recording.timeS[i] >= 11100.0 && recording.timeS[i] < 18600.0;
        if (heating && temperatureC >= -36.0)
            QVERIFY(std::abs(recording.rateDps(i, 1) - 0.15) < 1e-12);
        if (cooling && temperatureC <= 77.0)
            QVERIFY(std::abs(recording.rateDps(i, 1) + 0.15) < 1e-12);
    }
}

QTEST_APPLESS_MAIN(TestSimulatorPhysics)
#include "tst_simulator_physics.moc"
