// The running score against the batch computation (noise_floor.h) over the same samples.
#include "engine/base/random.h"
#include "engine/evaluation/noise_floor.h"
#include "engine/evaluation/running_score.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace driftbench;

class TestRunningScore : public QObject
{
    Q_OBJECT

private slots:
    void add_anyCut_givesTheBatchFigures_data();
    void add_anyCut_givesTheBatchFigures();
    void add_gapInTheTimes_leavesEmptyWindowsOut();
    void add_notFinite_isLeftOutAndCounted();
    void figures_withoutSamples_areNoNumbers();
};

namespace {

struct Series
{
    Eigen::VectorXd timeS;
    Eigen::MatrixX3d residualDps;
};

Series randomSeries(Random &random, Eigen::Index samples, double rateHz)
{
    Series series{Eigen::VectorXd(samples), Eigen::MatrixX3d(samples, 3)};
    double timeS = random.uniform(-50.0, 50.0);
    for (Eigen::Index i = 0; i < samples; ++i) {
        series.timeS[i] = timeS;
        timeS += (1.0 + 0.01 * random.normal()) / rateHz;
        for (int axis = 0; axis < 3; ++axis)
            series.residualDps(i, axis) = 0.3 * axis + random.normal() + std::sin(timeS / 30.0);
    }
    return series;
}

RunningScore scoreInParts(const Series &series, Random &random)
{
    RunningScore score;
    for (Eigen::Index first = 0; first < series.timeS.size();) {
        const auto most = static_cast<std::uint64_t>(series.timeS.size() - first);
        const auto count = static_cast<Eigen::Index>(1 + random.below(std::min<std::uint64_t>(most, 700)));
        score.add(series.timeS.segment(first, count), series.residualDps.middleRows(first, count));
        first += count;
    }
    return score;
}

bool nearlyEqual(const Eigen::Vector3d &a, const Eigen::Vector3d &b)
{
    return (a - b).cwiseAbs().maxCoeff() <= 1e-11 * b.cwiseAbs().maxCoeff();
}

} // namespace

void TestRunningScore::add_anyCut_givesTheBatchFigures_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<double>("rateHz");
    QTest::newRow("two samples") << 2 << 10.0;
    QTest::newRow("less than a window") << 60 << 10.0;
    QTest::newRow("interval not known yet") << 900 << 10.0;
    QTest::newRow("many windows") << 20000 << 10.0;
    QTest::newRow("fast") << 30000 << 1000.0;
    QTest::newRow("slower than a window") << 40 << 0.05;
}

void TestRunningScore::add_anyCut_givesTheBatchFigures()
{
    QFETCH(int, samples);
    QFETCH(double, rateHz);
    Random random(7);
    const Series series = randomSeries(random, samples, rateHz);
    const RunningScore score = scoreInParts(series, random);
    QCOMPARE(score.samples(), samples);
    const Eigen::Vector3d msd = series.residualDps.colwise().squaredNorm().transpose() / samples;
    QVERIFY(nearlyEqual(score.msdDps2(), msd));
    const auto windows = averagingWindows(series.timeS);
    QCOMPARE(score.windows(), static_cast<Eigen::Index>(windows.size()));
    if (windows.empty())
        QVERIFY(std::isnan(score.rms10sDps()[0]));
    else
        QVERIFY(nearlyEqual(score.rms10sDps(), rmsAfterAveraging(windows, series.residualDps)));
}

void TestRunningScore::add_gapInTheTimes_leavesEmptyWindowsOut()
{
    Random random(3);
    Series series = randomSeries(random, 6000, 10.0);
    series.timeS.tail(3000).array() += 1234.5;
    const RunningScore score = scoreInParts(series, random);
    QCOMPARE(score.windows(), static_cast<Eigen::Index>(averagingWindows(series.timeS).size()));
    QVERIFY(nearlyEqual(score.rms10sDps(), rmsAfterAveraging(series.timeS, series.residualDps)));
}

void TestRunningScore::add_notFinite_isLeftOutAndCounted()
{
    RunningScore score;
    Eigen::VectorXd timeS(3);
    timeS << 0.0, 0.1, 0.2;
    Eigen::MatrixX3d residual = Eigen::MatrixX3d::Constant(3, 3, 2.0);
    residual(1, 2) = std::numeric_limits<double>::quiet_NaN();
    score.add(timeS, residual);
    QCOMPARE(score.samples(), 2);
    QCOMPARE(score.leftOut(), 1);
    QCOMPARE(score.msdDps2()[2], 4.0);
}

void TestRunningScore::figures_withoutSamples_areNoNumbers()
{
    const RunningScore score;
    QVERIFY(std::isnan(score.msdDps2()[0]));
    QVERIFY(std::isnan(score.rms10sDps()[1]));
    QCOMPARE(score.windows(), 0);
}

QTEST_APPLESS_MAIN(TestRunningScore)
#include "tst_running_score.moc"
