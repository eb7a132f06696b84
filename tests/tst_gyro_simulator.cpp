#include "engine/base/text.h"
#include "engine/physics/gyro_simulator.h"

#include <Eigen/QR>
#include <QTest>

#include <cstring>
#include <limits>
#include <set>

using namespace driftbench;

class TestGyroSimulator : public QObject
{
    Q_OBJECT

private slots:
    void simulateRun_paperProfile_hasThePapersSamples();
    void simulateRun_hookSaysStop_isCancelled();
    void namedDriftCurves_overThePapersProfile_haveTheStatedSize();
    void namedDriftCurves_unknown_listsTheKnownOnes();
    void driftTable_anyTemperature_isTheFunction();
    void spread_manyRuns_isTheRelativeDeviationEverywhere();
    void turnOnBias_manyRuns_isConstantWithinARun();
    void noise_alone_isWhiteNormalAndIndependent();
    void lag_rampOfTheSetpoint_isTheClosedForm();
    void truth_withoutNoise_isWhatTheGyroReads();
    void hysteresis_cycle_isHeatingMinusCooling();
    void samples_streamedInBlocksOrWhole_areTheSameBits();
    void seed_sameOrOther_givesTheSameOrOtherRun();
    void biasSteps_changeNothingButTheBias();
    void motion_changesOnlyItsBursts();
    void gaps_loseOnlyTheirSamples();
    void outliers_changeOnlyTheirShareOfSamples();
    void nonFinite_replacesOnlyItsShareOfSamples();
    void stairs_changeOnlyTheTemperature();
    void output_isInWholeCountsAndSaturates();
    void checkOptions_badValue_saysWhichInOneSentence_data();
    void checkOptions_badValue_saysWhichInOneSentence();
};

