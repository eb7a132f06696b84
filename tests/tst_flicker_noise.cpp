#include "engine/evaluation/allan.h"
#include "engine/physics/flicker_noise.h"
#include "engine/physics/gyro_simulator.h"
#include "engine/physics/rate_random_walk.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace driftbench;

// Every bound of 5 % below is at least four standard errors wide: a curve of n windows of length m has about
// 1.25 n / m degrees of freedom an axis for flicker noise (NIST SP 1065, Table 5), and the relative standard
// error of a deviation of d degrees of freedom is 1 / sqrt(2 d).
class TestFlickerNoise : public QObject
{
    Q_OBJECT

private slots:
    void flicker_overThreeDecades_isFlatAtItsLine();
    void flicker_start_isStationary();
    void randomWalk_overTwoDecades_isOnItsLine();
    void simulator_whiteNoise_isOnItsLine();
    void simulator_whiteFlickerAndWalk_areOnTheirLines();
    void simulator_slowNoise_changesNoOtherRandomNumber();
};

namespace {

constexpr std::uint64_t kSeed = 20261122;

// The means of a noise over stretches of so many samples, on all axes.
template <class Noise>
Eigen::MatrixX3d stretchMeans(Noise noise, Eigen::Index stretches, int samples)
{
    Eigen::MatrixX3d means(stretches, kAxisCount);
    for (Eigen::Index i = 0; i < stretches; ++i) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (int k = 0; k < samples; ++k) {
            noise.advance();
            sum += noise.rateDps();
        }
        means.row(i) = sum.transpose() / samples;
    }
    return means;
}

// Averaging times in s; four a decade.
AllanCurve curveOf(const Eigen::MatrixX3d &rateDps, double intervalS)
{
    const auto last = static_cast<double>(rateDps.rows() - 1);
    return allanDeviation(Eigen::VectorXd::LinSpaced(rateDps.rows(), 0.0, last * intervalS), rateDps, 4);
}

// The largest relative distance from a line of the deviation of all axes and curves together.
template <class Line>
double worstDistance(const std::vector<AllanCurve> &curves, double fromS, double toS, const Line &lineDps)
{
    double worst = 0.0;
    int points = 0;
    for (Eigen::Index i = 0; i < curves.front().tauS.size(); ++i) {
        const double tauS = curves.front().tauS[i];
        if (tauS < fromS * 0.999 || tauS > toS * 1.001)
            continue;
        double squares = 0.0;
        for (const AllanCurve &curve : curves)
            squares += curve.deviationDps.row(i).squaredNorm();
        const double together = std::sqrt(squares / static_cast<double>(curves.size() * kAxisCount));
        const double distance = together / lineDps(tauS) - 1.0;
        qInfo("%g s: %+.2f %%", tauS, 100.0 * distance);
        worst = std::max(worst, std::abs(distance));
        ++points;
    }
    return points > 0 ? worst : INFINITY;
}

double flickerLine(double biasInstabilityDps)
{
    return biasInstabilityDps * std::sqrt(2.0 * std::numbers::ln2 / std::numbers::pi);
}

// A gyro without drift at a constant temperature.
SimulationOptions noiseOptions(double sampleRateHz, double samples)
{
    SimulationOptions options{*TemperatureProfile::build("hold", 20.0, {HoldSegment{samples / sampleRateHz}}),
                              *namedDriftCurves("none")};
    options.gyro.sampleRateHz = sampleRateHz;
    options.gyro.sensitivityMdps = 0.0;
    options.seed = kSeed;
    return options;
}

std::vector<AllanCurve> curvesOfRuns(const SimulationOptions &options, int runs)
{
    std::vector<AllanCurve> curves;
    for (int run = 0; run < runs; ++run)
        curves.push_back(curveOf(simulateRun(options, run)->rateDps, 1.0 / options.gyro.sampleRateHz));
    return curves;
}

void printSeed()
{
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
}

} // namespace

void TestFlickerNoise::flicker_overThreeDecades_isFlatAtItsLine()
{
    printSeed();
    constexpr double kRateHz = 32.0; // a node of 1 s
    const auto flat = [](double) { return flickerLine(0.003); };
    const FlickerNoise one(0.003, kRateHz, Random(kSeed));
    QVERIFY(worstDistance({curveOf(stretchMeans(one, 1 << 19, 32), 1.0)}, 5.0, 60.0, flat) < 0.05);
    const FlickerNoise other(0.003, kRateHz, Random(kSeed + 1));
    QVERIFY(worstDistance({curveOf(stretchMeans(other, 1 << 17, 32 * 40), 40.0)}, 40.0, 4000.0, flat) < 0.05);
}

