#include "engine/evaluation/comparison.h"
#include "engine/evaluation/paper_improvements.h"
#include "support/recorded_run.h"
#include "support/simple_recipes.h"
#include "support/test_data.h"
#include "support/thermal_runs.h"

#include <QTest>

#include <thread>

using namespace driftbench;

class TestComparison : public QObject
{
    Q_OBJECT

private slots:
    void compare_leaveOneRunOut_rowsAreWhatTheResidualsSay();
    void compare_heldOutRunChanged_itsModelIsTheSameBitForBit();
    void compare_threads_changeNothing();
    void compare_repeatableCurve_isAYesForTheRightModel();
    void compare_straightLine_recommendsTheLine();
    void compare_noDrift_saysSoAndKeepsTheConstant();
    void compare_runsThatDisagree_areNotRepeatable();
    void compare_oneRun_isJudgedInBlocksWithCareAtMost();
    void compare_holdOut_trainsOnTheRestAlone();
    void compare_anchored_ignoresTheTurnOnBias();
    void compare_outsideTheTrainedRange_holdsTheEdge();
    void compare_onlyTheConstant_recommendsIt();
    void compare_stopAsked_isCancelledFromTheCallingThread();
    void compare_failingRecipe_isItsError();
    void evaluateModel_trainedModel_isWhatTheFoldSaid();
    void paperImprovements_ratiosAndSigns();
    void chamber_constantAndCubic_leaveThePublishedRms();
    void chamber_anchored_yStaysAYes();
};

static std::vector<ModelRecipe> recipes()
{
    return {test::constantRecipe(), test::linearRecipe(), test::cubicRecipe(), test::gaussianRecipe()};
}

static TrainingSet campaign(std::uint64_t seed, int runs, double spreadDps, const test::RunPlan &plan = {})
{
    Random random(seed);
    TrainingSet set{{}, -40.0};
    for (int i = 0; i < runs; ++i)
        set.runs.push_back(
            test::makeRun("run" + std::to_string(i + 1), plan, test::bentCurve(random, spreadDps), random));
    return set;
}

static const ComparisonRow &rowOf(const Comparison &comparison, const std::string &run, int axis,
                                  const std::string &model)
{
    for (const ComparisonRow &row : comparison.rows) {
        if (row.run == run && row.axis == axis && row.model == model)
            return row;
    }
    qFatal("no such row");
}

void TestComparison::compare_leaveOneRunOut_rowsAreWhatTheResidualsSay()
{
    const TrainingSet set = campaign(61, 3, 0.01);
    const auto comparison = compareRecipes(recipes(), set, {{"I3G4250D", "7"}, true});
    QVERIFY(comparison.ok());
    QCOMPARE(comparison->rows.size(), std::size_t{3 * 3 * 4});
    QVERIFY(comparison->options.models == (std::vector<std::string>{"constant", "linear", "cubic", "rbf"}));
    const ComparisonRow &row = rowOf(*comparison, "run2", 1, "linear");
    const RunFeatures &run = *set.runs[1];
    const LinearModel line = fitLinear(set.without(1));
    const Eigen::VectorXd left =
        run.tdeDps.col(1).array() - line.biasDps[1] - line.slopeDpsPerC[1] * run.deltaT.array();
    const double before = run.tdeDps.col(1).squaredNorm() / 2000.0;
    QVERIFY(std::abs(row.msdBefore / before - 1.0) < 1e-12);
    QVERIFY(std::abs(row.msdAfter * 2000.0 / left.squaredNorm() - 1.0) < 1e-4); // the edge is held
    QCOMPARE(row.q, row.msdAfter / row.msdBefore);
    QCOMPARE(row.rmsDps, std::sqrt(row.msdAfter));
    QCOMPARE(row.excessOverFloor, (row.msdAfter - row.noiseFloor) / row.noiseFloor);
    QVERIFY(std::abs(row.noiseFloor / 0.01 - 1.0) < 0.1);
    QVERIFY(row.rms10sDps < row.rmsDps && row.rms10sDps > 0.0);
    QVERIFY(row.biasInstabilityDps > 0.0);
    QCOMPARE(row.samples, Eigen::Index{2000});
    QVERIFY(row.trainedOn == (std::vector<std::string>{"run1", "run3"}));
    QVERIFY(comparison->rows[4].axis == 1 && comparison->rows[4].model == "constant");
    const TrainedModel &linear = comparison->models[1];
    QVERIFY(linear.simulated && linear.sensor.serial == "7");
    QCOMPARE(linear.trainedOn.size(), std::size_t{3});
    QVERIFY(std::abs(linear.lowestTemperatureC + 40.0) < 0.1 &&
            std::abs(linear.highestTemperatureC - 40.0) < 0.1);
    QVERIFY(linear.band && linear.band->runs == 3);
    QCOMPARE(comparison->models.back().name, std::string("auto"));
}

