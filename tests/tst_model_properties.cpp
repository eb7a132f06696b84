// What must hold for every model, whatever it is made of. A model joins by one line in kinds().
#include "engine/base/random.h"
#include "engine/models/model_file.h"
#include "support/model_data.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

using namespace driftbench;

namespace {

constexpr double kNoiseDps = 0.1;
constexpr double kNotHeld = std::numeric_limits<double>::infinity(); // the property is none of this model's

// How far, in dps, a model may miss a property on the campaign below.
struct Kind
{
    const char *name;
    std::function<AnyModel(const TrainingSet &)> fit;
    double sampleOrder;  // the same samples in another order
    double splitRun;     // a run given as two: its cell or filter window at the cut becomes two
    double shift;        // all TDE shifted by a constant: PX4's filter takes zeros beyond a run's ends
    double straightLine; // a line without noise, by two runs of which each covers a part: as before
};

AnyModel bpNetwork(const TrainingSet &set)
{
    BpOptions options;
    options.iterations = 60;
    options.starts = 3;
    return fitBpNetwork(set, options)->network;
}

std::vector<Kind> kinds()
{
    return {
        {"constant", [](const TrainingSet &set) -> AnyModel { return fitConstant(set); }, 1e-12, 1e-12, 1e-12,
         kNotHeld},
        {"linear", [](const TrainingSet &set) -> AnyModel { return fitLinear(set); }, 1e-12, 1e-8, 1e-12,
         1e-11},
        {"cubic", [](const TrainingSet &set) -> AnyModel { return fitCubicAsPx4(set); }, kNotHeld, 0.01, 0.01,
         1e-4},
        {"cubic-ardupilot", [](const TrainingSet &set) -> AnyModel { return fitCubicAsArduPilot(set); },
         kNotHeld, 0.01, 1e-10, 1e-10},
        {"bpnn", bpNetwork, 0.02, 0.02, 0.02, 1e-3},
    };
}

constexpr double kLowest = -25.0;
constexpr double kHighest = 65.0;

Eigen::Vector3d curve(double d)
{
    return {0.8 * std::sin(d / 25.0), 1.0 + 0.02 * d - 3e-4 * d * d, 0.3 * std::tanh((d - 20.0) / 12.0)};
}

// Three noisy runs, the last one over a part of the range.
TrainingSet makeCampaign()
{
    Random random(20261121);
    const auto noisy = [&random](double d) -> Eigen::Vector3d {
        return curve(d) + kNoiseDps * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    };
    return {{test::makeRamp("run1", 12000, kLowest, kHighest, noisy),
             test::makeRamp("run2", 9000, kLowest, kHighest, noisy),
             test::makeRamp("run3", 6000, 0.0, 50.0, noisy)},
            12.0};
}

const TrainingSet &campaign()
{
    static const TrainingSet set = makeCampaign();
    return set;
}

// Each run made anew with its TDE as `change` makes it.
TrainingSet changed(const TrainingSet &set,
                    const std::function<Eigen::MatrixX3d(const Eigen::MatrixX3d &)> &change)
{
    TrainingSet result{{}, set.referenceTemperatureC};
    for (const auto &run : set.runs)
        result.runs.push_back(test::makeRun(run->name, run->timeS, run->deltaT, change(run->tdeDps)));
    return result;
}

TrainingSet shuffled(const TrainingSet &set)
{
    Random random(7);
    TrainingSet result{{}, set.referenceTemperatureC};
    for (const auto &run : set.runs) {
        std::vector<Eigen::Index> rows(static_cast<std::size_t>(run->deltaT.size()));
        std::iota(rows.begin(), rows.end(), 0);
        for (std::size_t i = rows.size() - 1; i > 0; --i)
            std::swap(rows[i], rows[random.below(i + 1)]);
        result.runs.push_back(test::makeRun(run->name, run->timeS, Eigen::VectorXd(run->deltaT(rows)),
                                            Eigen::MatrixX3d(run->tdeDps(rows, Eigen::all))));
    }
    return result;
}

TrainingSet firstRunSplit(const TrainingSet &set)
{
    TrainingSet result = set;
    const RunFeatures &run = *set.runs[0];
    constexpr Eigen::Index kFirst = 5000;
    const Eigen::Index rest = run.deltaT.size() - kFirst;
    result.runs[0] =
        test::makeRun("run1a", run.timeS.head(kFirst), run.deltaT.head(kFirst), run.tdeDps.topRows(kFirst));
    result.runs.insert(
        result.runs.begin() + 1,
        test::makeRun("run1b", run.timeS.tail(rest), run.deltaT.tail(rest), run.tdeDps.bottomRows(rest)));
    return result;
}

Eigen::VectorXd grid()
{
    return Eigen::VectorXd::LinSpaced(181, kLowest, kHighest);
}

double farthest(const AnyModel &left, const AnyModel &right)
{
    return (predictAtDeltaT(left, grid()) - predictAtDeltaT(right, grid())).cwiseAbs().maxCoeff();
}

TrainedModel trained(const TrainingSet &set, AnyModel model)
{
    TrainedModel result;
    result.name = "model";
    result.model = std::move(model);
    result.referenceTemperatureC = set.referenceTemperatureC;
    result.lowestTemperatureC = set.referenceTemperatureC + kLowest;
    result.highestTemperatureC = set.referenceTemperatureC + kHighest;
    return result;
}

} // namespace

