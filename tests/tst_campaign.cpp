#include "engine/base/axes.h"
#include "engine/recording/campaign.h"
#include "engine/recording/initial_hold.h"
#include "support/synthetic_recording.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestCampaign : public QObject
{
    Q_OBJECT

private slots:
    void makeCampaign_sameNames_makesThemUnique();
    void makeCampaign_differentSensors_namesBoth();
    void makeCampaign_unknownSensor_fitsAny();
    void makeCampaign_copyUnderAnotherName_isRefused();
    void makeCampaign_radiansBesideDegrees_isRefused();
    void makeCampaign_onlyNoiseApart_warns();
    void makeCampaign_allInRadians_warns();
    void makeCampaign_turningTable_warnsUnlessGiven();
    void makeCampaign_noRuns_isRefused();
    void holdReference_isTheMeanOfTheHold();
    void holdReference_withoutHold_isRefused();
    void findInitialHold_ramp_isNone();
};

static Run runOf(Recording recording, const std::string &name)
{
    Run run;
    run.name = name;
    recording.info.source = name + ".csv";
    run.mask = Mask(recording.size());
    run.recording = std::make_shared<const Recording>(std::move(recording));
    return run;
}

static Run restingRun(std::uint64_t seed, const std::string &name)
{
    RestingGyro gyro;
    gyro.seed = seed;
    return runOf(restingRecording(gyro), name);
}

static Recording heldRecording(std::uint64_t seed)
{
    RestingGyro gyro;
    gyro.seed = seed;
    gyro.driftDpsPerC = 0.0;
    gyro.referenceRateDps = {25.0, 5.0, 53.0};
    Recording recording = restingRecording(gyro);
    for (Eigen::Index i = 0; i < recording.size(); ++i)
        recording.temperatureC[i] = -40.0 + 0.05 * std::max(0.0, recording.timeS[i] - 300.0);
    return recording;
}

void TestCampaign::makeCampaign_sameNames_makesThemUnique()
{
    const auto campaign = makeCampaign(
        {restingRun(1, "run"), restingRun(2, "run"), restingRun(3, "run-2"), restingRun(4, "run")});
    QVERIFY(campaign);
    QCOMPARE(campaign->runs[0].name, std::string("run"));
    QCOMPARE(campaign->runs[1].name, std::string("run-2"));
    QCOMPARE(campaign->runs[2].name, std::string("run-2-2"));
    QCOMPARE(campaign->runs[3].name, std::string("run-3"));
    QVERIFY(campaign->warnings.empty());
}

void TestCampaign::makeCampaign_differentSensors_namesBoth()
{
    Recording first = restingRecording();
    first.info.sensor = {"I3G4250D", "SIM-0001"};
    RestingGyro gyro;
    gyro.seed = 2;
    Recording second = restingRecording(gyro);
    second.info.sensor = {"I3G4250D", "SIM-0002"};
    const auto campaign = makeCampaign({runOf(first, "a"), runOf(second, "b")});
    QVERIFY(!campaign);
    QCOMPARE(campaign.error().code, Errc::DifferentSensors);
    for (const char *part : {"a.csv", "b.csv", "SIM-0001", "SIM-0002"})
        QVERIFY(campaign.error().message.find(part) != std::string::npos);
}

void TestCampaign::makeCampaign_unknownSensor_fitsAny()
{
    Recording first = restingRecording();
    first.info.sensor = {"", "SIM-0001"};
    const auto campaign = makeCampaign({restingRun(2, "a"), runOf(first, "b")});
    QVERIFY(campaign);
    QCOMPARE(campaign->sensor.serial, std::string("SIM-0001"));
}

void TestCampaign::makeCampaign_copyUnderAnotherName_isRefused()
{
    const auto campaign = makeCampaign({restingRun(1, "a"), restingRun(2, "b"), restingRun(1, "c")});
    QVERIFY(!campaign);
    QCOMPARE(campaign.error().code, Errc::SameRecordingTwice);
    QVERIFY(campaign.error().message.find("a.csv and c.csv") != std::string::npos);
}