void TestComparison::compare_heldOutRunChanged_itsModelIsTheSameBitForBit()
{
    const TrainingSet set = campaign(62, 4, 0.01);
    TrainingSet changed = set;
    auto wild = std::make_shared<RunFeatures>(*set.runs[2]);
    for (Eigen::Index i = 0; i < wild->tdeDps.rows(); ++i)
        wild->tdeDps.row(i).array() += 1000.0 * std::sin(0.37 * static_cast<double>(i * i));
    wild->deltaT.array() *= 1.5;
    wild->curve = ThermalCurve();
    wild->curve.add(wild->deltaT, wild->tdeDps);
    changed.runs[2] = wild;
    const auto plain = compareRecipes(recipes(), set, {});
    const auto other = compareRecipes(recipes(), changed, {});
    QVERIFY(plain.ok() && other.ok());
    const Eigen::VectorXd grid = Eigen::VectorXd::LinSpaced(200, -5.0, 90.0);
    for (std::size_t fold = 0; fold < 4; ++fold) {
        for (std::size_t m = 0; m < 4; ++m) {
            const bool same = predictAtDeltaT(plain->folds[fold].models[m].model, grid) ==
                              predictAtDeltaT(other->folds[fold].models[m].model, grid);
            QCOMPARE(same, fold == 2);
        }
    }
    // The judged run's own scores did change.
    QVERIFY(rowOf(*other, "run3", 0, "rbf").msdAfter > 1e4);
}

void TestComparison::compare_threads_changeNothing()
{
    const TrainingSet set = campaign(63, 4, 0.02);
    ComparisonOptions options;
    options.threads = 1;
    const auto one = compareRecipes(recipes(), set, {}, options);
    options.threads = 7;
    const auto seven = compareRecipes(recipes(), set, {}, options);
    QVERIFY(one.ok() && seven.ok());
    for (std::size_t i = 0; i < one->rows.size(); ++i) {
        QCOMPARE(one->rows[i].msdAfter, seven->rows[i].msdAfter);
        QCOMPARE(one->rows[i].biasInstabilityDps, seven->rows[i].biasInstabilityDps);
    }
    QCOMPARE(one->verdicts[0].reason, seven->verdicts[0].reason);
}

void TestComparison::compare_repeatableCurve_isAYesForTheRightModel()
{
    const auto comparison = compareRecipes(recipes(), campaign(64, 5, 0.005), {});
    QVERIFY(comparison.ok());
    for (int axis = 0; axis < 3; ++axis) {
        const AxisVerdict &verdict = comparison->verdicts[static_cast<std::size_t>(axis)];
        QVERIFY2(verdict.verdict == Verdict::Yes, verdict.reason.c_str());
        QVERIFY(verdict.gain > 0.98 && verdict.gainModelFree > 0.97);
    }
    // x is a parabola, which the cubic has; z has a tanh, which it has not.
    QVERIFY(comparison->verdicts[0].model == "cubic" || comparison->verdicts[0].model == "rbf");
    QCOMPARE(comparison->verdicts[2].model, std::string("rbf"));
    const auto &perAxis = std::get<PerAxisModel>(comparison->models.back().model);
    QCOMPARE(perAxis.axes[2]->name, std::string("rbf"));
    QVERIFY(comparison->models.back().band.has_value());
    QVERIFY(!comparison->models[0].verdicts[0].has_value());
    // The line has a verdict of its own.
    QVERIFY(comparison->models[1].verdicts[0].has_value());
    QVERIFY(comparison->models[1].summary.contains("held_out_rms_x_dps"));
}

void TestComparison::compare_straightLine_recommendsTheLine()
{
    int line = 0;
    constexpr int kSeeds = 20;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        Random random(seed);
        TrainingSet set;
        for (int i = 0; i < 5; ++i)
            set.runs.push_back(test::makeRun(
                "run", {}, [](double d) { return Eigen::Vector3d(0.01 * d, -0.02 * d, 0.005 * d); }, random));
        const auto comparison = compareRecipes(recipes(), set, {});
        for (const AxisVerdict &verdict : comparison->verdicts) {
            QVERIFY(verdict.verdict == Verdict::Yes);
            line += verdict.model == "linear" ? 1 : 0;
        }
    }
    QVERIFY2(line >= 45, qPrintable(QStringLiteral("%1 of 60").arg(line)));
}

