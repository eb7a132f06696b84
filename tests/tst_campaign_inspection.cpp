// How far a campaign's TDE is a curve of temperature, and where the temperature has been.
#include "engine/evaluation/campaign_inspection.h"
#include "engine/models/rbf_trainer.h"
#include "support/recorded_run.h"
#include "support/simple_campaign.h"
#include "support/test_data.h"

#include <QTest>

#include <cmath>

using namespace driftbench;

class TestCampaignInspection : public QObject
{
    Q_OBJECT

private slots:
    void inspect_cleanCurve_leavesTheNoise();
    void inspect_wrongCurve_leavesWhatItMisses();
    void spread_noiseThatGrows_isLocal();
    void coverage_oneSweep_isItsTime();
    void coverage_upAndDown_bothShareIsTheCommonPart();
    void coverage_noRuns_isEmpty();
};

static Eigen::Vector3d bent(double deltaT)
{
    return {0.02 * deltaT, std::sin(0.05 * deltaT), -0.001 * deltaT * deltaT};
}

static AnyModel fitted(const TrainingSet &set)
{
    const auto fit = fitRbfNetwork(set, {.centres = 12});
    Q_ASSERT(fit.ok());
    return fit->network;
}

void TestCampaignInspection::inspect_cleanCurve_leavesTheNoise()
{
    const TrainingSet set = test::simpleCampaign(3, bent);
    const CampaignInspection seen = inspectCampaign(set, fitted(set));
    const std::array<double, 3> swings{1.2, 1.0, 3.6};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        QVERIFY(std::abs(seen.axes[axis].noiseDps - 0.05) < 0.002);
        QVERIFY(std::abs(seen.axes[axis].leftDps - 0.05) < 0.002);
        QVERIFY(std::abs(seen.axes[axis].swingDps - swings[axis]) < 0.1);
        QCOMPARE(seen.axes[axis].kind, CurveKind::Curve);
        QVERIFY(seen.axes[axis].spreadDps < 0.02); // means of some hundred samples
    }
}

void TestCampaignInspection::inspect_wrongCurve_leavesWhatItMisses()
{
    const TrainingSet set = test::simpleCampaign(2, bent);
    const ConstantModel constant{};
    const CampaignInspection seen = inspectCampaign(set, constant);
    double squares = 0.0;
    for (const auto &run : set.runs)
        squares += run->tdeDps.col(2).squaredNorm() / double(run->tdeDps.rows()) / double(set.runs.size());
    QVERIFY(std::abs(seen.axes[2].leftDps - std::sqrt(squares)) < 1e-6);
    QCOMPARE(seen.axes[2].kind, CurveKind::Not);
}

void TestCampaignInspection::spread_noiseThatGrows_isLocal()
{
    const auto curve = [](double) { return Eigen::Vector3d::Zero().eval(); };
    test::SimpleRunOptions low, high;
    low.highestDeltaT = 30.0;
    low.noiseDps = 0.01;
    high.lowestDeltaT = 30.0;
    high.noiseDps = 0.1;
    TrainingSet set;
    set.runs = {test::simpleRun("low", curve, low, Random(1)),
                test::simpleRun("high", curve, high, Random(2))};
    const ConstantModel constant{};
    const ResidualSpread spread = inspectCampaign(set, constant).spread;
    QCOMPARE(spread.deltaT.size(), Eigen::Index{60});
    QVERIFY(std::abs(spread.rmsDps(15, 0) - 0.01) < 0.001);
    QVERIFY(std::abs(spread.rmsDps(45, 1) - 0.1) < 0.01);
}

void TestCampaignInspection::coverage_oneSweep_isItsTime()
{
    const TrainingSet set = test::simpleCampaign(1, bent); // -20 to 40 degrees in 600 s
    const TemperatureCoverage coverage = coverageOf(set);
    QCOMPARE(coverage.firstC, -20.0);
    QVERIFY(std::abs(coverage.heatingS.sum() - 600.0) < 0.2);
    QCOMPARE(coverage.coolingS.sum(), 0.0);
    QVERIFY(std::abs(coverage.heatingS[30] - 10.0) < 0.2);
    QCOMPARE(coverage.bothShare, 0.0);
    QCOMPARE(coverage.lowestC, -20.0);
    QCOMPARE(coverage.highestC, 40.0);
}

void TestCampaignInspection::coverage_upAndDown_bothShareIsTheCommonPart()
{
    test::SimpleRunOptions up, down;
    down.lowestDeltaT = 60.0;
    down.highestDeltaT = 30.0;
    TrainingSet set;
    set.runs = {test::simpleRun("up", bent, up, Random(1)), test::simpleRun("down", bent, down, Random(2))};
    const TemperatureCoverage coverage = coverageOf(set);
    QVERIFY(std::abs(coverage.bothShare - 0.5) < 0.03);
}

void TestCampaignInspection::coverage_noRuns_isEmpty()
{
    const TemperatureCoverage coverage = coverageOf({});
    QCOMPARE(coverage.heatingS.size(), Eigen::Index{0});
    QCOMPARE(coverage.bothShare, 0.0);
}

QTEST_GUILESS_MAIN(TestCampaignInspection)
#include "tst_campaign_inspection.moc"
