// What is said of an axis by its rows, the traces of a judged run, and what a model has to show for itself.
#include "engine/evaluation/axis_finding.h"
#include "engine/evaluation/judged_traces.h"
#include "engine/models/parameter_count.h"
#include "support/small_comparison.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestJudging : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void findAxis_limit_decides();
    void findAxis_worseThanConstant_isWithCare();
    void parameterCount_ofEachModel_isThatOfItsFormula();
    void judgedTraces_squaresMeetTheComparison();
    void judgedTraces_anchored_startAtZero();
    void fitRbf_inputsLeftOut_doNotMatter();
    void fitRbf_withoutDeltaT_isRefused();

private:
    TrainingSet m_set;
    Comparison m_comparison;
};

void TestJudging::initTestCase()
{
    SmallComparison small = smallComparison();
    m_set = std::move(small.set);
    m_comparison = std::move(small.comparison);
}

void TestJudging::findAxis_limit_decides()
{
    const auto rows = rowsBy({{0.1, 1.0}, {0.19, 1.0}, {0.21, 1.0}});
    QCOMPARE(findAxis(rows, 0, "rbf", Verdict::Yes, 0.2).verdict, Verdict::NotRepeatable);
    QCOMPARE(findAxis(rows, 0, "rbf", Verdict::Yes, 0.22).verdict, Verdict::Yes);
    QCOMPARE(findAxis(rows, 0, "rbf", Verdict::Yes, std::nullopt).verdict, Verdict::Yes);
    QCOMPARE(findAxis(rows, 0, "rbf", Verdict::NotRepeatable, 0.22).verdict, Verdict::NotRepeatable);
    const AxisFinding finding = findAxis(rows, 0, "rbf", Verdict::Yes, 0.2);
    QCOMPARE(finding.passing(), std::size_t(2));
    QCOMPARE(finding.runs.size(), std::size_t(3));
    QVERIFY(std::abs(finding.runs[2].leftDps - 0.21) < 1e-12);
}

void TestJudging::findAxis_worseThanConstant_isWithCare()
{
    const auto rows = rowsBy({{0.17, 0.11}, {0.06, 0.1}, {0.16, 0.169}});
    const AxisFinding finding = findAxis(rows, 0, "rbf", Verdict::Yes, 0.2);
    QCOMPARE(finding.verdict, Verdict::WithCare);
    QCOMPARE(finding.losing(), std::size_t(1));
    QVERIFY(finding.runs[0].constantIsBetter);
}

void TestJudging::parameterCount_ofEachModel_isThatOfItsFormula()
{
    for (const TrainedModel &model : m_comparison.models) {
        const int count = parameterCount(model.model);
        if (model.name == "constant")
            QCOMPARE(count, 3);
        if (model.name == "linear")
            QCOMPARE(count, 6);
        if (model.name == "cubic")
            QCOMPARE(count, 12);
        if (const auto *rbf = std::get_if<RbfNetwork>(&model.model)) {
            QCOMPARE(count, 3 + 9 + 2 * static_cast<int>(rbf->size()) + rbf->centreCount[0] +
                                rbf->centreCount[1] + rbf->centreCount[2]);
        }
    }
}

void TestJudging::judgedTraces_squaresMeetTheComparison()
{
    for (const Fold &fold : m_comparison.folds) {
        const TrainedModel constant = heldOut(m_comparison, fold, 0, m_set);
        const TrainedModel rbf = heldOut(m_comparison, fold, 3, m_set);
        const JudgedTraces traces = judgedTraces(fold.heldOut, rbf, &constant, Judging::Absolute);
        QVERIFY(traces.lessConstant);
        for (int axis = 0; axis < 3; ++axis) {
            const double after = traces.afterDps.col(axis).squaredNorm() / double(traces.timeS.size());
            const double before = traces.beforeDps.col(axis).squaredNorm() / double(traces.timeS.size());
            const double wanted = rowOf(m_comparison, fold.name, axis, "rbf").msdAfter;
            const double constantMsd = rowOf(m_comparison, fold.name, axis, "constant").msdAfter;
            QVERIFY2(std::abs(after - wanted) < 1e-9 * wanted,
                     qPrintable(QString::number(after / wanted, 'g', 15)));
            QVERIFY(std::abs(before - constantMsd) < 1e-9 * constantMsd);
        }
        QVERIFY(traces.allanAfter.tauS.size() > 5);
    }
}

void TestJudging::judgedTraces_anchored_startAtZero()
{
    const Fold &fold = m_comparison.folds.front();
    const TrainedModel rbf = heldOut(m_comparison, fold, 3, m_set);
    const JudgedTraces traces = judgedTraces(fold.heldOut, rbf, nullptr, Judging::Anchored);
    const Eigen::Index start = prepareForJudging(fold.heldOut, fold.heldOut, Judging::Anchored).startSamples;
    QVERIFY(start > 0);
    QVERIFY(traces.afterDps.topRows(start).colwise().mean().cwiseAbs().maxCoeff() < 1e-12);
    QVERIFY(traces.beforeDps.topRows(start).colwise().mean().cwiseAbs().maxCoeff() < 1e-12);
}

void TestJudging::fitRbf_inputsLeftOut_doNotMatter()
{
    for (const std::array<bool, 3> inputs :
         {std::array{true, false, false}, std::array{true, false, true}, std::array{true, true, false}}) {
        RbfOptions rbf;
        rbf.inputs = inputs;
        const auto fit = fitRbfNetwork(m_set, rbf);
        QVERIFY(fit.ok());
        Eigen::MatrixXd quantities(3, 3);
        quantities.row(0) = temperatureQuantities(20.0).transpose();
        quantities.row(1) = quantities.row(0);
        for (Eigen::Index column = 0; column < 3; ++column) {
            if (!inputs[static_cast<std::size_t>(column)])
                quantities(1, column) += 1000.0;
        }
        quantities.row(2) = temperatureQuantities(40.0).transpose();
        const Eigen::MatrixX3d tde = fit->network.predict(quantities);
        QVERIFY((tde.row(0) - tde.row(1)).cwiseAbs().maxCoeff() < 1e-12);
        QVERIFY((tde.row(0) - knownCurve(20.0).transpose()).cwiseAbs().maxCoeff() < 0.05);
        QVERIFY((tde.row(2) - knownCurve(40.0).transpose()).cwiseAbs().maxCoeff() < 0.05);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const RbfSelection &selection = fit->selection;
            QCOMPARE(selection.heldOutLowest[axis].size(), selection.heldOutLoss[axis].size());
            for (std::size_t k = 0; k < selection.heldOutLoss[axis].size(); ++k) {
                QVERIFY(selection.heldOutLowest[axis][k] <= selection.heldOutLoss[axis][k] + 1e-12);
                QVERIFY(selection.heldOutHighest[axis][k] >= selection.heldOutLoss[axis][k] - 1e-12);
            }
        }
    }
}

void TestJudging::fitRbf_withoutDeltaT_isRefused()
{
    RbfOptions rbf;
    rbf.inputs = {false, true, true};
    const auto fit = fitRbfNetwork(m_set, rbf);
    QVERIFY(!fit.ok());
    QCOMPARE(fit.error().code, Errc::InvalidOption);
}

QTEST_APPLESS_MAIN(TestJudging)
#include "tst_judging.moc"
