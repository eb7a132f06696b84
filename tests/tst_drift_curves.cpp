#include "support/simulated_runs.h"

#include <Eigen/QR>
#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestDriftCurves : public QObject
{
    Q_OBJECT

private slots:
    void namedDriftCurves_overThePapersProfile_haveTheStatedSize();
    void namedDriftCurves_unknown_listsTheKnownOnes();
    void driftTable_anyTemperature_isTheFunction();
};

namespace {

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

} // namespace

void TestDriftCurves::namedDriftCurves_overThePapersProfile_haveTheStatedSize()
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

void TestDriftCurves::namedDriftCurves_unknown_listsTheKnownOnes()
{
    const auto curves = namedDriftCurves("bent");
    QVERIFY(!curves.ok());
    QCOMPARE(curves.error().code, Errc::InvalidOption);
    for (const std::string_view name : kDriftCurveNames)
        QVERIFY(curves.error().message.find(name) != std::string::npos);
}

void TestDriftCurves::driftTable_anyTemperature_isTheFunction()
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

QTEST_APPLESS_MAIN(TestDriftCurves)
#include "tst_drift_curves.moc"
