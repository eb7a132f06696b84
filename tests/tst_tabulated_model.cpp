#include "engine/evaluation/tabulated_model.h"
#include "support/simple_recipes.h"
#include "support/thermal_runs.h"

#include <QTest>

using namespace driftbench;

class TestTabulatedModel : public QObject
{
    Q_OBJECT

private slots:
    void predict_manySamples_isTheModelWithinTheTolerance();
    void predict_rootAtZero_isNotSmoothedOver();
    void predict_detailSharperThanTheTable_isExact();
    void predict_fewSamples_isTheModelItself();
};

static Eigen::VectorXd manyDeltaT(double low, double high)
{
    Random random(91);
    Eigen::VectorXd deltaT(100000);
    for (double &value : deltaT)
        value = random.uniform(low, high);
    deltaT[0] = low;
    deltaT[1] = high;
    deltaT[2] = 0.0;
    return deltaT;
}

static double largestError(const AnyModel &model, const Eigen::VectorXd &deltaT)
{
    return (predictThroughTable(model, deltaT) - predictAtDeltaT(model, deltaT)).cwiseAbs().maxCoeff();
}

void TestTabulatedModel::predict_manySamples_isTheModelWithinTheTolerance()
{
    Random random(92);
    TrainingSet set;
    set.runs.push_back(test::makeRun("run", {}, test::bentCurve(random, 0.01), random));
    const AnyModel model = test::fitGaussianRow(set);
    for (const auto &[low, high] : {std::pair{0.0, 80.0}, {-30.0, 50.0}, {-60.0, -10.0}, {0.0, 0.0}})
        QVERIFY(largestError(model, manyDeltaT(low, high)) <= 1e-5);
    QVERIFY(largestError(test::fitPlainCubic(set), manyDeltaT(0.0, 80.0)) <= 1e-5);
}

void TestTabulatedModel::predict_rootAtZero_isNotSmoothedOver()
{
    RbfNetwork network;
    network.inputs = {Eigen::RowVector3d::Zero(), Eigen::RowVector3d::Ones()};
    network.centres.resize(0, 3);
    network.widths.resize(0);
    network.weightsDps.resize(0, 3);
    network.linearDps.row(2).setConstant(1.0); // tde = signed root of dT
    QVERIFY(largestError(network, manyDeltaT(-5.0, 60.0)) < 1e-9);
}

void TestTabulatedModel::predict_detailSharperThanTheTable_isExact()
{
    RbfNetwork network;
    network.inputs = {Eigen::RowVector3d::Zero(), Eigen::RowVector3d(1.0, 1e12, 1e12)};
    network.centres = Eigen::MatrixX3d::Zero(1, 3);
    network.centres(0, 0) = 40.0;
    network.widths = Eigen::VectorXd::Constant(1, 0.05);
    network.weightsDps = Eigen::MatrixX3d::Ones(1, 3);
    QCOMPARE(largestError(network, manyDeltaT(0.0, 80.0)), 0.0);
}

void TestTabulatedModel::predict_fewSamples_isTheModelItself()
{
    LinearModel line;
    line.slopeDpsPerC.setConstant(0.123);
    QCOMPARE(largestError(line, Eigen::VectorXd::LinSpaced(1000, -40.0, 85.0)), 0.0);
    QCOMPARE(predictThroughTable(line, Eigen::VectorXd()).rows(), Eigen::Index{0});
}

QTEST_APPLESS_MAIN(TestTabulatedModel)
#include "tst_tabulated_model.moc"