void TestComparison::compare_noDrift_saysSoAndKeepsTheConstant()
{
    Random random(66);
    TrainingSet set;
    for (int i = 0; i < 5; ++i)
        set.runs.push_back(test::makeRun(
            "run", {}, [](double) { return Eigen::Vector3d(0.5, -1.0, 0.0); }, random));
    const auto comparison = compareRecipes(recipes(), set, {});
    QVERIFY(comparison.ok());
    for (const AxisVerdict &verdict : comparison->verdicts) {
        QVERIFY2(verdict.verdict == Verdict::NoDrift, verdict.reason.c_str());
        QCOMPARE(verdict.model, std::string("constant"));
    }
    const Eigen::MatrixX3d corrected =
        predictAtDeltaT(comparison->models.back().model, Eigen::VectorXd::LinSpaced(5, 0.0, 80.0));
    QVERIFY((corrected.rowwise() - Eigen::RowVector3d(0.5, -1.0, 0.0)).cwiseAbs().maxCoeff() < 0.01);
}

void TestComparison::compare_runsThatDisagree_areNotRepeatable()
{
    // Each run has a curve of its own, none in common.
    Random random(67);
    TrainingSet set;
    for (const double sign : {1.0, -1.0, 1.0, -1.0})
        set.runs.push_back(test::makeRun(
            "run" + std::to_string(set.runs.size()), {},
            [sign](double d) { return Eigen::Vector3d::Constant(sign * std::sin(d / 10.0)).eval(); },
            random));
    const auto comparison = compareRecipes(recipes(), set, {});
    for (const AxisVerdict &verdict : comparison->verdicts) {
        QVERIFY2(verdict.verdict == Verdict::NotRepeatable, verdict.reason.c_str());
        QCOMPARE(verdict.model, std::string("constant"));
        QVERIFY(verdict.gain < 0.1 && verdict.gainModelFree < 0.1);
        QVERIFY(verdict.reason.find("the runs read") != std::string::npos);
    }
}

void TestComparison::compare_oneRun_isJudgedInBlocksWithCareAtMost()
{
    const auto comparison = compareRecipes(recipes(), campaign(68, 1, 0.01), {});
    QVERIFY(comparison.ok());
    QCOMPARE(comparison->folds.size(), std::size_t{5});
    QCOMPARE(comparison->rows.size(), std::size_t{5 * 3 * 4});
    QVERIFY(comparison->rows[0].run == "run1, block 1");
    for (const AxisVerdict &verdict : comparison->verdicts) {
        QVERIFY2(verdict.verdict == Verdict::WithCare, verdict.reason.c_str());
        QVERIFY(verdict.gain > 0.95);
        QVERIFY(std::isnan(verdict.gainModelFree));
    }
    QVERIFY(!comparison->models.back().band.has_value());
    QCOMPARE(comparison->warnings.size(), std::size_t{1});
}

void TestComparison::compare_holdOut_trainsOnTheRestAlone()
{
    const TrainingSet set = campaign(69, 4, 0.01);
    ComparisonOptions options;
    options.holdOut = {"run4"};
    const auto comparison = compareRecipes(recipes(), set, {}, options);
    QVERIFY(comparison.ok());
    QCOMPARE(comparison->folds.size(), std::size_t{1});
    QCOMPARE(comparison->rows.size(), std::size_t{12});
    QVERIFY(comparison->models[3].trainedOn == (std::vector<std::string>{"run1", "run2", "run3"}));
    const RbfNetwork same = test::fitGaussianRow(set.without(3));
    const Eigen::VectorXd grid = Eigen::VectorXd::LinSpaced(50, 0.0, 80.0);
    QVERIFY(predictAtDeltaT(comparison->models[3].model, grid) == predictAtDeltaT(same, grid));
    QVERIFY(!comparison->models[3].band.has_value());
    options.holdOut = {"run9"};
    const auto unknown = compareRecipes(recipes(), set, {}, options);
    QVERIFY(!unknown.ok() && unknown.error().code == Errc::InvalidOption);
}