void TestFlickerNoise::flicker_start_isStationary()
{
    printSeed();
    constexpr int kStarts = 4000;
    double atStart = 0.0;
    double later = 0.0;
    for (int i = 0; i < kStarts; ++i) {
        FlickerNoise noise(1.0, 32.0, Random(kSeed).fork(static_cast<std::uint64_t>(i)));
        atStart += noise.rateDps().squaredNorm() / (kStarts * kAxisCount);
        for (int k = 0; k < 32 * 64; ++k) // a node of the first seven processes
            noise.advance();
        later += noise.rateDps().squaredNorm() / (kStarts * kAxisCount);
    }
    // 22 processes; joining makes up for at most a tenth.
    const double expected = 22.0 * std::numbers::ln2 / std::numbers::pi;
    const double standardError = std::sqrt(2.0 / (kStarts * kAxisCount));
    QVERIFY(atStart / expected > 1.0 - 4.0 * standardError && atStart / expected < 1.1 + 4.0 * standardError);
    QVERIFY2(std::abs(later / atStart - 1.0) < 0.1, qPrintable(QString::number(later / atStart)));
}

void TestFlickerNoise::randomWalk_overTwoDecades_isOnItsLine()
{
    printSeed();
    constexpr double kWalk = 1e-4;
    const auto line = [](double tauS) { return kWalk * std::sqrt(tauS / 3.0); };
    const RateRandomWalk one(kWalk, 32.0, Random(kSeed));
    QVERIFY(worstDistance({curveOf(stretchMeans(one, 1 << 18, 32), 1.0)}, 10.0, 60.0, line) < 0.05);
    const RateRandomWalk other(kWalk, 32.0, Random(kSeed + 1));
    QVERIFY(worstDistance({curveOf(stretchMeans(other, 1 << 16, 32 * 40), 40.0)}, 40.0, 1000.0, line) < 0.05);
}

void TestFlickerNoise::simulator_whiteNoise_isOnItsLine()
{
    printSeed();
    for (const double sampleRateHz : {1.0, 10000.0}) {
        SimulationOptions options = noiseOptions(sampleRateHz, 2e6);
        const double density = options.gyro.noiseDps / std::sqrt(sampleRateHz);
        const auto line = [density](double tauS) { return density / std::sqrt(tauS); };
        const double intervalS = 1.0 / sampleRateHz;
        QVERIFY(worstDistance(curvesOfRuns(options, 1), intervalS, 1000.0 * intervalS, line) < 0.05);
    }
}

void TestFlickerNoise::simulator_whiteFlickerAndWalk_areOnTheirLines()
{
    printSeed();
    SimulationOptions options = noiseOptions(10.0, 2e6);
    options.gyro.noiseDps = 0.1;
    options.gyro.biasInstabilityDps = 0.01;
    options.gyro.rateRandomWalkDpsPerRootS = 7e-4;
    // Each prevails somewhere: at 0.1 s, about 30 s, and 400 s.
    const auto line = [&](double tauS) {
        const double white = options.gyro.noiseDps * std::sqrt(0.1 / tauS);
        const double walk = options.gyro.rateRandomWalkDpsPerRootS * std::sqrt(tauS / 3.0);
        return std::hypot(white, flickerLine(options.gyro.biasInstabilityDps), walk);
    };
    QVERIFY(worstDistance(curvesOfRuns(options, 4), 0.1, 400.0, line) < 0.05);
}

void TestFlickerNoise::simulator_slowNoise_changesNoOtherRandomNumber()
{
    SimulationOptions options = noiseOptions(10.0, 50000);
    const Recording without = *simulateRun(options, 0);
    const auto change = [&](double biasInstabilityDps, double walkDpsPerRootS) -> Eigen::MatrixX3d {
        options.gyro.biasInstabilityDps = biasInstabilityDps;
        options.gyro.rateRandomWalkDpsPerRootS = walkDpsPerRootS;
        const Recording with = *simulateRun(options, 0);
        if (with.temperatureC != without.temperatureC)
            qFatal("the temperature changed");
        return with.rateDps - without.rateDps;
    };
    const Eigen::MatrixX3d flicker = change(0.01, 0.0);
    const Eigen::MatrixX3d walk = change(0.0, 0.001);
    QVERIFY(flicker.cwiseAbs().maxCoeff() > 0.005 && walk.cwiseAbs().maxCoeff() > 0.005);
    QVERIFY((change(0.03, 0.002) - 3.0 * flicker - 2.0 * walk).cwiseAbs().maxCoeff() < 1e-12);
}

QTEST_APPLESS_MAIN(TestFlickerNoise)
#include "tst_flicker_noise.moc"
