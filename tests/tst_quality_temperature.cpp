#include "engine/recording/quality.h"
#include "support/synthetic_recording.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace driftbench;
using namespace driftbench::test;

class TestQualityTemperature : public QObject
{
    Q_OBJECT

private slots:
    void stairs_ofARamp_giveTheRampBack();
    void stairs_withFlickerAndPlateaus_stayNearTheTruth();
    void fineSteps_areLeftAlone();
    void spike_isMasked();
    void stuckThenJump_isMasked();
    void heldTemperature_isNotStuck();
};

static bool hasFinding(const Run &run, const std::string &kind)
{
    return std::any_of(run.findings.begin(), run.findings.end(),
                       [&](const Finding &finding) { return finding.kind == kind; });
}

// Rounding a ramp to whole degrees and joining the middles of the steps is the ramp again, but for the half
// interval by which the steps are seen too early or too late.
void TestQualityTemperature::stairs_ofARamp_giveTheRampBack()
{
    RestingGyro gyro;
    gyro.startC = -3.3;
    const Recording truth = restingRecording(gyro);
    Recording recording = truth;
    recording.temperatureC = recording.temperatureC.array().round();
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    QVERIFY(hasFinding(*run, "temperature stairs"));
    const double worst = (run->recording->temperatureC - truth.temperatureC).cwiseAbs().maxCoeff();
    QVERIFY2(worst < 2.0 * gyro.rampCPerS * gyro.intervalS, qPrintable(QString::number(worst)));
}

void TestQualityTemperature::stairs_withFlickerAndPlateaus_stayNearTheTruth()
{
    RestingGyro gyro;
    gyro.durationS = 3600.0;
    Recording truth = restingRecording(gyro);
    Random random(11);
    Recording recording = truth;
    double roundedWorst = 0.0;
    double squares = 0.0;
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        const double timeS = recording.timeS[i];
        const double rampC = 5.2 + 0.02 * std::clamp(timeS - 600.0, 0.0, 2400.0);
        truth.temperatureC[i] = rampC;
        recording.temperatureC[i] = std::round(rampC + 0.05 * random.normal());
        roundedWorst = std::max(roundedWorst, std::abs(recording.temperatureC[i] - rampC));
    }
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    const Eigen::VectorXd error = run->recording->temperatureC - truth.temperatureC;
    for (Eigen::Index i = 6600; i < 29400; ++i)
        squares += error[i] * error[i];
    const double rms = std::sqrt(squares / (29400 - 6600));
    QVERIFY(roundedWorst > 0.5);
    QVERIFY2(rms < 0.06, qPrintable(QString::number(rms))); // rounding alone leaves 0.29
    QVERIFY(error.cwiseAbs().maxCoeff() < 0.6);
}

void TestQualityTemperature::fineSteps_areLeftAlone()
{
    RestingGyro gyro;
    Recording recording = restingRecording(gyro);
    recording.temperatureC = (recording.temperatureC.array() * 2.0).round() / 2.0;
    const Eigen::VectorXd before = recording.temperatureC;
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    QVERIFY(run->recording->temperatureC == before);
    QVERIFY(hasFinding(*run, "temperature steps"));
}

void TestQualityTemperature::spike_isMasked()
{
    Recording recording = restingRecording();
    recording.temperatureC[4000] = 85.0;
    recording.temperatureC[8000] = -300.0;
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    QCOMPARE(run->mask.count(MaskReason::TemperatureFault), 2);
    QVERIFY(run->mask.has(4000, MaskReason::TemperatureFault));
    QVERIFY(run->mask.has(8000, MaskReason::TemperatureFault));
}

void TestQualityTemperature::stuckThenJump_isMasked()
{
    Recording recording = restingRecording();
    for (Eigen::Index i = 4000; i < 6000; ++i)
        recording.temperatureC[i] = recording.temperatureC[3999];
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    QVERIFY(hasFinding(*run, "temperature stuck"));
    QCOMPARE(run->mask.count(MaskReason::TemperatureFault), 2000);
}

void TestQualityTemperature::heldTemperature_isNotStuck()
{
    Recording recording = restingRecording();
    for (Eigen::Index i = 0; i < recording.size(); ++i)
        recording.temperatureC[i] = std::max(20.0, recording.temperatureC[i]);
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    QVERIFY(!hasFinding(*run, "temperature stuck"));
    QCOMPARE(run->mask.count(MaskReason::TemperatureFault), 0);
}

QTEST_APPLESS_MAIN(TestQualityTemperature)
#include "tst_quality_temperature.moc"