void TestComparison::compare_anchored_ignoresTheTurnOnBias()
{
    Random random(70);
    TrainingSet set;
    for (const double bias : {-2.0, 0.5, 1.5, 3.0})
        set.runs.push_back(test::makeRun(
            "run", {}, [bias](double d) { return Eigen::Vector3d::Constant(bias + 0.01 * d).eval(); },
            random));
    ComparisonOptions options;
    const auto absolute = compareRecipes(recipes(), set, {}, options);
    options.judging = Judging::Anchored;
    const auto anchored = compareRecipes(recipes(), set, {}, options);
    QVERIFY(absolute.ok() && anchored.ok());
    QVERIFY(absolute->verdicts[0].verdict == Verdict::NotRepeatable);
    QVERIFY2(anchored->verdicts[0].verdict == Verdict::Yes, anchored->verdicts[0].reason.c_str());
    QCOMPARE(anchored->models[1].judging, std::string("anchored"));
    for (const ComparisonRow &row : anchored->rows) {
        if (row.model == "linear") // noise, and what 121 samples at the start leave of it
            QVERIFY(row.msdAfter < 0.0112 && row.msdAfter > 0.009);
        if (row.model == "constant")
            QVERIFY(std::abs(row.msdAfter / row.msdBefore - 1.0) < 1e-9);
    }
}

void TestComparison::compare_outsideTheTrainedRange_holdsTheEdge()
{
    Random random(71);
    const auto ramp = [](double d) { return Eigen::Vector3d::Constant(0.1 * d).eval(); };
    const TrainingSet set{{test::makeRun("short", {2000, 0.5, 0.0, 40.0, 0.001}, ramp, random),
                           test::makeRun("long", {2000, 0.5, 0.0, 80.0, 0.001}, ramp, random)},
                          0.0};
    const auto comparison = compareRecipes({test::linearRecipe()}, set, {});
    // From 40 to 80 degrees the held value is off by 0.1 (d - 40): a mean square of 16 / 3 over half the run.
    QVERIFY(std::abs(rowOf(*comparison, "long", 0, "linear").msdAfter / (16.0 / 6.0) - 1.0) < 0.01);
}

void TestComparison::compare_onlyTheConstant_recommendsIt()
{
    const auto comparison = compareRecipes({test::constantRecipe()}, campaign(72, 3, 0.01), {});
    QVERIFY(comparison.ok());
    QCOMPARE(comparison->verdicts[0].model, std::string("constant"));
    QCOMPARE(comparison->verdicts[0].gain, 0.0);
    QVERIFY(!compareRecipes({}, campaign(72, 3, 0.01), {}).ok());
}

void TestComparison::compare_stopAsked_isCancelledFromTheCallingThread()
{
    const auto caller = std::this_thread::get_id();
    bool elsewhere = false;
    double highest = 0.0;
    const auto watch = [&](const Progress &progress) {
        elsewhere = elsewhere || std::this_thread::get_id() != caller;
        highest = std::max(highest, progress.fraction);
        return Flow::Continue;
    };
    ComparisonOptions options;
    options.threads = 4;
    QVERIFY(compareRecipes(recipes(), campaign(73, 4, 0.01), {}, options, watch).ok());
    QVERIFY(!elsewhere);
    QCOMPARE(highest, 1.0);
    for (int stopAfter = 1; stopAfter < 3; ++stopAfter) {
        int calls = 0;
        const auto stopped = compareRecipes(recipes(), campaign(73, 4, 0.01), {}, {}, [&](const Progress &) {
            return ++calls >= stopAfter ? Flow::Stop : Flow::Continue;
        });
        QVERIFY(!stopped.ok() && stopped.error().code == Errc::Cancelled);
    }
}

void TestComparison::compare_failingRecipe_isItsError()
{
    const ModelRecipe failing{
        "rbf", 5, [](const TrainingSet &set, const ProgressHook &) -> Result<FittedModel> {
            return Error{Errc::TooFewSamples, "Only " + std::to_string(set.runs.size()) + " runs."};
        }};
    const auto comparison = compareRecipes({test::constantRecipe(), failing}, campaign(74, 3, 0.01), {});
    QVERIFY(!comparison.ok());
    QVERIFY(comparison.error().code == Errc::TooFewSamples);
    QCOMPARE(comparison.error().message, std::string("Only 2 runs."));
}

void TestComparison::evaluateModel_trainedModel_isWhatTheFoldSaid()
{
    const TrainingSet set = campaign(75, 3, 0.01);
    ComparisonOptions options;
    options.holdOut = {"run2"};
    const auto comparison = compareRecipes(recipes(), set, {}, options);
    const auto rows = evaluateModel(comparison->models[3], set.runs[1], Judging::Absolute);
    QCOMPARE(rows.size(), std::size_t{3});
    for (const ComparisonRow &row : rows) {
        const double folded = rowOf(*comparison, "run2", row.axis, "rbf").msdAfter;
        QVERIFY(std::abs(row.msdAfter / folded - 1.0) < 1e-9);
    }
}

