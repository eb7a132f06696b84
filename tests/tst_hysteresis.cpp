#include "engine/evaluation/hysteresis.h"
#include "engine/evaluation/repeatability.h"
#include "engine/evaluation/sweeps.h"
#include "support/recorded_run.h"
#include "support/test_data.h"
#include "support/thermal_runs.h"

#include <QTest>

using namespace driftbench;

class TestHysteresis : public QObject
{
    Q_OBJECT

private slots:
    void sweepsOf_upHoldDown_areTwoThatMakeTheWhole();
    void sweepsOf_noiseOfTheThermometer_isNoTurn();
    void analyse_heatingAgainstCooling_isTheirDifference();
    void analyse_heatingOnly_saysSo();
    void analyse_nothingInCommon_namesNoTemperature();
    void repeatability_offsetsOfRuns_areTheRepeat();
    void repeatability_noCommonTemperature_isUnknown();
    void repeatability_noDrift_hasNoVarianceOverTemperature();
    void chamber_passagesAndRepeatability_areThePublishedOnes();
    void chamberAsOneRun_threeSweeps_readAsTheRuns();
};

// Up from 0 to 40, still for a while, down again; cooling reads `lag` more.
static std::shared_ptr<RunFeatures> upAndDown(const std::string &name, double lag, double thermometerNoiseC)
{
    Random random(31);
    auto run = test::emptyRun(name, 3000);
    for (int i = 0; i < 3000; ++i) {
        const double deltaT = i < 1300 ? i * 40.0 / 1300.0 : i < 1700 ? 40.0 : 40.0 * (3000 - i) / 1300.0;
        run->timeS[i] = i;
        run->deltaT[i] = deltaT + thermometerNoiseC * random.normal();
        run->tdeDps.row(i).setConstant(0.01 * deltaT + (i < 1500 ? 0.0 : lag));
    }
    run->curve.add(run->deltaT, run->tdeDps);
    return run;
}

void TestHysteresis::sweepsOf_upHoldDown_areTwoThatMakeTheWhole()
{
    const auto sweeps = sweepsOf(*upAndDown("run", 0.0, 0.0));
    QCOMPARE(sweeps.size(), std::size_t{2});
    QVERIFY(sweeps[0].heating && !sweeps[1].heating);
    QCOMPARE(sweeps[0].first, Eigen::Index{0});
    QCOMPARE(sweeps[0].last, sweeps[1].first);
    QVERIFY(sweeps[0].last >= 1299 && sweeps[0].last <= 1701);
    QCOMPARE(sweeps[1].last, Eigen::Index{3000});
}

void TestHysteresis::sweepsOf_noiseOfTheThermometer_isNoTurn()
{
    QCOMPARE(sweepsOf(*upAndDown("run", 0.0, 0.3)).size(), std::size_t{2});
    Random random(32);
    const auto still = test::makeRun(
        "still", {500, 1.0, 5.0, 5.5, 0.1}, [](double) { return Eigen::Vector3d::Zero().eval(); }, random);
    QCOMPARE(sweepsOf(*still).size(), std::size_t{1});
}

void TestHysteresis::analyse_heatingAgainstCooling_isTheirDifference()
{
    const TrainingSet set{{upAndDown("a", 0.2, 0.0), upAndDown("b", 0.2, 0.0)}, 10.0};
    const Hysteresis hysteresis = analyseHysteresis(set);
    QVERIFY(hysteresis.heatingAndCooling);
    // The cell of the hold has both.
    QVERIFY((hysteresis.rmsDps.array() - 0.2).abs().maxCoeff() < 0.005);
    QCOMPARE(hysteresis.passages.size(), std::size_t{4});
    QCOMPARE(hysteresis.meetingTemperatureC, 30.0); // of 10, 15 .. 50
    QVERIFY(std::abs(hysteresis.passages[0].tdeDps[0] - 0.2) < 1e-3);
    QVERIFY(std::abs(hysteresis.passages[1].tdeDps[0] - 0.4) < 1e-3);
    QVERIFY(hysteresis.passages[2].run == "b" && hysteresis.passages[2].heating);
}

void TestHysteresis::analyse_heatingOnly_saysSo()
{
    Random random(33);
    const auto zero = [](double) { return Eigen::Vector3d::Zero().eval(); };
    const TrainingSet set{{test::makeRun("a", {}, zero, random), test::makeRun("b", {}, zero, random)}, 0.0};
    const Hysteresis hysteresis = analyseHysteresis(set);
    QVERIFY(!hysteresis.heatingAndCooling);
    QVERIFY(hysteresis.rmsDps.array().isNaN().all());
    QCOMPARE(hysteresis.passages.size(), std::size_t{2});
}

void TestHysteresis::analyse_nothingInCommon_namesNoTemperature()
{
    Random random(34);
    const auto zero = [](double) { return Eigen::Vector3d::Zero().eval(); };
    const TrainingSet set{{test::makeRun("a", {2000, 0.5, 0.0, 30.0, 0.1}, zero, random),
                           test::makeRun("b", {2000, 0.5, 50.0, 80.0, 0.1}, zero, random)},
                          0.0};
    const Hysteresis hysteresis = analyseHysteresis(set);
    QVERIFY(hysteresis.passages.empty());
    QVERIFY(std::isnan(hysteresis.meetingTemperatureC));
}

