#include "engine/evaluation/splits.h"
#include "support/thermal_runs.h"

#include <QTest>

#include <set>

using namespace driftbench;

class TestSplits : public QObject
{
    Q_OBJECT

private slots:
    void makeSplits_severalRuns_leavesEachOutOnce();
    void makeSplits_holdOut_trainsOnceOnTheRest();
    void makeSplits_oneRun_blocksPartitionItsSamples();
    void makeSplits_oneRun_neighboursStayTogether();
    void makeSplits_badInput_isRefusedWithAReason();
    void temperatureBlock_isASixtyFourthButNotBelowFourCells();
    void partOf_training_keepsOutliersOutOfTheCurve();
};

static TrainingSet threeRuns()
{
    Random random(51);
    TrainingSet set;
    set.referenceTemperatureC = 20.0;
    for (const char *name : {"a", "b", "c"})
        set.runs.push_back(test::makeRun(name, {}, test::bentCurve(random, 0.01), random));
    return set;
}

void TestSplits::makeSplits_severalRuns_leavesEachOutOnce()
{
    const TrainingSet set = threeRuns();
    const auto splits = makeSplits(set, {});
    QVERIFY(splits.ok());
    QVERIFY(splits->leftOutRuns && !splits->blocks);
    QCOMPARE(splits->splits.size(), std::size_t{3});
    for (std::size_t i = 0; i < 3; ++i) {
        const Split &split = splits->splits[i];
        QVERIFY(split.heldOut == set.runs[i] && split.anchor == set.runs[i]);
        const TrainingSet &training = splits->trainings[split.training];
        QCOMPARE(training.runs.size(), std::size_t{2});
        QCOMPARE(training.referenceTemperatureC, 20.0);
        for (const auto &run : training.runs)
            QVERIFY(run != split.heldOut);
    }
    QCOMPARE(splits->trainings[splits->everything].runs.size(), std::size_t{3});
    QVERIFY(splits->trainedOn[1] == (std::vector<std::string>{"a", "c"}));
}

void TestSplits::makeSplits_holdOut_trainsOnceOnTheRest()
{
    const TrainingSet set = threeRuns();
    const auto splits = makeSplits(set, {"b", "c"});
    QVERIFY(splits.ok());
    QVERIFY(!splits->leftOutRuns);
    QCOMPARE(splits->splits.size(), std::size_t{2});
    QCOMPARE(splits->trainings.size(), std::size_t{1});
    QCOMPARE(splits->everything, std::size_t{0});
    QVERIFY(splits->trainedOn[0] == std::vector<std::string>{"a"});
    QVERIFY(splits->splits[0].name == "b" && splits->splits[1].name == "c");
}

void TestSplits::makeSplits_oneRun_blocksPartitionItsSamples()
{
    TrainingSet set = threeRuns().only({1});
    const auto splits = makeSplits(set, {});
    QVERIFY(splits.ok());
    QVERIFY(splits->blocks);
    QCOMPARE(splits->splits.size(), std::size_t{5});
    std::set<double> seen;
    for (const Split &split : splits->splits) {
        QVERIFY(split.anchor == set.runs[0]);
        for (const double timeS : split.heldOut->timeS)
            QVERIFY(seen.insert(timeS).second);
        const TrainingSet &training = splits->trainings[split.training];
        QCOMPARE(training.runs[0]->timeS.size() + split.heldOut->timeS.size(), Eigen::Index{2000});
        std::set<double> trained(training.runs[0]->timeS.begin(), training.runs[0]->timeS.end());
        for (const double timeS : split.heldOut->timeS)
            QVERIFY(!trained.contains(timeS));
        QCOMPARE(training.runs[0]->curve.totalCount(), static_cast<double>(trained.size()));
    }
    QCOMPARE(seen.size(), std::size_t{2000});
    QVERIFY(splits->splits[2].name == "b, block 3");
    QVERIFY(splits->trainings[splits->everything].runs[0] == set.runs[0]);
}

void TestSplits::makeSplits_oneRun_neighboursStayTogether()
{
    // A ramp of 80 degrees in blocks of 1.25: each fold holds stretches of 31 or 32 samples.
    const auto splits = makeSplits(threeRuns().only({0}), {});
    const Eigen::VectorXd &timeS = splits->splits[0].heldOut->timeS;
    int stretches = 1;
    for (Eigen::Index i = 1; i < timeS.size(); ++i)
        stretches += timeS[i] - timeS[i - 1] > 0.6 ? 1 : 0;
    QCOMPARE(stretches, 13);
}

void TestSplits::makeSplits_badInput_isRefusedWithAReason()
{
    const TrainingSet set = threeRuns();
    const auto unknown = makeSplits(set, {"d"});
    QVERIFY(!unknown.ok() && unknown.error().code == Errc::InvalidOption);
    QVERIFY(unknown.error().message.find("a, b, c") != std::string::npos);
    const auto all = makeSplits(set, {"a", "b", "c"});
    QVERIFY(!all.ok() && all.error().code == Errc::InvalidOption);
    const auto none = makeSplits({}, {});
    QVERIFY(!none.ok() && none.error().code == Errc::NothingUsable);
    TrainingSet withEmpty = set;
    withEmpty.runs.push_back(test::emptyRun("empty", 0));
    const auto empty = makeSplits(withEmpty, {});
    QVERIFY(!empty.ok() && empty.error().code == Errc::NothingUsable);
    QVERIFY(empty.error().message.find("empty") != std::string::npos);
}

void TestSplits::temperatureBlock_isASixtyFourthButNotBelowFourCells()
{
    QCOMPARE(temperatureBlockC(128.0), 2.0);
    QCOMPARE(temperatureBlockC(10.0), 1.04);
}

void TestSplits::partOf_training_keepsOutliersOutOfTheCurve()
{
    auto run = test::emptyRun("run", 4);
    run->timeS << 0.0, 1.0, 2.0, 3.0;
    run->deltaT << 0.0, 1.0, 2.0, 3.0;
    run->tdeDps.setConstant(0.5);
    run->usableForTraining = {1, 0, 1, 1};
    const RunFeatures part = partOf(*run, {1, 1, 0, 1});
    QCOMPARE(part.timeS.size(), Eigen::Index{3});
    QCOMPARE(part.curve.totalCount(), 2.0);
    QCOMPARE(part.usableForTraining, (std::vector<std::uint8_t>{1, 0, 1}));
}

QTEST_APPLESS_MAIN(TestSplits)
#include "tst_splits.moc"