void TestComparison::paperImprovements_ratiosAndSigns()
{
    // The x row of the paper's Table 2, from its own MSDs.
    std::vector<ComparisonRow> rows;
    for (const auto &[model, msd] : {std::pair{"linear", 0.0216}, {"bpnn", 0.0214}, {"rbf", 0.0193}}) {
        ComparisonRow row;
        row.run = "first";
        row.model = model;
        row.msdBefore = 4.7794;
        row.msdAfter = msd;
        rows.push_back(row);
    }
    const PaperRow table = paperImprovements(rows).at(0);
    QVERIFY(std::abs(table.q3 - 4.519e-3) < 1e-6);
    QVERIFY(std::abs(table.q5 - 4.038e-3) < 1e-6);
    QVERIFY(std::abs(table.q4AgainstQ3 - 0.0093) < 1e-4);
    QVERIFY(std::abs(table.q5AgainstQ3 - 0.1065) < 1e-4);
    QVERIFY(std::abs(table.q5AgainstQ4 - 0.0981) < 1e-4);
    rows.pop_back();
    QVERIFY(std::isnan(paperImprovements(rows).at(0).q5AgainstQ3));
    rows[1].msdAfter = 0.0432;
    QVERIFY(std::abs(paperImprovements(rows).at(0).q4AgainstQ3 + 1.0) < 1e-12);
}

static TrainingSet chamber(const std::filesystem::path &folder)
{
    return {{test::recordedRun(folder / "run1_cooling.csv", "run1", 1, -17.6),
             test::recordedRun(folder / "run2_heating.csv", "run2", 0, -17.6),
             test::recordedRun(folder / "run3_cooling.csv", "run3", 0, -17.6)},
            -17.6};
}

void TestComparison::chamber_constantAndCubic_leaveThePublishedRms()
{
    REQUIRE_SHARED_DATA(path, "climate_chamber/run1_cooling.csv");
    const auto comparison = compareRecipes(recipes(), chamber(path.parent_path()), {});
    QVERIFY(comparison.ok());
    const double constant[3][3] = {{.168, 1.131, .091}, {.530, 1.020, .097}, {.603, 1.540, .167}};
    const double cubic[3][3] = {{.306, .103, .128}, {.423, .087, .044}, {.544, .090, .163}};
    for (int run = 0; run < 3; ++run) {
        for (int axis = 0; axis < 3; ++axis) {
            const std::string name = "run" + std::to_string(run + 1);
            QVERIFY(std::abs(rowOf(*comparison, name, axis, "constant").rmsDps - constant[run][axis]) <
                    0.0015);
            QVERIFY(std::abs(rowOf(*comparison, name, axis, "cubic").rmsDps - cubic[run][axis]) < 0.0015);
        }
    }
    for (const AxisVerdict &verdict : comparison->verdicts)
        qInfo("%s G %.3f G* %.3f: %s", verdict.model.c_str(), verdict.gain, verdict.gainModelFree,
              verdict.reason.c_str());
    QVERIFY(comparison->verdicts[0].verdict == Verdict::NotRepeatable);
    QVERIFY(comparison->verdicts[1].verdict == Verdict::Yes);
    QVERIFY(comparison->verdicts[2].verdict == Verdict::NotRepeatable);
    QVERIFY(comparison->verdicts[1].gain > 0.993);
    QVERIFY(comparison->verdicts[0].reason.find("at 40 \u00b0C the runs read \u22123.99, \u22124.21 and "
                                                "\u22123.42 dps") != std::string::npos);
}

void TestComparison::chamber_anchored_yStaysAYes()
{
    REQUIRE_SHARED_DATA(path, "climate_chamber/run1_cooling.csv");
    ComparisonOptions options;
    options.judging = Judging::Anchored;
    const auto comparison = compareRecipes(recipes(), chamber(path.parent_path()), {}, options);
    QVERIFY(comparison.ok());
    for (const AxisVerdict &verdict : comparison->verdicts)
        qInfo("%s G %.3f: %s", verdict.model.c_str(), verdict.gain, verdict.reason.c_str());
    QVERIFY(comparison->verdicts[0].verdict == Verdict::NotRepeatable && comparison->verdicts[0].gain < 0.0);
    QVERIFY(comparison->verdicts[1].verdict == Verdict::Yes && comparison->verdicts[1].gain > 0.985);
    QVERIFY(comparison->verdicts[2].verdict == Verdict::NotRepeatable);
}

QTEST_APPLESS_MAIN(TestComparison)
#include "tst_comparison.moc"
