#include "engine/evaluation/noise_floor.h"
#include "support/thermal_runs.h"

#include <QTest>

using namespace driftbench;

class TestNoiseFloor : public QObject
{
    Q_OBJECT

private slots:
    void noiseFloor_whiteNoiseOnASlope_isTheNoiseAndTheTrendInsideACell();
    void noiseFloor_fewSamplesACell_isNotTooLow();
    void noiseFloor_noCellWithTwoSamples_isNaN();
    void noiseFloor_outliersLeftOutOfTraining_count();
    void rmsAfterAveraging_constant_isTheConstant();
    void rmsAfterAveraging_whiteNoise_fallsByTheRootOfTheSamples();
    void rmsAfterAveraging_alternatingSigns_isZero();
    void averagingWindows_gap_leavesOutWhatIsLessThanHalfFull();
};

void TestNoiseFloor::noiseFloor_whiteNoiseOnASlope_isTheNoiseAndTheTrendInsideACell()
{
    Random random(11);
    const auto run = test::makeRun(
        "run", {200000, 0.1, 0.0, 50.0, 0.2},
        [](double d) { return Eigen::Vector3d(0.0, d, 10.0 * std::sin(d)); }, random);
    const Eigen::Vector3d floor = noiseFloor(*run);
    // A uniform stretch of 0.5 degrees has the variance 0.5^2 / 12, times the slope squared.
    QVERIFY(std::abs(floor[0] / 0.04 - 1.0) < 0.02);
    QVERIFY(std::abs(floor[1] / (0.04 + 0.25 / 12.0) - 1.0) < 0.02);
}

void TestNoiseFloor::noiseFloor_fewSamplesACell_isNotTooLow()
{
    // Two samples a cell: without the correction for degrees of freedom the figure would be half.
    Random random(12);
    double mean = 0.0;
    constexpr int kRuns = 200;
    for (int i = 0; i < kRuns; ++i) {
        const auto run = test::makeRun(
            "run", {200, 1.0, 0.0, 50.0, 0.2}, [](double) { return Eigen::Vector3d::Zero().eval(); }, random);
        mean += noiseFloor(*run)[0] / kRuns;
    }
    QVERIFY2(std::abs(mean / 0.04 - 1.0) < 0.03, qPrintable(QString::number(mean)));
}

void TestNoiseFloor::noiseFloor_noCellWithTwoSamples_isNaN()
{
    Random random(13);
    const auto run = test::makeRun(
        "run", {10, 1.0, 0.0, 50.0, 0.2}, [](double) { return Eigen::Vector3d::Zero().eval(); }, random);
    QVERIFY(noiseFloor(*run).array().isNaN().all());
}

void TestNoiseFloor::noiseFloor_outliersLeftOutOfTraining_count()
{
    Random random(14);
    auto run = test::makeRun(
        "run", {50000, 0.1, 0.0, 50.0, 0.1}, [](double) { return Eigen::Vector3d::Zero().eval(); }, random);
    run->curve = ThermalCurve();
    for (Eigen::Index i = 0; i < run->deltaT.size(); ++i) {
        if (i % 100 == 0) {
            run->tdeDps(i, 0) += 3.0;
            run->usableForTraining[static_cast<std::size_t>(i)] = 0;
        } else {
            run->curve.add(run->deltaT[i], run->tdeDps.row(i).transpose());
        }
    }
    // Every hundredth sample is off by 3 dps: 0.01 * 0.99 * 9 is added to the variance.
    QVERIFY(std::abs(noiseFloor(*run)[0] / (0.01 + 0.0891) - 1.0) < 0.02);
}

static Eigen::VectorXd times(Eigen::Index count, double intervalS)
{
    return Eigen::VectorXd::LinSpaced(count, 0.0, intervalS * static_cast<double>(count - 1));
}

void TestNoiseFloor::rmsAfterAveraging_constant_isTheConstant()
{
    const Eigen::MatrixX3d residual = Eigen::RowVector3d(0.3, -0.2, 0.0).replicate(1000, 1);
    const Eigen::Vector3d rms = rmsAfterAveraging(times(1000, 0.1), residual);
    QVERIFY((rms - Eigen::Vector3d(0.3, 0.2, 0.0)).norm() < 1e-12);
}

void TestNoiseFloor::rmsAfterAveraging_whiteNoise_fallsByTheRootOfTheSamples()
{
    Random random(15);
    Eigen::MatrixX3d residual(200000, 3);
    for (Eigen::Index i = 0; i < residual.size(); ++i)
        residual.data()[i] = random.normal();
    const Eigen::Vector3d rms = rmsAfterAveraging(times(200000, 0.1), residual);
    QVERIFY((rms.array() / 0.1 - 1.0).abs().maxCoeff() < 0.06); // 100 samples a window, 2000 windows
}

void TestNoiseFloor::rmsAfterAveraging_alternatingSigns_isZero()
{
    Eigen::MatrixX3d residual(1000, 3);
    for (Eigen::Index i = 0; i < 1000; ++i)
        residual.row(i).setConstant(i % 2 == 0 ? 1.0 : -1.0);
    QVERIFY(rmsAfterAveraging(times(1000, 0.5), residual).maxCoeff() < 1e-12);
}

void TestNoiseFloor::averagingWindows_gap_leavesOutWhatIsLessThanHalfFull()
{
    Eigen::VectorXd timeS(34);
    for (Eigen::Index i = 0; i < 20; ++i)
        timeS[i] = static_cast<double>(i); // two full windows
    for (Eigen::Index i = 20; i < 24; ++i)
        timeS[i] = static_cast<double>(i) + 6.0; // four samples of the third
    for (Eigen::Index i = 24; i < 34; ++i)
        timeS[i] = static_cast<double>(i) + 26.0; // the sixth
    const std::vector<TimeWindow> windows = averagingWindows(timeS);
    QCOMPARE(windows.size(), std::size_t{3});
    QCOMPARE(windows[1].first, Eigen::Index{10});
    QCOMPARE(windows[2].first, Eigen::Index{24});
    QCOMPARE(windows[2].last, Eigen::Index{34});
}

QTEST_APPLESS_MAIN(TestNoiseFloor)
#include "tst_noise_floor.moc"