namespace {

SimulationOptions optionsFor(std::string_view profile, std::string_view truth)
{
    return {*TemperatureProfile::named(profile), *namedDriftCurves(truth)};
}

// The chain without anything random or rounded.
SimulationOptions idealOptions(const TemperatureProfile &profile, const DriftCurves &truth)
{
    SimulationOptions options{profile, truth};
    options.chamber = {.lagS = 0.0, .thermometerNoiseC = 0.0, .thermometerCountsPerC = 0.0};
    options.gyro.noiseDps = 0.0;
    options.gyro.spread = 0.0;
    options.gyro.sensitivityMdps = 0.0;
    options.gyro.rangeDps = 1e5;
    return options;
}

DriftCurves sameOnEveryAxis(double (*rateDps)(double temperatureC))
{
    DriftCurves curves;
    for (DriftFunction &axis : curves.rateDps)
        axis = rateDps;
    return curves;
}

// A gyro whose rate is its die temperature.
DriftCurves thermometerCurves()
{
    return sameOnEveryAxis([](double temperatureC) { return temperatureC; });
}

Recording run(const SimulationOptions &options, int number = 0)
{
    auto recording = simulateRun(options, number);
    if (!recording)
        qFatal("%s", recording.error().message.c_str());
    return std::move(recording).value();
}

GyroSimulator simulator(const SimulationOptions &options, int number = 0)
{
    auto made = GyroSimulator::create(options, number);
    if (!made)
        qFatal("%s", made.error().message.c_str());
    return std::move(made).value();
}

template <class Matrix>
bool sameBits(const Matrix &a, const Matrix &b)
{
    return a.rows() == b.rows() && a.cols() == b.cols() &&
           std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

bool sameBits(const Recording &a, const Recording &b)
{
    return sameBits(a.timeS, b.timeS) && sameBits(a.temperatureC, b.temperatureC) &&
           sameBits(a.rateDps, b.rateDps);
}

SimulationOptions withEverything()
{
    SimulationOptions options = optionsFor("quick", "steep");
    options.gyro.referenceRateDps = {25.0, 5.0, 53.0};
    options.gyro.turnOnBiasDps = 0.1;
    options.gyro.packageLagS = 5.0;
    options.gyro.hysteresisDps = 0.2;
    options.faults = {
        .biasSteps = 3, .motionBursts = 2, .gaps = 3, .outlierFraction = 0.01, .nonFiniteFraction = 0.005};
    options.seed = 99;
    return options;
}

// Mean square that a polynomial of the degree in temperature leaves, per axis.
Eigen::Vector3d leftByPolynomial(const Recording &recording, int degree)
{
    const Eigen::ArrayXd u = (recording.temperatureC.array() - 22.5) / 62.5;
    Eigen::MatrixXd powers(recording.size(), degree + 1);
    for (int power = 0; power <= degree; ++power)
        powers.col(power) = u.pow(power);
    const Eigen::MatrixXd weights = powers.colPivHouseholderQr().solve(recording.rateDps);
    return (recording.rateDps - powers * weights).colwise().squaredNorm().transpose() /
           static_cast<double>(recording.size());
}

bool within(double value, double low, double high)
{
    if (value < low || value > high)
        qWarning("%g is not in %g .. %g", value, low, high);
    return value >= low && value <= high;
}

} // namespace

void TestGyroSimulator::simulateRun_paperProfile_hasThePapersSamples()
{
    const Recording recording = run(optionsFor("paper", "curved"));
    QCOMPARE(recording.size(), Eigen::Index{111000});
    QCOMPARE(recording.timeS[0], 0.0);
    QCOMPARE(recording.timeS[3], 0.3);
    QCOMPARE(recording.timeS[110999], 11099.9);
    QVERIFY(recording.info.simulated);
    QCOMPARE(recording.info.sensor.text(), std::string("I3G4250D SIM-0001"));
    const double atStartC = recording.temperatureC.head(18000).mean();
    QVERIFY(std::abs(atStartC + 40.0) < 0.001);
    QVERIFY(std::abs(recording.temperatureC.tail(10000).mean() - 85.0) < 0.001);
    // 3 standard deviations of the thermometer are its accuracy of 0.03 C.
    const Eigen::ArrayXd off = recording.temperatureC.head(18000).array() - atStartC;
    QVERIFY(within(std::sqrt(off.square().mean()), 0.0098, 0.0102));
}

void TestGyroSimulator::simulateRun_hookSaysStop_isCancelled()
{
    const auto stopped = simulateRun(optionsFor("paper", "curved"), 0, [](const Progress &progress) {
        return progress.fraction > 0.3 ? Flow::Stop : Flow::Continue;
    });
    QVERIFY(!stopped.ok());
    QCOMPARE(stopped.error().code, Errc::Cancelled);
}

void TestGyroSimulator::namedDriftCurves_overThePapersProfile_haveTheStatedSize()
{
    constexpr double kNoiseVariance = 0.14 * 0.14;
    const auto paper = *TemperatureProfile::named("paper");
    const auto quiet = [&](std::string_view name) {
        SimulationOptions options = idealOptions(paper, *namedDriftCurves(name));
        options.gyro.sampleRateHz = 0.5;
        return run(options);
    };
    const auto meanSquare = [](const Recording &recording) -> Eigen::Vector3d {
        return recording.rateDps.colwise().squaredNorm().transpose() / static_cast<double>(recording.size());
    };
    const Recording curved = quiet("curved");
    QVERIFY(within(meanSquare(curved)[0], 3.5, 4.5));
    QVERIFY(within(meanSquare(curved)[1], 5.5, 7.5));
    QVERIFY(within(meanSquare(curved)[2], 0.55, 0.85));
    const Eigen::Vector3d curvedLeft = leftByPolynomial(curved, 3) / kNoiseVariance;
    QVERIFY(within(curvedLeft[0], 0.15, 0.35));
    QVERIFY(within(curvedLeft[1], 0.005, 0.015));
    QVERIFY(within(curvedLeft[2], 0.010, 0.030));
    const Recording steep = quiet("steep");
    QVERIFY(within(meanSquare(steep)[0], 3.5, 4.5));
    const Eigen::Vector3d steepLeft = leftByPolynomial(steep, 3) / kNoiseVariance;
    QVERIFY(within(steepLeft[0], 0.5, 1.0));
    QVERIFY(within(steepLeft[1], 0.08, 0.15));
    QVERIFY(within(steepLeft[2], 0.10, 0.20));
    const Recording mild = quiet("mild");
    QVERIFY(leftByPolynomial(mild, 3).maxCoeff() < 1e-20);
    QVERIFY(within(meanSquare(mild).maxCoeff(), 0.05, 0.2));
    QCOMPARE(quiet("none").rateDps.cwiseAbs().maxCoeff(), 0.0);
}

void TestGyroSimulator::namedDriftCurves_unknown_listsTheKnownOnes()
{
    const auto curves = namedDriftCurves("bent");
    QVERIFY(!curves.ok());
    QCOMPARE(curves.error().code, Errc::InvalidOption);
    for (const std::string_view name : kDriftCurveNames)
        QVERIFY(curves.error().message.find(name) != std::string::npos);
}

void TestGyroSimulator::driftTable_anyTemperature_isTheFunction()
{
    constexpr std::uint64_t kSeed = 77;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    for (const std::string_view name : kDriftCurveNames) {
        const DriftCurves curves = *namedDriftCurves(name);
        const DriftTable table(curves, -40.0, 85.0);
        for (int i = 0; i < 5000; ++i) {
            const double temperatureC = random.uniform(-40.0, 85.0);
            for (int axis = 0; axis < kAxisCount; ++axis)
                QVERIFY(std::abs(table.rateDps(temperatureC)[axis] - curves.rateDps[axis](temperatureC)) <
                        2e-6);
        }
        for (int axis = 0; axis < kAxisCount; ++axis) {
            QCOMPARE(table.rateDps(-60.0)[axis], curves.rateDps[axis](-40.0));
            QCOMPARE(table.rateDps(200.0)[axis], curves.rateDps[axis](85.0));
        }
    }
}

void TestGyroSimulator::spread_manyRuns_isTheRelativeDeviationEverywhere()
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

void TestGyroSimulator::turnOnBias_manyRuns_isConstantWithinARun()
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

void TestGyroSimulator::noise_alone_isWhiteNormalAndIndependent()
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

void TestGyroSimulator::lag_rampOfTheSetpoint_isTheClosedForm()
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

void TestGyroSimulator::truth_withoutNoise_isWhatTheGyroReads()
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

void TestGyroSimulator::hysteresis_cycle_isHeatingMinusCooling()
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

void TestGyroSimulator::samples_streamedInBlocksOrWhole_areTheSameBits()
{
    const SimulationOptions options = withEverything();
    const Recording whole = run(options, 2);
    QVERIFY(whole.size() > 3000);
    for (const Eigen::Index rows : {Eigen::Index{1}, Eigen::Index{7}, Eigen::Index{5000}}) {
        GyroSimulator one = simulator(options, 2);
        SampleBlock block = SampleBlock::withRows(rows);
        Eigen::Index filled = 0;
        while (const Eigen::Index count = one.fill(block)) {
            QVERIFY(filled + count <= whole.size());
            QVERIFY(sameBits<Eigen::VectorXd>(block.timeS.head(count), whole.timeS.segment(filled, count)));
            QVERIFY(sameBits<Eigen::VectorXd>(block.temperatureC.head(count),
                                              whole.temperatureC.segment(filled, count)));
            QVERIFY(sameBits<Eigen::MatrixX3d>(block.rateDps.topRows(count),
                                               whole.rateDps.middleRows(filled, count)));
            filled += count;
        }
        QCOMPARE(filled, whole.size());
        QCOMPARE(one.fractionDone(), 1.0);
    }
    GyroSimulator one = simulator(options, 2);
    Eigen::Index row = 0;
    while (const auto sample = one.next()) {
        QCOMPARE(sample->timeS, whole.timeS[row]);
        const Eigen::Vector3d expected = whole.rateDps.row(row).transpose();
        QVERIFY(sameBits(sample->rateDps, expected));
        ++row;
    }
    QCOMPARE(row, whole.size());
}

void TestGyroSimulator::seed_sameOrOther_givesTheSameOrOtherRun()
{
    SimulationOptions options = withEverything();
    const Recording first = run(options);
    QVERIFY(sameBits(first, run(options)));
    QVERIFY(!sameBits(first.rateDps, run(options, 1).rateDps));
    options.seed += 1;
    QVERIFY(!sameBits(first.temperatureC, run(options).temperatureC));
}

void TestGyroSimulator::biasSteps_changeNothingButTheBias()
{
    SimulationOptions options = optionsFor("quick", "curved");
    options.gyro.sensitivityMdps = 0.0;
    const Recording without = run(options);
    options.faults.biasSteps = 4;
    const Recording with = run(options);
    const auto steps = simulator(options).events().biasSteps;
    QCOMPARE(steps.size(), std::size_t{4});
    QVERIFY(sameBits(with.temperatureC, without.temperatureC));
    for (Eigen::Index i = 0; i < with.size(); ++i) {
        Eigen::Vector3d expected = Eigen::Vector3d::Zero();
        for (const BiasStep &step : steps)
            expected += step.timeS <= with.timeS[i] ? step.stepDps : Eigen::Vector3d::Zero();
        QVERIFY((with.rateDps.row(i) - without.rateDps.row(i) - expected.transpose()).norm() < 1e-12);
    }
    for (const BiasStep &step : steps) {
        QVERIFY(step.stepDps.cwiseAbs().minCoeff() >= 0.5 * options.faults.biasStepDps);
        QVERIFY(step.stepDps.cwiseAbs().maxCoeff() <= options.faults.biasStepDps);
    }
}

void TestGyroSimulator::motion_changesOnlyItsBursts()
{
    SimulationOptions options = optionsFor("quick", "curved");
    const Recording still = run(options);
    options.faults.motionBursts = 3;
    const Recording moved = run(options);
    const auto bursts = simulator(options).events().motionBursts;
    QCOMPARE(bursts.size(), std::size_t{3});
    for (const MotionBurst &burst : bursts) {
        double largest = 0.0;
        QVERIFY(std::abs(burst.endS - burst.startS - options.faults.motionS) < 1e-9);
        for (Eigen::Index i = 0; i < moved.size(); ++i) {
            if (moved.timeS[i] >= burst.startS && moved.timeS[i] < burst.endS)
                largest =
                    std::max(largest, (moved.rateDps.row(i) - still.rateDps.row(i)).cwiseAbs().maxCoeff());
        }
        QVERIFY(within(largest, 0.5 * options.faults.motionDps * 0.8, options.faults.motionDps + 0.01));
    }
    for (Eigen::Index i = 0; i < moved.size(); ++i) {
        const bool inBurst = std::any_of(bursts.begin(), bursts.end(), [&](const MotionBurst &burst) {
            return moved.timeS[i] >= burst.startS && moved.timeS[i] < burst.endS;
        });
        QVERIFY(inBurst || moved.rateDps.row(i) == still.rateDps.row(i));
    }
}

void TestGyroSimulator::gaps_loseOnlyTheirSamples()
{
    SimulationOptions options = optionsFor("quick", "curved");
    const Recording whole = run(options);
    options.faults.gaps = 3;
    options.faults.gapS = 7.0;
    const Recording broken = run(options);
    const auto gaps = simulator(options).events().gaps;
    Eigen::Index row = 0;
    for (Eigen::Index i = 0; i < whole.size(); ++i) {
        const bool lost = std::any_of(gaps.begin(), gaps.end(), [&](const Gap &gap) {
            return whole.timeS[i] >= gap.startS && whole.timeS[i] < gap.endS;
        });
        if (lost)
            continue;
        QCOMPARE(broken.timeS[row], whole.timeS[i]);
        QCOMPARE(broken.temperatureC[row], whole.temperatureC[i]);
        QVERIFY(broken.rateDps.row(row) == whole.rateDps.row(i));
        ++row;
    }
    QCOMPARE(row, broken.size());
    QVERIFY(std::abs(static_cast<double>(whole.size() - broken.size()) - 3 * 70.0) <= 3.0);
}

void TestGyroSimulator::outliers_changeOnlyTheirShareOfSamples()
{
    SimulationOptions options = optionsFor("paper", "mild");
    const Recording clean = run(options);
    options.faults.outlierFraction = 0.01;
    const Recording dirty = run(options);
    Eigen::Index changed = 0;
    for (Eigen::Index i = 0; i < clean.size(); ++i) {
        const Eigen::RowVector3d difference = dirty.rateDps.row(i) - clean.rateDps.row(i);
        if (difference.isZero(0.0))
            continue;
        ++changed;
        // The size is 3 dps, to the nearest count.
        QVERIFY((difference.cwiseAbs().array() - options.faults.outlierDps).abs().maxCoeff() < 0.00876);
    }
    const double expected = 0.01 * static_cast<double>(clean.size());
    QVERIFY(std::abs(static_cast<double>(changed) - expected) < 4.5 * std::sqrt(expected));
}

void TestGyroSimulator::nonFinite_replacesOnlyItsShareOfSamples()
{
    SimulationOptions options = optionsFor("paper", "mild");
    const Recording clean = run(options);
    options.faults.nonFiniteFraction = 0.005;
    const Recording broken = run(options);
    Eigen::Index lost = 0;
    for (Eigen::Index i = 0; i < clean.size(); ++i) {
        if (broken.rateDps.row(i).array().isNaN().all())
            ++lost;
        else
            QVERIFY(broken.rateDps.row(i) == clean.rateDps.row(i));
    }
    const double expected = 0.005 * static_cast<double>(clean.size());
    QVERIFY(std::abs(static_cast<double>(lost) - expected) < 4.5 * std::sqrt(expected));
}

void TestGyroSimulator::stairs_changeOnlyTheTemperature()
{
    SimulationOptions options = optionsFor("quick", "curved");
    const Recording fine = run(options);
    options.chamber.thermometerCountsPerC = 1.0;
    const Recording stairs = run(options);
    QVERIFY(sameBits(fine.rateDps, stairs.rateDps));
    std::set<double> values;
    for (Eigen::Index i = 0; i < stairs.size(); ++i) {
        QCOMPARE(stairs.temperatureC[i], std::round(stairs.temperatureC[i]));
        QVERIFY(std::abs(stairs.temperatureC[i] - fine.temperatureC[i]) <= 0.5005);
        values.insert(stairs.temperatureC[i]);
    }
    QVERIFY(within(static_cast<double>(values.size()), 120.0, 126.0));
}

void TestGyroSimulator::output_isInWholeCountsAndSaturates()
{
    SimulationOptions options = optionsFor("quick", "curved");
    options.gyro.referenceRateDps = {244.0, -244.0, 0.0};
    const Recording recording = run(options);
    QCOMPARE(recording.rateDps.col(0).maxCoeff(), 245.0);
    QCOMPARE(recording.rateDps.col(1).minCoeff(), -245.0);
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        for (int axis = 0; axis < kAxisCount; ++axis) {
            const double rateDps = recording.rateDps(i, axis);
            const double counts = rateDps * 1000.0 / options.gyro.sensitivityMdps;
            QVERIFY(std::abs(counts - std::round(counts)) < 1e-9);
            QCOMPARE(parseNumber(fixed(rateDps, 5)).value(), rateDps);
        }
        QCOMPARE(parseNumber(fixed(recording.temperatureC[i], 3)).value(), recording.temperatureC[i]);
    }
}