Q_DECLARE_METATYPE(Kind)

class TestModelProperties : public QObject
{
    Q_OBJECT

private slots:
    void predict_rowByRow_asBatch_data() { everyKind(); }
    void predict_rowByRow_asBatch();
    void predict_overTheRange_finiteAndNearTheTruth_data() { everyKind(); }
    void predict_overTheRange_finiteAndNearTheTruth();
    void predict_outsideTheRange_edgeHeldAndCounted_data() { everyKind(); }
    void predict_outsideTheRange_edgeHeldAndCounted();
    void saveAndLoad_fittedModel_sameToTheBit_data() { everyKind(); }
    void saveAndLoad_fittedModel_sameToTheBit();
    void fit_sameSamples_sameModel_data() { everyKind(); }
    void fit_sameSamples_sameModel();
    void fit_samplesInOtherOrder_sameCurve_data() { everyKind(); }
    void fit_samplesInOtherOrder_sameCurve();
    void fit_runSplitInTwo_sameCurve_data() { everyKind(); }
    void fit_runSplitInTwo_sameCurve();
    void fit_shiftedTde_shiftedCurve_data() { everyKind(); }
    void fit_shiftedTde_shiftedCurve();
    void fit_scaledTde_scaledCurve_data() { everyKind(); }
    void fit_scaledTde_scaledCurve();
    void fit_straightLine_reproduced_data() { everyKind(); }
    void fit_straightLine_reproduced();

private:
    static void everyKind();
};

void TestModelProperties::everyKind()
{
    QTest::addColumn<Kind>("kind");
    for (const Kind &kind : kinds())
        QTest::newRow(kind.name) << kind;
}

void TestModelProperties::predict_rowByRow_asBatch()
{
    QFETCH(Kind, kind);
    const AnyModel model = kind.fit(campaign());
    const Eigen::VectorXd deltaT = grid();
    const Eigen::MatrixX3d batch = predictAtDeltaT(model, deltaT);
    for (Eigen::Index i = 0; i < deltaT.size(); ++i) {
        const Eigen::MatrixX3d single = predictAtDeltaT(model, deltaT.segment(i, 1));
        QVERIFY((single.row(0) - batch.row(i)).cwiseAbs().maxCoeff() < 1e-12);
    }
    QCOMPARE(predictAtDeltaT(model, Eigen::VectorXd()).rows(), 0);
}

void TestModelProperties::predict_overTheRange_finiteAndNearTheTruth()
{
    QFETCH(Kind, kind);
    const Eigen::MatrixX3d tde = predictAtDeltaT(kind.fit(campaign()), grid());
    QVERIFY(tde.allFinite());
    for (Eigen::Index i = 0; i < tde.rows(); ++i)
        QVERIFY((tde.row(i).transpose() - curve(grid()[i])).cwiseAbs().maxCoeff() < 1.5);
}

void TestModelProperties::predict_outsideTheRange_edgeHeldAndCounted()
{
    QFETCH(Kind, kind);
    const TrainingSet &set = campaign();
    const TrainedModel model = trained(set, kind.fit(set));
    Eigen::VectorXd temperatureC(5);
    temperatureC << -300.0, model.lowestTemperatureC, 30.0, model.highestTemperatureC, 1e4;
    const Prediction prediction = predictAtTemperature(model, temperatureC);
    QCOMPARE(prediction.outsideTrainedRange, 2);
    QVERIFY(prediction.tdeDps.allFinite());
    QVERIFY((prediction.tdeDps.row(0) - prediction.tdeDps.row(1)).cwiseAbs().maxCoeff() < 1e-12);
    QVERIFY((prediction.tdeDps.row(4) - prediction.tdeDps.row(3)).cwiseAbs().maxCoeff() < 1e-12);
}

