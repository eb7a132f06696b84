#include "engine/models/rbf_candidates.h"
#include "engine/models/rbf_path.h"
#include "engine/models/rbf_trainer.h"
#include "engine/models/run_alignment.h"
#include "support/simple_campaign.h"
#include "support/test_data.h"

#include <QTest>

#include <cmath>

using namespace driftbench;
using namespace driftbench::test;

class TestRbfTrainer : public QObject
{
    Q_OBJECT

private slots:
    void fit_networkOfTheClass_isRecoveredToRounding();
    void fit_curvedTruth_leavesLessThanThePerMille_data();
    void fit_curvedTruth_leavesLessThanThePerMille();
    void fit_noDrift_choosesNoCentres();
    void fit_anyNumberOfThreads_isBitIdentical();
    void fit_withSharedCache_isBitIdentical();
    void fit_runsThatStartElsewhere_meetOnOneCurve();
    void fit_gapInTemperature_staysCalmInside();
    void fit_singleRun_usesTemperatureBlocks();
    void fit_runsWithoutCommonTemperature_warns();
    void fit_stopped_isCancelled();
    void fit_noSamples_isRefused();
    void path_everyPrefix_predictsAsItsNetwork();
    void candidates_wholeRange_areAllLevels();
    void align_knownOffsets_areFound();
};

static Eigen::Vector3d curved(double d)
{
    return {0.03 * d + 0.3 * std::sin(d / 9.0), 2.0 - 0.04 * d + 0.0004 * d * d,
            0.4 * std::tanh((d - 30.0) / 3.0)};
}

static Eigen::VectorXd denseDeltaT(double low, double high)
{
    return Eigen::VectorXd::LinSpaced(2001, low, high);
}

static Eigen::MatrixX3d predicted(const RbfNetwork &network, const Eigen::VectorXd &deltaT)
{
    return network.predict(temperatureQuantities(RbfNetwork::kFeatures, deltaT));
}

static Eigen::MatrixX3d truthAt(const TrueCurve &curve, const Eigen::VectorXd &deltaT)
{
    Eigen::MatrixX3d truth(deltaT.size(), 3);
    for (Eigen::Index i = 0; i < deltaT.size(); ++i)
        truth.row(i) = curve(deltaT[i]).transpose();
    return truth;
}

void TestRbfTrainer::fit_networkOfTheClass_isRecoveredToRounding()
{
    // One temperature a cell, no noise: then the rows that are fitted hold the curve exactly.
    const Eigen::VectorXd deltaT = Eigen::VectorXd::LinSpaced(401, 0.0, 64.0);
    ThermalCurve grid(0.02);
    for (const double d : deltaT) {
        for (int repeat = 0; repeat < 50; ++repeat)
            grid.add(d, Eigen::Vector3d::Zero());
    }
    const ThermalRows rows = thermalRows(grid, trainingGridFactor(grid));
    const Standardiser inputs = Standardiser::fit(rows.quantities, rows.count);
    const RbfCandidates candidates = rbfCandidates(rows, inputs, {});
    RbfNetwork truth;
    truth.inputs = inputs;
    const Eigen::Index pick = 90;
    truth.centres = candidates.centres.row(pick);
    truth.widths = candidates.widths.segment(pick, 1);
    truth.weightsDps = Eigen::RowVector3d(1.5, -0.7, 0.2);
    truth.linearDps << 0.3, -0.2, 0.1, 0.05, 0.4, -0.3, 0.2, 0.1, 0.6;
    truth.biasDps = {-4.0, 1.0, 0.5};

    const Eigen::MatrixX3d tde = predicted(truth, deltaT);
    ThermalCurve curve(0.02);
    for (Eigen::Index i = 0; i < deltaT.size(); ++i) {
        for (int repeat = 0; repeat < 50; ++repeat)
            curve.add(deltaT[i], tde.row(i).transpose());
    }
    RbfPathOptions options;
    options.ridge = 0.0;
    const RbfPath path = makeRbfPath(curve, Eigen::Vector3d::Constant(1e-6), options);
    QCOMPARE(path.centreDeltaT.front(), candidates.centreDeltaT[pick]);
    const RbfNetwork found = networkOf(path, {1, 1, 1});
    QVERIFY((predicted(found, deltaT) - tde).cwiseAbs().maxCoeff() < 1e-11);
    QVERIFY((found.weightsDps - truth.weightsDps).cwiseAbs().maxCoeff() < 1e-9);
    QVERIFY((found.linearDps - truth.linearDps).cwiseAbs().maxCoeff() < 1e-9);
}

void TestRbfTrainer::fit_curvedTruth_leavesLessThanThePerMille_data()
{
    QTest::addColumn<int>("preset");
    QTest::addColumn<double>("mostOfNoiseVariance");
    QTest::newRow("best") << static_cast<int>(RbfPreset::Best) << 0.004;
    QTest::newRow("paper") << static_cast<int>(RbfPreset::Paper) << 0.05;
}