void TestHysteresis::repeatability_offsetsOfRuns_areTheRepeat()
{
    Random random(35);
    TrainingSet set;
    for (const double offset : {-0.1, 0.0, 0.1}) {
        const auto tde = [offset](double d) { return Eigen::Vector3d(0.02 * d + offset, 0.02 * d, offset); };
        set.runs.push_back(test::makeRun("run", {4000, 0.5, 0.0, 80.0, 1e-6}, tde, random));
    }
    const Repeatability result = analyseRepeatability(set);
    QCOMPARE(result.runs, 3);
    const double curve = 0.0004 * 6400.0 / 12.0;
    QVERIFY(std::abs(result.repeatRmsDps[0] - 0.1) < 1e-4);
    QVERIFY(std::abs(result.curveRmsDps[1] / std::sqrt(curve) - 1.0) < 0.02);
    QVERIFY(std::abs(result.gainModelFree[0] - curve / (curve + 0.015)) < 0.005);
    QVERIFY(result.gainModelFree[1] > 0.9999);
    QVERIFY(result.gainModelFree[2] < 0.01);
}

void TestHysteresis::repeatability_noCommonTemperature_isUnknown()
{
    Random random(36);
    const auto zero = [](double) { return Eigen::Vector3d::Zero().eval(); };
    const TrainingSet apart{{test::makeRun("a", {2000, 0.5, 0.0, 30.0, 0.1}, zero, random),
                             test::makeRun("b", {2000, 0.5, 50.0, 80.0, 0.1}, zero, random)},
                            0.0};
    QVERIFY(analyseRepeatability(apart).gainModelFree.array().isNaN().all());
    const TrainingSet single{{test::makeRun("a", {}, zero, random)}, 0.0};
    QVERIFY(analyseRepeatability(single).gainModelFree.array().isNaN().all());
}

void TestHysteresis::repeatability_noDrift_hasNoVarianceOverTemperature()
{
    Random random(37);
    TrainingSet set;
    for (int i = 0; i < 20; ++i)
        set.runs.push_back(test::makeRun(
            "run", {}, [](double d) { return Eigen::Vector3d(0.0, 0.01 * d, 1.0); }, random));
    const Repeatability result = analyseRepeatability(set);
    QVERIFY(std::abs(result.inRunVariance[0]) < 0.005 * 0.01);
    QVERIFY(std::abs(result.inRunVariance[1] / (1e-4 * 6400.0 / 12.0) - 1.0) < 0.02);
    QVERIFY(std::abs(result.inRunVariance[2]) < 0.005 * 0.01);
}

void TestHysteresis::chamber_passagesAndRepeatability_areThePublishedOnes()
{
    REQUIRE_SHARED_DATA(path, "climate_chamber/run1_cooling.csv");
    const auto folder = path.parent_path();
    const TrainingSet set{{test::recordedRun(path, "run1", 1, -17.0),
                           test::recordedRun(folder / "run2_heating.csv", "run2", 0, -17.0),
                           test::recordedRun(folder / "run3_cooling.csv", "run3", 0, -17.0)},
                          -17.0};
    const Hysteresis hysteresis = analyseHysteresis(set);
    QCOMPARE(hysteresis.meetingTemperatureC, 40.0);
    QCOMPARE(hysteresis.passages.size(), std::size_t{3});
    const double read[3] = {-3.99, -4.21, -3.42};
    const bool heating[3] = {false, true, false};
    for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(std::abs(hysteresis.passages[i].tdeDps[0] - read[i]) < 0.005);
        QCOMPARE(hysteresis.passages[i].heating, heating[i]);
    }
    const Repeatability result = analyseRepeatability(set);
    QVERIFY(std::abs(result.repeatRmsDps[0] - 0.32) < 0.005);
    QVERIFY(std::abs(result.repeatRmsDps[2] - 0.13) < 0.006);
    QVERIFY(std::abs(result.gainModelFree[0] - 0.16) < 0.015);
    QVERIFY(std::abs(result.gainModelFree[1] - 0.993) < 0.001);
    QVERIFY(result.gainModelFree[2] < 0.02);
}

void TestHysteresis::chamberAsOneRun_threeSweeps_readAsTheRuns()
{
    REQUIRE_SHARED_DATA(path, "climate_chamber/chamber_all.csv");
    const TrainingSet set{{test::recordedRun(path, "all", 1, 0.0)}, 0.0};
    const Hysteresis hysteresis = analyseHysteresis(set);
    QCOMPARE(hysteresis.passages.size(), std::size_t{3});
    QVERIFY(std::abs(hysteresis.passages[2].tdeDps[0] + 3.42) < 0.005);
    QVERIFY(analyseRepeatability(set).sweeps);
    QVERIFY(std::abs(analyseRepeatability(set).gainModelFree[0] - 0.16) < 0.03);
}

QTEST_APPLESS_MAIN(TestHysteresis)
#include "tst_hysteresis.moc"