void TestModelProperties::saveAndLoad_fittedModel_sameToTheBit()
{
    QFETCH(Kind, kind);
    const TrainingSet &set = campaign();
    const TrainedModel model = trained(set, kind.fit(set));
    const auto back = modelFromJson(modelToJson(model), "model");
    QVERIFY(back.ok());
    QCOMPARE(farthest(back->model, model.model), 0.0);
}

void TestModelProperties::fit_sameSamples_sameModel()
{
    QFETCH(Kind, kind);
    const TrainingSet &set = campaign();
    QCOMPARE(modelToJson(trained(set, kind.fit(set))), modelToJson(trained(set, kind.fit(campaign()))));
}

void TestModelProperties::fit_samplesInOtherOrder_sameCurve()
{
    QFETCH(Kind, kind);
    if (std::isinf(kind.sampleOrder))
        QSKIP("does not hold for this model by its definition");
    const TrainingSet &set = campaign();
    const double found = farthest(kind.fit(set), kind.fit(shuffled(set)));
    QVERIFY2(found <= kind.sampleOrder, qPrintable(QString::number(found)));
}

void TestModelProperties::fit_runSplitInTwo_sameCurve()
{
    QFETCH(Kind, kind);
    if (std::isinf(kind.splitRun))
        QSKIP("does not hold for this model by its definition");
    const TrainingSet &set = campaign();
    const double found = farthest(kind.fit(set), kind.fit(firstRunSplit(set)));
    QVERIFY2(found <= kind.splitRun, qPrintable(QString::number(found)));
}

void TestModelProperties::fit_shiftedTde_shiftedCurve()
{
    QFETCH(Kind, kind);
    if (std::isinf(kind.shift))
        QSKIP("does not hold for this model by its definition");
    const TrainingSet &set = campaign();
    const Eigen::RowVector3d shift(2.0, -5.0, 0.25);
    const AnyModel moved = kind.fit(changed(
        set, [&shift](const Eigen::MatrixX3d &tde) { return Eigen::MatrixX3d(tde.rowwise() + shift); }));
    const Eigen::MatrixX3d difference =
        predictAtDeltaT(moved, grid()) - predictAtDeltaT(kind.fit(set), grid());
    const double found = (difference.rowwise() - shift).cwiseAbs().maxCoeff();
    QVERIFY2(found <= kind.shift, qPrintable(QString::number(found)));
}

void TestModelProperties::fit_scaledTde_scaledCurve()
{
    QFETCH(Kind, kind);
    const TrainingSet &set = campaign();
    // A power of two and a change of sign keep every digit: nothing but the scale may change.
    const AnyModel scaled =
        kind.fit(changed(set, [](const Eigen::MatrixX3d &tde) { return Eigen::MatrixX3d(4.0 * tde); }));
    const Eigen::MatrixX3d difference =
        predictAtDeltaT(scaled, grid()) - 4.0 * predictAtDeltaT(kind.fit(set), grid());
    QVERIFY2(difference.cwiseAbs().maxCoeff() < 1e-11,
             qPrintable(QString::number(difference.cwiseAbs().maxCoeff())));
}

void TestModelProperties::fit_straightLine_reproduced()
{
    QFETCH(Kind, kind);
    if (std::isinf(kind.straightLine))
        QSKIP("does not hold for this model by its definition");
    const auto line = [](double d) { return Eigen::Vector3d(0.5 + 0.01 * d, -0.02 * d, 3.0); };
    const TrainingSet set{{test::makeRamp("run1", 9000, kLowest, 25.0, line),
                           test::makeRamp("run2", 9000, 15.0, kHighest, line)},
                          12.0};
    const Eigen::MatrixX3d tde = predictAtDeltaT(kind.fit(set), grid());
    for (Eigen::Index i = 0; i < tde.rows(); ++i) {
        const double found = (tde.row(i).transpose() - line(grid()[i])).cwiseAbs().maxCoeff();
        QVERIFY2(found <= kind.straightLine, qPrintable(QString::number(found)));
    }
}

QTEST_APPLESS_MAIN(TestModelProperties)
#include "tst_model_properties.moc"