void TestRbfTrainer::fit_curvedTruth_leavesLessThanThePerMille()
{
    QFETCH(int, preset);
    QFETCH(double, mostOfNoiseVariance);
    const SimpleRunOptions runs{.samples = 30000, .noiseDps = 0.14};
    const TrainingSet set = simpleCampaign(5, &curved, runs, 0.0, 7);
    RbfOptions options;
    options.preset = static_cast<RbfPreset>(preset);
    const auto fit = fitRbfNetwork(set, options);
    QVERIFY(fit.ok());
    const Eigen::VectorXd deltaT = denseDeltaT(0.0, 60.0);
    const Eigen::MatrixX3d error = predicted(fit->network, deltaT) - truthAt(&curved, deltaT);
    const Eigen::RowVector3d meanSquare = error.cwiseAbs2().colwise().mean() / (0.14 * 0.14);
    for (int axis = 0; axis < 3; ++axis)
        QVERIFY2(meanSquare[axis] < mostOfNoiseVariance, qPrintable(QString::number(meanSquare[axis])));
}

void TestRbfTrainer::fit_noDrift_choosesNoCentres()
{
    const TrainingSet set =
        simpleCampaign(5, [](double) { return Eigen::Vector3d(0.1, -0.2, 0.0); }, {.samples = 30000});
    const auto fit = fitRbfNetwork(set);
    QVERIFY(fit.ok());
    QCOMPARE(fit->network.centreCount, (std::array<int, 3>{0, 0, 0}));
    QCOMPARE(fit->network.size(), Eigen::Index(0));
}

static bool identical(const RbfNetwork &a, const RbfNetwork &b)
{
    return a.centres == b.centres && a.widths == b.widths && a.weightsDps == b.weightsDps &&
           a.linearDps == b.linearDps && a.biasDps == b.biasDps && a.centreCount == b.centreCount;
}

void TestRbfTrainer::fit_anyNumberOfThreads_isBitIdentical()
{
    const TrainingSet set = simpleCampaign(4, &curved, {}, 0.002);
    const auto one = fitRbfNetwork(set, RbfOptions{.threads = 1});
    const auto many = fitRbfNetwork(set, RbfOptions{.threads = 7});
    QVERIFY(one.ok() && many.ok());
    QVERIFY(identical(one->network, many->network));
}

void TestRbfTrainer::fit_withSharedCache_isBitIdentical()
{
    const TrainingSet set = simpleCampaign(4, &curved, {}, 0.002);
    const auto cache = makeRbfPathCache();
    for (std::size_t left = 0; left < set.runs.size(); ++left) {
        const auto alone = fitRbfNetwork(set.without(left));
        const auto shared = fitRbfNetwork(set.without(left), {}, {}, cache);
        QVERIFY(alone.ok() && shared.ok());
        QVERIFY(identical(alone->network, shared->network));
    }
}

void TestRbfTrainer::fit_runsThatStartElsewhere_meetOnOneCurve()
{
    // Each run has its own bias and covers another part: the curve's shape must come out without steps.
    TrainingSet set;
    Random random(11);
    const double starts[] = {0.0, 15.0, 30.0};
    for (int i = 0; i < 3; ++i) {
        SimpleRunOptions options{.lowestDeltaT = starts[i], .highestDeltaT = starts[i] + 30.0};
        options.offsetDps = Eigen::Vector3d::Constant(0.5 * (i - 1));
        set.runs.push_back(simpleRun("run" + std::to_string(i), &curved, options, random.fork(i)));
    }
    const auto fit = fitRbfNetwork(set);
    QVERIFY(fit.ok());
    const Eigen::VectorXd deltaT = denseDeltaT(1.0, 59.0);
    Eigen::MatrixX3d error = predicted(fit->network, deltaT) - truthAt(&curved, deltaT);
    error.rowwise() -= error.colwise().mean().eval();
    QVERIFY2(error.cwiseAbs().maxCoeff() < 0.05, qPrintable(QString::number(error.cwiseAbs().maxCoeff())));
}

void TestRbfTrainer::fit_gapInTemperature_staysCalmInside()
{
    TrainingSet set;
    Random random(13);
    for (int i = 0; i < 4; ++i) {
        const auto low = simpleRun("low", &curved, {.highestDeltaT = 20.0}, random.fork(2 * i));
        const auto high = simpleRun("high", &curved, {.lowestDeltaT = 40.0}, random.fork(2 * i + 1));
        auto both = std::make_shared<RunFeatures>(*low);
        both->curve.merge(high->curve);
        set.runs.push_back(both);
    }
    const auto fit = fitRbfNetwork(set);
    QVERIFY(fit.ok());
    const Eigen::MatrixX3d inside = predicted(fit->network, denseDeltaT(20.0, 40.0));
    QVERIFY2(inside.cwiseAbs().maxCoeff() < 4.0, qPrintable(QString::number(inside.cwiseAbs().maxCoeff())));
}

