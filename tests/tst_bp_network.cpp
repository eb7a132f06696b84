#include "engine/base/random.h"
#include "engine/models/bp_network.h"
#include "engine/models/bp_problem.h"
#include "engine/models/model_file.h"
#include "support/model_data.h"

#include <QTest>

#include <atomic>
#include <cmath>

using namespace driftbench;

class TestBpNetwork : public QObject
{
    Q_OBJECT

private slots:
    void linearise_randomParameters_asDifferences();
    void predict_byHand();
    void fit_networkAsTruth_recovered();
    void fit_steepAndSmooth_closeToTruth();
    void fit_sameSeed_sameBytesOnAnyThreads();
    void fit_otherSeed_otherNetwork();
    void fit_constantTruth_isThatConstant();
    void fit_hookStops_cancelled();
    void fit_nothingUsable_saysSo();
    void fit_badOptions_refused();
    void fit_progress_risesToOne();
};

static BpNetwork randomNetwork(Random &random, int hidden)
{
    BpNetwork network;
    network.inputs.mean = Eigen::RowVector2d(40.0, 2000.0);
    network.inputs.scale = Eigen::RowVector2d(25.0, 1800.0);
    for (auto &axis : network.axes) {
        axis.hiddenWeights = Eigen::MatrixXd::NullaryExpr(hidden, 2, [&] { return random.normal(); });
        axis.hiddenBias = Eigen::VectorXd::NullaryExpr(hidden, [&] { return random.normal(); });
        axis.outputWeights = Eigen::VectorXd::NullaryExpr(hidden, [&] { return random.normal(); });
        axis.outputBias = random.normal();
        axis.outputMeanDps = random.normal();
        axis.outputScaleDps = 0.5 + random.uniform();
    }
    return network;
}

static TrainingSet rampOf(const std::function<Eigen::Vector3d(double)> &truth)
{
    return {{test::makeRamp("run", 40000, 0.0, 90.0, truth)}, -40.0};
}

void TestBpNetwork::linearise_randomParameters_asDifferences()
{
    constexpr std::uint64_t kSeed = 42;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    const Eigen::MatrixXd inputs = Eigen::MatrixXd::NullaryExpr(23, 2, [&] { return random.normal(); });
    const Eigen::VectorXd targets = Eigen::VectorXd::NullaryExpr(23, [&] { return random.normal(); });
    const Eigen::VectorXd weights = Eigen::VectorXd::NullaryExpr(23, [&] { return 0.1 + random.uniform(); });
    BpProblem problem(inputs, targets, weights, 10);
    const Eigen::VectorXd p =
        Eigen::VectorXd::NullaryExpr(problem.parameterCount(), [&] { return random.normal(); });
    NormalEquations equations{Eigen::MatrixXd(p.size(), p.size()), Eigen::VectorXd(p.size())};
    problem.loss(p);
    problem.linearise(p, equations);
    const Eigen::MatrixXd jacobian = problem.jacobian();
    const Eigen::VectorXd residuals = problem.residuals();
    for (Eigen::Index j = 0; j < p.size(); ++j) {
        Eigen::VectorXd moved = p;
        moved[j] += 1e-6;
        problem.loss(moved);
        const Eigen::VectorXd up = problem.residuals();
        moved[j] -= 2e-6;
        problem.loss(moved);
        const Eigen::VectorXd difference = (up - problem.residuals()) / 2e-6;
        QVERIFY((difference - jacobian.col(j)).cwiseAbs().maxCoeff() < 1e-8);
    }
    const Eigen::MatrixXd curvature = equations.curvature.selfadjointView<Eigen::Lower>();
    QVERIFY((curvature - jacobian.transpose() * jacobian).cwiseAbs().maxCoeff() < 1e-13);
    QVERIFY((equations.gradient - jacobian.transpose() * residuals).cwiseAbs().maxCoeff() < 1e-13);
}

void TestBpNetwork::predict_byHand()
{
    Random random(5);
    const BpNetwork network = randomNetwork(random, 3);
    const Eigen::VectorXd deltaT = Eigen::VectorXd::LinSpaced(7, -200.0, 400.0);
    const Eigen::MatrixX3d tde = network.predict(temperatureQuantities(FeatureSet::DeltaTSquared, deltaT));
    for (Eigen::Index i = 0; i < deltaT.size(); ++i) {
        for (Eigen::Index a = 0; a < 3; ++a) {
            const BpNetwork::Axis &axis = network.axes[static_cast<std::size_t>(a)];
            double output = axis.outputBias;
            for (Eigen::Index h = 0; h < 3; ++h) {
                output += axis.outputWeights[h] *
                          std::tanh(axis.hiddenWeights(h, 0) * (deltaT[i] - 40.0) / 25.0 +
                                    axis.hiddenWeights(h, 1) * (deltaT[i] * deltaT[i] - 2000.0) / 1800.0 +
                                    axis.hiddenBias[h]);
            }
            QVERIFY(std::abs(tde(i, a) - axis.outputMeanDps - axis.outputScaleDps * output) < 1e-13);
        }
    }
}

