#include "engine/evaluation/dynamic_experiment.h"
#include "engine/features/dynamic_quantities.h"
#include "support/simple_campaign.h"
#include "support/test_data.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestDynamicExperiment : public QObject
{
    Q_OBJECT

private slots:
    void experiment_lagInTheData_isFound();
    void experiment_noLagInTheData_gainsNothing();
    void experiment_twoRuns_isRefused();
    void experiment_modelNotCompared_isRefused();
};

// Up and down sweeps of a line with, on x, a lag of 300 s: heating and cooling part by 2 * 0.05 dps/C * r *
// 300 s.
static TrainingSet laggingCampaign(double lagDpsPerC)
{
    TrainingSet set;
    Random random(23);
    for (int i = 0; i < 4; ++i) {
        auto run = std::make_shared<RunFeatures>();
        run->name = "run" + std::to_string(i + 1);
        const Eigen::Index count = 4000;
        run->timeS = Eigen::VectorXd::LinSpaced(count, 0.0, static_cast<double>(count - 1));
        run->deltaT = 60.0 - (run->timeS.array() * (60.0 / 2000.0) - 60.0).abs();
        const Eigen::VectorXd lag = temperatureLag(run->timeS, run->deltaT, 300.0);
        run->tdeDps.resize(count, 3);
        for (Eigen::Index row = 0; row < count; ++row) {
            for (int axis = 0; axis < 3; ++axis)
                run->tdeDps(row, axis) = 0.02 * run->deltaT[row] + 0.05 * random.normal();
            run->tdeDps(row, 0) += lagDpsPerC * lag[row];
        }
        run->usableForTraining.assign(static_cast<std::size_t>(count), 1);
        run->curve.add(run->deltaT, run->tdeDps);
        set.runs.push_back(run);
    }
    return set;
}

static Comparison compared(const TrainingSet &set)
{
    auto comparison = compareModels(set, {}, {.models = {"constant", "rbf"}});
    return *std::move(comparison);
}

void TestDynamicExperiment::experiment_lagInTheData_isFound()
{
    const auto outcomes = dynamicExperiment(compared(laggingCampaign(0.05)));
    QVERIFY(outcomes.ok());
    QCOMPARE(outcomes->size(), std::size_t(12));
    for (const DynamicOutcome &outcome : *outcomes) {
        if (outcome.axis != 0)
            continue;
        QVERIFY(outcome.msdDynamic - outcome.noiseFloor < 0.1 * (outcome.msdStatic - 0.0025));
        qInfo("%s: %.5f -> %.5f", outcome.run.c_str(), outcome.msdStatic, outcome.msdDynamic);
    }
}

void TestDynamicExperiment::experiment_noLagInTheData_gainsNothing()
{
    const auto outcomes = dynamicExperiment(compared(laggingCampaign(0.0)));
    QVERIFY(outcomes.ok());
    for (const DynamicOutcome &outcome : *outcomes)
        QVERIFY(std::abs(outcome.msdDynamic / outcome.msdStatic - 1.0) < 0.01);
}

void TestDynamicExperiment::experiment_twoRuns_isRefused()
{
    const auto outcomes = dynamicExperiment(compared(laggingCampaign(0.05).only({0, 1})));
    QVERIFY(!outcomes.ok());
    QCOMPARE(outcomes.error().code, Errc::InvalidOption);
}

void TestDynamicExperiment::experiment_modelNotCompared_isRefused()
{
    DynamicExperimentOptions options;
    options.model = "bpnn";
    const auto outcomes = dynamicExperiment(compared(laggingCampaign(0.0)), options);
    QVERIFY(!outcomes.ok());
    QVERIFY(outcomes.error().message.find("bpnn") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestDynamicExperiment)
#include "tst_dynamic_experiment.moc"
