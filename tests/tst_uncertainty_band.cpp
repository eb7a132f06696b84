#include "engine/evaluation/uncertainty_band.h"
#include "support/simple_recipes.h"
#include "support/thermal_runs.h"

#include <QTest>

using namespace driftbench;

class TestUncertaintyBand : public QObject
{
    Q_OBJECT

private slots:
    void band_freshRuns_coversTheirCurveAndSamples();
    void band_identicalRunsWithoutNoise_isNothing();
    void band_runsOffByConstants_isStudentsQuantile();
    void band_twoRuns_isOfNoiseOnly();
    void band_binsThatTwoRunsReach_haveNone();
};

static std::vector<AnyModel> leftOutModels(const TrainingSet &set)
{
    std::vector<AnyModel> models;
    for (std::size_t i = 0; i < set.runs.size(); ++i)
        models.push_back(test::fitGaussianRow(set.without(i)));
    return models;
}

struct Coverage
{
    double curve = 0.0;
    double sample = 0.0;
};

// Of one campaign's band: how much of fresh runs' true curves and of their samples is inside.
static Coverage coverageOf(Random &random)
{
    constexpr int kFreshRuns = 20;
    constexpr double kSpreadDps = 0.02;
    const test::RunPlan plan;
    TrainingSet set;
    for (int i = 0; i < 5; ++i)
        set.runs.push_back(test::makeRun("run", plan, test::bentCurve(random, kSpreadDps), random));
    const UncertaintyBand band = uncertaintyBand(set, leftOutModels(set));
    const RbfNetwork model = test::fitGaussianRow(set);
    const Eigen::MatrixX3d predicted = predictAtDeltaT(model, band.temperatureC);
    Coverage coverage;
    for (int fresh = 0; fresh < kFreshRuns; ++fresh) {
        const test::TdeOfDeltaT truth = test::bentCurve(random, kSpreadDps);
        for (Eigen::Index bin = 0; bin < band.temperatureC.size(); ++bin) {
            const Eigen::RowVector3d off = truth(band.temperatureC[bin]).transpose() - predicted.row(bin);
            const Eigen::RowVector3d noise(random.normal(), random.normal(), random.normal());
            const auto inside = [](const Eigen::RowVector3d &value, const Eigen::RowVector3d &half) {
                return static_cast<double>((value.array().abs() <= half.array()).count()) / 3.0;
            };
            coverage.curve += inside(off, band.curveHalfWidthDps.row(bin));
            coverage.sample += inside(off + plan.noiseDps * noise, band.sampleHalfWidthDps.row(bin));
        }
    }
    const double trials = kFreshRuns * static_cast<double>(band.temperatureC.size());
    return {coverage.curve / trials, coverage.sample / trials};
}

void TestUncertaintyBand::band_freshRuns_coversTheirCurveAndSamples()
{
    constexpr std::uint64_t kSeed = 41;
    constexpr int kCampaigns = 40;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    Coverage mean;
    for (int i = 0; i < kCampaigns; ++i) {
        const Coverage one = coverageOf(random);
        mean.curve += one.curve / kCampaigns;
        mean.sample += one.sample / kCampaigns;
    }
    qInfo("curve %.4f, sample %.4f", mean.curve, mean.sample);
    QVERIFY(mean.curve > 0.93 && mean.curve < 0.99);
    QVERIFY(mean.sample > 0.94 && mean.sample < 0.97);
}

void TestUncertaintyBand::band_identicalRunsWithoutNoise_isNothing()
{
    Random random(42);
    const test::TdeOfDeltaT truth = test::bentCurve(random, 0.0);
    TrainingSet set;
    for (int i = 0; i < 4; ++i)
        set.runs.push_back(test::makeRun("run", {2000, 0.5, 0.0, 80.0, 0.0}, truth, random));
    const UncertaintyBand band = uncertaintyBand(set, leftOutModels(set));
    QCOMPARE(band.runs, 4);
    // What the Gaussians of the test miss of the curve.
    QVERIFY(band.curveHalfWidthDps.maxCoeff() < 0.02);
}

void TestUncertaintyBand::band_runsOffByConstants_isStudentsQuantile()
{
    // Three runs at -a, 0, a: the models without one are off by 1.5 times its distance from the mean,
    // s^2 = a^2, and half the band is 4.3027 a sqrt(4 / 3) (t table, two degrees of freedom).
    Random random(43);
    constexpr double kOffset = 0.01;
    TrainingSet set;
    std::vector<AnyModel> models;
    for (const double offset : {-kOffset, 0.0, kOffset})
        set.runs.push_back(test::makeRun(
            "run", {2000, 0.5, 0.0, 80.0, 0.0},
            [offset](double) { return Eigen::Vector3d::Constant(offset).eval(); }, random));
    for (std::size_t i = 0; i < 3; ++i)
        models.push_back(fitConstant(set.without(i)));
    const UncertaintyBand band = uncertaintyBand(set, models);
    const double expected = 4.302653 * kOffset * std::sqrt(4.0 / 3.0);
    QCOMPARE(band.temperatureC.size(), Eigen::Index{64});
    QVERIFY((band.curveHalfWidthDps.array() / expected - 1.0).abs().maxCoeff() < 1e-6);
}

void TestUncertaintyBand::band_twoRuns_isOfNoiseOnly()
{
    Random random(44);
    TrainingSet set;
    for (int i = 0; i < 2; ++i)
        set.runs.push_back(
            test::makeRun("run", {40000, 0.5, 0.0, 80.0, 0.1}, test::bentCurve(random, 0.1), random));
    const UncertaintyBand band = uncertaintyBand(set, leftOutModels(set));
    QCOMPARE(band.runs, 2);
    QVERIFY(band.curveHalfWidthDps.array().isNaN().all());
    QVERIFY((band.sampleHalfWidthDps.array() / 0.196 - 1.0).abs().maxCoeff() < 0.02);
}

void TestUncertaintyBand::band_binsThatTwoRunsReach_haveNone()
{
    Random random(45);
    const test::TdeOfDeltaT truth = test::bentCurve(random, 0.0);
    const TrainingSet set{{test::makeRun("a", {}, truth, random), test::makeRun("b", {}, truth, random),
                           test::makeRun("c", {2000, 0.5, 0.0, 40.0, 0.1}, truth, random)},
                          20.0};
    const UncertaintyBand band = uncertaintyBand(set, leftOutModels(set));
    QCOMPARE(band.runs, 3);
    for (Eigen::Index bin = 0; bin < band.temperatureC.size(); ++bin) {
        const bool shared = band.temperatureC[bin] < 60.0;
        QCOMPARE(std::isfinite(band.curveHalfWidthDps(bin, 0)), shared);
        QCOMPARE(std::isfinite(band.sampleHalfWidthDps(bin, 0)), shared);
    }
}

QTEST_APPLESS_MAIN(TestUncertaintyBand)
#include "tst_uncertainty_band.moc"