void TestBpNetwork::fit_networkAsTruth_recovered()
{
    constexpr std::uint64_t kSeed = 9;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    const BpNetwork truth = randomNetwork(random, 2);
    const auto curve = [&truth](double d) -> Eigen::Vector3d {
        return truth
            .predict(temperatureQuantities(FeatureSet::DeltaTSquared, Eigen::VectorXd::Constant(1, d)))
            .row(0)
            .transpose();
    };
    BpOptions options;
    options.iterations = 400;
    const auto fit = fitBpNetwork(rampOf(curve), options);
    QVERIFY(fit.ok());
    const Eigen::VectorXd deltaT = Eigen::VectorXd::LinSpaced(300, 1.0, 89.0);
    const Eigen::MatrixXd quantities = temperatureQuantities(FeatureSet::DeltaTSquared, deltaT);
    // Cells of 1 degree hold means over a curve, which differ from the curve by its bend: about 1e-5 here.
    QVERIFY((fit->network.predict(quantities) - truth.predict(quantities)).cwiseAbs().maxCoeff() < 3e-4);
}

void TestBpNetwork::fit_steepAndSmooth_closeToTruth()
{
    constexpr std::uint64_t kSeed = 3;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    const auto curve = [](double d) {
        return Eigen::Vector3d(0.8 * std::tanh((d - 40.0) / 3.0), 0.5 * std::sin(d / 20.0),
                               0.3 * std::exp(-0.02 * std::pow(d - 60.0, 2)));
    };
    Random random(kSeed);
    const TrainingSet set = rampOf([&](double d) -> Eigen::Vector3d {
        return curve(d) + 0.1 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    });
    const auto fit = fitBpNetwork(set, {});
    QVERIFY(fit.ok());
    const Eigen::VectorXd deltaT = Eigen::VectorXd::LinSpaced(300, 0.0, 90.0);
    const Eigen::MatrixX3d tde =
        fit->network.predict(temperatureQuantities(FeatureSet::DeltaTSquared, deltaT));
    Eigen::Vector3d error = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < deltaT.size(); ++i)
        error += (tde.row(i).transpose() - curve(deltaT[i])).cwiseAbs2() / 300.0;
    QVERIFY(error.maxCoeff() < 0.003 * 0.1 * 0.1); // 0.3 % of the noise
}

static std::string bytesOf(const Result<BpFit> &fit)
{
    TrainedModel model;
    model.name = "bpnn";
    model.model = fit->network;
    return modelToJson(model);
}

static Eigen::Vector3d wave(double d)
{
    return {std::sin(d / 10.0), 0.01 * d, std::cos(d / 30.0)};
}

void TestBpNetwork::fit_sameSeed_sameBytesOnAnyThreads()
{
    const TrainingSet set = rampOf(wave);
    BpOptions options;
    options.iterations = 20;
    options.threads = 1;
    const std::string single = bytesOf(fitBpNetwork(set, options));
    for (const int threads : {1, 2, 7, 0}) {
        options.threads = threads;
        QCOMPARE(bytesOf(fitBpNetwork(set, options)), single);
    }
}

void TestBpNetwork::fit_otherSeed_otherNetwork()
{
    BpOptions options;
    options.iterations = 5;
    const std::string first = bytesOf(fitBpNetwork(rampOf(wave), options));
    options.seed = 2;
    QVERIFY(bytesOf(fitBpNetwork(rampOf(wave), options)) != first);
}

void TestBpNetwork::fit_constantTruth_isThatConstant()
{
    const auto fit = fitBpNetwork(rampOf([](double) { return Eigen::Vector3d(1.0, -2.0, 0.0); }), {});
    QVERIFY(fit.ok());
    const Eigen::VectorXd deltaT = Eigen::VectorXd::LinSpaced(50, 0.0, 90.0);
    const Eigen::MatrixX3d tde =
        fit->network.predict(temperatureQuantities(FeatureSet::DeltaTSquared, deltaT));
    QVERIFY((tde.rowwise() - Eigen::RowVector3d(1.0, -2.0, 0.0)).cwiseAbs().maxCoeff() < 1e-9);
}

void TestBpNetwork::fit_hookStops_cancelled()
{
    std::atomic<int> calls = 0;
    const auto fit = fitBpNetwork(
        rampOf(wave), {}, [&calls](const Progress &) { return ++calls > 10 ? Flow::Stop : Flow::Continue; });
    QVERIFY(!fit.ok());
    QCOMPARE(fit.error().code, Errc::Cancelled);
    QCOMPARE(calls.load(), 11);
}

void TestBpNetwork::fit_nothingUsable_saysSo()
{
    const auto empty = fitBpNetwork({}, {});
    QVERIFY(!empty.ok());
    QCOMPARE(empty.error().code, Errc::NothingUsable);
}

void TestBpNetwork::fit_badOptions_refused()
{
    BpOptions options;
    options.starts = 0;
    const auto fit = fitBpNetwork(rampOf(wave), options);
    QVERIFY(!fit.ok());
    QCOMPARE(fit.error().code, Errc::InvalidOption);
}

void TestBpNetwork::fit_progress_risesToOne()
{
    double last = 0.0;
    bool rising = true;
    const auto fit = fitBpNetwork(rampOf(wave), {}, [&](const Progress &progress) {
        rising = rising && progress.fraction >= last;
        last = progress.fraction;
        return Flow::Continue;
    });
    QVERIFY(fit.ok());
    QVERIFY(rising);
    QVERIFY(std::abs(last - 1.0) < 1e-9);
}

QTEST_APPLESS_MAIN(TestBpNetwork)
#include "tst_bp_network.moc"