void TestCampaign::makeCampaign_radiansBesideDegrees_isRefused()
{
    RestingGyro gyro;
    gyro.seed = 2;
    Recording radians = restingRecording(gyro);
    radians.rateDps /= kDegreesPerRadian;
    const auto campaign = makeCampaign({restingRun(1, "a"), runOf(radians, "b")});
    QVERIFY(!campaign);
    QCOMPARE(campaign.error().code, Errc::UnitsDiffer);
}

void TestCampaign::makeCampaign_onlyNoiseApart_warns()
{
    RestingGyro gyro;
    gyro.seed = 2;
    gyro.noiseDps = 0.14 / kDegreesPerRadian;
    const auto campaign = makeCampaign({restingRun(1, "a"), runOf(restingRecording(gyro), "b")});
    QVERIFY(campaign);
    QCOMPARE(campaign->warnings.size(), std::size_t{1});
    QVERIFY(campaign->warnings[0].find("check their units") != std::string::npos);
}

void TestCampaign::makeCampaign_allInRadians_warns()
{
    std::vector<Run> runs;
    for (std::uint64_t seed : {1, 2}) {
        RestingGyro gyro;
        gyro.seed = seed;
        gyro.noiseDps = 0.05;
        Recording radians = restingRecording(gyro);
        radians.rateDps /= kDegreesPerRadian;
        runs.push_back(runOf(radians, "r" + std::to_string(seed)));
    }
    const auto campaign = makeCampaign(std::move(runs));
    QVERIFY(campaign);
    QCOMPARE(campaign->warnings.size(), std::size_t{2});
    QVERIFY(campaign->warnings[0].find("rad/s?") != std::string::npos);
}

void TestCampaign::makeCampaign_turningTable_warnsUnlessGiven()
{
    const auto warned = makeCampaign({runOf(heldRecording(1), "a")});
    QVERIFY(warned);
    QCOMPARE(warned->warnings.size(), std::size_t{2}); // 25 and 53 dps; 5 dps may be a bias
    QVERIFY(warned->warnings[0].find("was the table turning?") != std::string::npos);
    CampaignOptions options;
    options.referenceRateDps = {25.0, 5.0, 53.0};
    const auto given = makeCampaign({runOf(heldRecording(1), "a")}, options);
    QVERIFY(given);
    QVERIFY(given->warnings.empty());
    QCOMPARE(given->runs[0].referenceRateDps, options.referenceRateDps);
}

void TestCampaign::makeCampaign_noRuns_isRefused()
{
    QCOMPARE(makeCampaign({}).error().code, Errc::NothingUsable);
}

void TestCampaign::holdReference_isTheMeanOfTheHold()
{
    Recording recording = heldRecording(1);
    const Eigen::Vector3d expected = recording.rateDps.topRows(3000).colwise().mean();
    const auto hold = findInitialHold(runOf(recording, "a"));
    QVERIFY(hold);
    QVERIFY(std::abs(hold->endS - 300.0) < 2.5);
    QVERIFY(std::abs(hold->meanTemperatureC + 40.0) < 0.001);
    CampaignOptions options;
    options.referenceRate = ReferenceRateKind::InitialHold;
    const auto campaign = makeCampaign({runOf(recording, "a")}, options);
    QVERIFY(campaign);
    QVERIFY((campaign->runs[0].referenceRateDps - expected).cwiseAbs().maxCoeff() < 0.002);
}

void TestCampaign::holdReference_withoutHold_isRefused()
{
    CampaignOptions options;
    options.referenceRate = ReferenceRateKind::InitialHold;
    const auto campaign = makeCampaign({restingRun(1, "a")}, options);
    QVERIFY(!campaign);
    QCOMPARE(campaign.error().code, Errc::NothingUsable);
}

// Slow enough to stay in the band for a minute, and still no hold.
void TestCampaign::findInitialHold_ramp_isNone()
{
    for (const double rampCPerS : {0.05, 0.012, 0.008, -0.008}) {
        RestingGyro gyro;
        gyro.rampCPerS = rampCPerS;
        QVERIFY(!findInitialHold(runOf(restingRecording(gyro), "a")));
    }
}

QTEST_APPLESS_MAIN(TestCampaign)
#include "tst_campaign.moc"