void TestRbfTrainer::fit_singleRun_usesTemperatureBlocks()
{
    const TrainingSet set = simpleCampaign(1, &curved, {.samples = 30000});
    const auto fit = fitRbfNetwork(set);
    QVERIFY(fit.ok());
    QVERIFY(!fit->selection.leftOutRuns);
    const Eigen::VectorXd deltaT = denseDeltaT(0.0, 60.0);
    const Eigen::MatrixX3d error = predicted(fit->network, deltaT) - truthAt(&curved, deltaT);
    QVERIFY2(error.cwiseAbs().maxCoeff() < 0.03, qPrintable(QString::number(error.cwiseAbs().maxCoeff())));
}

void TestRbfTrainer::fit_runsWithoutCommonTemperature_warns()
{
    TrainingSet set;
    set.runs.push_back(simpleRun("low", &curved, {.highestDeltaT = 20.0}, Random(1)));
    set.runs.push_back(simpleRun("high", &curved, {.lowestDeltaT = 40.0}, Random(2)));
    const auto fit = fitRbfNetwork(set);
    QVERIFY(fit.ok());
    QCOMPARE(fit->warnings.size(), std::size_t(1));
    QVERIFY(fit->warnings.front().find("share no temperature") != std::string::npos);
}

void TestRbfTrainer::fit_stopped_isCancelled()
{
    const TrainingSet set = simpleCampaign(3, &curved);
    const auto fit = fitRbfNetwork(set, {}, [](const Progress &) { return Flow::Stop; });
    QVERIFY(!fit.ok());
    QCOMPARE(fit.error().code, Errc::Cancelled);
}

void TestRbfTrainer::fit_noSamples_isRefused()
{
    const auto fit = fitRbfNetwork(TrainingSet{});
    QVERIFY(!fit.ok());
    QCOMPARE(fit.error().code, Errc::TooFewSamples);
}

void TestRbfTrainer::path_everyPrefix_predictsAsItsNetwork()
{
    const TrainingSet set = simpleCampaign(3, &curved, {}, 0.002);
    const RbfPath path = makeRbfPath(set, {});
    QVERIFY(path.size() > 5);
    const ThermalRows rows = thermalRows(set.runs[0]->curve, 20);
    const Eigen::MatrixX3d losses = prefixLosses(path, rows, false);
    for (const int k : {0, 1, 5, path.size()}) {
        const Eigen::MatrixX3d left = rows.tdeDps - networkOf(path, {k, k, k}).predict(rows.quantities);
        const Eigen::RowVector3d loss = (rows.count / rows.count.sum()).transpose() * left.cwiseAbs2();
        const Eigen::RowVector3d expected = losses.row(k).cwiseProduct(path.noiseVariance.transpose());
        QVERIFY((loss - expected).cwiseAbs().maxCoeff() < 1e-9);
    }
}

void TestRbfTrainer::candidates_wholeRange_areAllLevels()
{
    // 2^(l + 1) + 1 centres on each of seven levels: 261 in all.
    const TrainingSet set = simpleCampaign(1, &curved, {.highestDeltaT = 125.0, .samples = 60000});
    const ThermalRows rows = thermalRows(set.runs[0]->curve, trainingGridFactor(set.runs[0]->curve));
    const Standardiser inputs = Standardiser::fit(rows.quantities, rows.count);
    QCOMPARE(rbfCandidates(rows, inputs, {}).widths.size(), Eigen::Index(261));
}

void TestRbfTrainer::align_knownOffsets_areFound()
{
    TrainingSet set;
    Random random(17);
    const Eigen::Matrix<double, 3, 3> offsets{{0.3, -0.1, 0.0}, {-0.5, 0.2, 0.1}, {0.2, -0.1, -0.1}};
    for (int i = 0; i < 3; ++i) {
        SimpleRunOptions options{.lowestDeltaT = 10.0 * i, .highestDeltaT = 40.0 + 10.0 * i, .noiseDps = 0.0};
        options.offsetDps = offsets.row(i).transpose();
        // A curve that is flat has the same mean in every cell, so the offsets come out to rounding.
        set.runs.push_back(simpleRun(
            "run", [](double) { return Eigen::Vector3d(1.0, 2.0, 3.0); }, options, random.fork(i)));
    }
    const RunAlignment alignment = alignRuns(set);
    QCOMPARE(alignment.groups, 1);
    QVERIFY((alignment.offsetDps - offsets).cwiseAbs().maxCoeff() < 1e-9);
    QVERIFY(alignment.offsetDps.colwise().sum().cwiseAbs().maxCoeff() < 1e-12);
}

QTEST_APPLESS_MAIN(TestRbfTrainer)
#include "tst_rbf_trainer.moc"
