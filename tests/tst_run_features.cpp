#include "engine/features/run_features.h"
#include "support/synthetic_recording.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestRunFeatures : public QObject
{
    Q_OBJECT

private slots:
    void makeRunFeatures_masks_decideWhoSeesWhat();
    void makeRunFeatures_curve_equalsItsSamples();
    void trainingSet_withoutAndOnly_complementEachOther();
    void referenceTemperature_given_isTaken();
    void referenceTemperature_sharedHold_isItsMean();
    void referenceTemperature_holdsApart_isTheLowestUsable();
};

static Run runOf(Recording recording)
{
    Run run;
    run.name = std::string("a");
    run.mask = Mask(recording.size());
    run.recording = std::make_shared<const Recording>(std::move(recording));
    return run;
}

static Run heldRun(double holdC, std::uint64_t seed)
{
    RestingGyro gyro;
    gyro.seed = seed;
    Recording recording = restingRecording(gyro);
    for (Eigen::Index i = 0; i < recording.size(); ++i)
        recording.temperatureC[i] = holdC + 0.05 * std::max(0.0, recording.timeS[i] - 300.0);
    return runOf(std::move(recording));
}

void TestRunFeatures::makeRunFeatures_masks_decideWhoSeesWhat()
{
    Run run = runOf(restingRecording());
    run.referenceRateDps = {25.0, 5.0, 53.0};
    run.mask.set(10, MaskReason::Motion);
    run.mask.set(11, MaskReason::Outlier);
    const RunFeatures features = makeRunFeatures(run, 5.0);
    QCOMPARE(features.timeS.size(), 11999);
    QCOMPARE(features.timeS[10], run.recording->timeS[11]);
    QCOMPARE(features.deltaT[10], run.recording->temperatureC[11] - 5.0);
    QCOMPARE(Eigen::Vector3d(features.tdeDps.row(10)),
             Eigen::Vector3d(run.recording->rateDps.row(11).transpose() - run.referenceRateDps));
    QCOMPARE(int(features.usableForTraining[10]), 0);
    QCOMPARE(int(features.usableForTraining[11]), 1);
    QCOMPARE(features.curve.totalCount(), 11998.0);
}

void TestRunFeatures::makeRunFeatures_curve_equalsItsSamples()
{
    const RunFeatures features = makeRunFeatures(runOf(restingRecording()), 20.0);
    ThermalCurve curve;
    curve.add(features.deltaT, features.tdeDps);
    QCOMPARE(curve.cells().size(), features.curve.cells().size());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < curve.cells().size(); ++i) {
        QCOMPARE(curve.cells()[i].count, features.curve.cells()[i].count);
        QCOMPARE(curve.cells()[i].sumTdeDps, features.curve.cells()[i].sumTdeDps);
        sum += curve.cells()[i].sumTdeDps;
    }
    QVERIFY((sum - features.tdeDps.colwise().sum().transpose()).norm() < 1e-7);
}

void TestRunFeatures::trainingSet_withoutAndOnly_complementEachOther()
{
    Campaign campaign;
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        campaign.runs.push_back(heldRun(-40.0, seed));
    const TrainingSet set = makeTrainingSet(campaign, -40.0);
    QCOMPARE(set.runs.size(), std::size_t{3});
    const TrainingSet rest = set.without(1);
    const TrainingSet same = set.only({0, 2});
    QCOMPARE(rest.referenceTemperatureC, -40.0);
    QVERIFY(rest.runs == same.runs);
    QVERIFY(rest.runs[1] == set.runs[2]);
}

void TestRunFeatures::referenceTemperature_given_isTaken()
{
    Campaign campaign;
    campaign.runs.push_back(heldRun(-40.0, 1));
    QCOMPARE(chooseReferenceTemperature(campaign, 25.0), 25.0);
}

void TestRunFeatures::referenceTemperature_sharedHold_isItsMean()
{
    Campaign campaign;
    campaign.runs.push_back(heldRun(-40.3, 1));
    campaign.runs.push_back(heldRun(-39.7, 2));
    QVERIFY(std::abs(chooseReferenceTemperature(campaign, {}) + 40.0) < 0.001);
}

void TestRunFeatures::referenceTemperature_holdsApart_isTheLowestUsable()
{
    Campaign campaign;
    campaign.runs.push_back(heldRun(-40.0, 1));
    campaign.runs.push_back(heldRun(-20.0, 2));
    QCOMPARE(chooseReferenceTemperature(campaign, {}), -40.0);
    campaign.runs.erase(campaign.runs.begin());
    campaign.runs.push_back(runOf(restingRecording())); // no hold, from 0 degrees
    QCOMPARE(chooseReferenceTemperature(campaign, {}), -20.0);
    // What is masked does not count.
    Recording spoilt = restingRecording();
    spoilt.temperatureC[50] = -200.0;
    campaign.runs.push_back(runOf(std::move(spoilt)));
    campaign.runs.back().mask.set(50, MaskReason::TemperatureFault);
    QCOMPARE(chooseReferenceTemperature(campaign, {}), -20.0);
}

QTEST_APPLESS_MAIN(TestRunFeatures)
#include "tst_run_features.moc"