void TestGyroSimulator::checkOptions_badValue_saysWhichInOneSentence_data()
{
    using Change = void (*)(SimulationOptions &);
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *says, Change change) { QTest::newRow(says) << change << QString(says); };
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    row("sampling rate is 0 Hz", [](SimulationOptions &o) { o.gyro.sampleRateHz = 0.0; });
    row("sampling rate is -10 Hz", [](SimulationOptions &o) { o.gyro.sampleRateHz = -10.0; });
    row("sampling rate is nan Hz", [](SimulationOptions &o) { o.gyro.sampleRateHz = kNan; });
    row("sampling rate is inf Hz",
        [](SimulationOptions &o) { o.gyro.sampleRateHz = std::numeric_limits<double>::infinity(); });
    row("has 0.37 samples", [](SimulationOptions &o) { o.gyro.sampleRateHz = 0.001; });
    row("spread between runs is -0.1", [](SimulationOptions &o) { o.gyro.spread = -0.1; });
    row("noise of the rate is -1 dps", [](SimulationOptions &o) { o.gyro.noiseDps = -1.0; });
    row("turn-on bias is -1 dps", [](SimulationOptions &o) { o.gyro.turnOnBiasDps = -1.0; });
    row("lag of the package is -1 s", [](SimulationOptions &o) { o.gyro.packageLagS = -1.0; });
    row("lag of the chamber is nan s", [](SimulationOptions &o) { o.chamber.lagS = kNan; });
    row("noise of the thermometer is -1 °C",
        [](SimulationOptions &o) { o.chamber.thermometerNoiseC = -1.0; });
    row("resolution of the thermometer",
        [](SimulationOptions &o) { o.chamber.thermometerCountsPerC = -1.0; });
    row("hysteresis is nan dps", [](SimulationOptions &o) { o.gyro.hysteresisDps = kNan; });
    row("play of the hysteresis is 0 °C", [](SimulationOptions &o) { o.gyro.hysteresisPlayC = 0.0; });
    row("sensitivity is -8.75 mdps", [](SimulationOptions &o) { o.gyro.sensitivityMdps = -8.75; });
    row("range of the gyro is 0 dps", [](SimulationOptions &o) { o.gyro.rangeDps = 0.0; });
    row("reference rate on z is 300 dps", [](SimulationOptions &o) { o.gyro.referenceRateDps[2] = 300.0; });
    row("number of bias steps is -1", [](SimulationOptions &o) { o.faults.biasSteps = -1; });
    row("number of motion bursts is -2", [](SimulationOptions &o) { o.faults.motionBursts = -2; });
    row("number of gaps is -3", [](SimulationOptions &o) { o.faults.gaps = -3; });
    row("length of a gap is -1 s", [](SimulationOptions &o) { o.faults.gapS = -1.0; });
    row("fraction of outliers is 1.5", [](SimulationOptions &o) { o.faults.outlierFraction = 1.5; });
    row("fraction of non-finite samples is nan",
        [](SimulationOptions &o) { o.faults.nonFiniteFraction = kNan; });
}

void TestGyroSimulator::checkOptions_badValue_saysWhichInOneSentence()
{
    using Change = void (*)(SimulationOptions &);
    QFETCH(Change, change);
    QFETCH(QString, says);
    SimulationOptions options = optionsFor("quick", "curved");
    change(options);
    const Status status = checkOptions(options);
    QVERIFY(!status.ok());
    QCOMPARE(status.error().code, Errc::InvalidOption);
    const QString message = QString::fromStdString(status.error().message);
    QVERIFY2(message.contains(says), qPrintable(message));
    QVERIFY(message.endsWith('.') && !message.contains(". "));
    QCOMPARE(GyroSimulator::create(options, 0).error().message, status.error().message);
}

QTEST_APPLESS_MAIN(TestGyroSimulator)
#include "tst_gyro_simulator.moc"
