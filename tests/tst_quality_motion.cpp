#include "engine/recording/quality.h"
#include "support/synthetic_recording.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace driftbench;
using namespace driftbench::test;

class TestQualityMotion : public QObject
{
    Q_OBJECT

private slots:
    void stillGyro_isNotMasked_data();
    void stillGyro_isNotMasked();
    void steepDriftInSteps_isNotMasked();
    void noiseBurstOfQuietGyro_isNotMasked();
    void quantisedQuietGyro_isNotMasked();
    void turn_isMaskedAndLittleElse_data();
    void turn_isMaskedAndLittleElse();
    void slowTilt_halfDpsInNoise_isMasked();
    void handlingShocks_areMasked();
    void turnBetweenShocks_isMaskedWhole();
    void tableStartsLate_itsStartIsMasked();
    void biasStep_isReportedNotMasked();
};

static Eigen::Index maskedBetween(const Run &run, double startS, double endS)
{
    Eigen::Index count = 0;
    for (Eigen::Index i = 0; i < run.recording->size(); ++i) {
        const double timeS = run.recording->timeS[i];
        if (timeS >= startS && timeS < endS && run.mask.has(i, MaskReason::Motion))
            ++count;
    }
    return count;
}

static const Finding *findingOf(const Run &run, const std::string &kind)
{
    const auto found = std::find_if(run.findings.begin(), run.findings.end(),
                                    [&](const Finding &finding) { return finding.kind == kind; });
    return found == run.findings.end() ? nullptr : &*found;
}

void TestQualityMotion::stillGyro_isNotMasked_data()
{
    QTest::addColumn<double>("intervalS");
    QTest::addColumn<double>("noiseDps");
    QTest::addColumn<double>("rateX");
    QTest::newRow("10 Hz") << 0.1 << 0.14 << 0.0;
    QTest::newRow("rate table") << 0.1 << 0.14 << 25.0;
    QTest::newRow("fast rate table") << 0.1 << 0.14 << 53.0;
    QTest::newRow("50 Hz, quiet") << 0.02 << 0.005 << 5.0;
    QTest::newRow("2 Hz") << 0.5 << 0.02 << 0.0;
    QTest::newRow("loud") << 0.1 << 1.0 << 0.0;
}

void TestQualityMotion::stillGyro_isNotMasked()
{
    QFETCH(const double, intervalS);
    QFETCH(const double, noiseDps);
    QFETCH(const double, rateX);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        RestingGyro gyro;
        gyro.intervalS = intervalS;
        gyro.noiseDps = noiseDps;
        gyro.referenceRateDps = {rateX, 5.0, 0.0};
        gyro.seed = seed;
        const CheckedRun checked = checkRun(restingRecording(gyro));
        QVERIFY(!checked.refusal);
        QCOMPARE(checked.run.mask.count(MaskReason::Motion), 0);
        QVERIFY2(!findingOf(checked.run, "bias step"), qPrintable(QString::number(seed)));
    }
}

// The temperature goes up in sharp steps of 0.5 degrees, and the bias over it and back within minutes.
void TestQualityMotion::steepDriftInSteps_isNotMasked()
{
    RestingGyro gyro;
    gyro.durationS = 6000.0;
    gyro.driftDpsPerC = 0.0;
    Recording recording = restingRecording(gyro);
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        const double temperatureC = 0.5 * std::floor(recording.timeS[i] / 30.0);
        recording.temperatureC[i] = temperatureC;
        const double bump = std::exp(-0.5 * std::pow((temperatureC - 60.0) / 2.5, 2));
        recording.rateDps(i, 0) += std::tanh((temperatureC - 30.0) / 1.5) + 1.5 * bump;
    }
    const CheckedRun checked = checkRun(std::move(recording));
    QVERIFY(!checked.refusal);
    QCOMPARE(checked.run.mask.count(MaskReason::Motion), 0);
}

void TestQualityMotion::noiseBurstOfQuietGyro_isNotMasked()
{
    RestingGyro gyro;
    gyro.noiseDps = 0.02;
    Recording recording = restingRecording(gyro);
    Random random(7);
    for (Eigen::Index i = 4000; i < 4600; ++i) {
        for (int axis = 0; axis < 3; ++axis)
            recording.rateDps(i, axis) += 0.1 * random.normal();
    }
    const CheckedRun checked = checkRun(std::move(recording));
    QCOMPARE(checked.run.mask.count(MaskReason::Motion), 0);
}

void TestQualityMotion::quantisedQuietGyro_isNotMasked()
{
    RestingGyro gyro;
    gyro.noiseDps = 0.004;
    gyro.driftDpsPerC = 0.002;
    Recording recording = restingRecording(gyro);
    recording.rateDps = (recording.rateDps.array() / 0.00875).round() * 0.00875;
    const CheckedRun checked = checkRun(std::move(recording));
    QVERIFY(!checked.refusal);
    QCOMPARE(checked.run.mask.count(MaskReason::Motion), 0);
    QCOMPARE(checked.run.mask.count(MaskReason::Saturated), 0);
}

void TestQualityMotion::turn_isMaskedAndLittleElse_data()
{
    QTest::addColumn<double>("rateDps");
    QTest::addColumn<double>("durationS");
    QTest::addColumn<double>("referenceDps");
    QTest::newRow("5 dps for 60 s") << 5.0 << 60.0 << 0.0;
    QTest::newRow("5 dps for 60 s on a table") << 5.0 << 60.0 << 53.0;
    QTest::newRow("-2 dps for 300 s") << -2.0 << 300.0 << 0.0;
    QTest::newRow("90 dps for 4 s") << 90.0 << 4.0 << 25.0;
    QTest::newRow("1 dps for 20 s") << 1.0 << 20.0 << 0.0;
}

void TestQualityMotion::turn_isMaskedAndLittleElse()
{
    QFETCH(const double, rateDps);
    QFETCH(const double, durationS);
    QFETCH(const double, referenceDps);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        RestingGyro gyro;
        gyro.seed = seed;
        gyro.referenceRateDps = {0.0, referenceDps, 0.0};
        Recording recording = restingRecording(gyro);
        turn(recording, 500.0, 500.0 + durationS, rateDps, 1);
        const CheckedRun checked = checkRun(std::move(recording));
        QCOMPARE(maskedBetween(checked.run, 500.0, 500.0 + durationS),
                 static_cast<Eigen::Index>(std::lround(durationS / gyro.intervalS)));
        const auto extra = static_cast<double>(checked.run.mask.count(MaskReason::Motion)) * gyro.intervalS;
        QVERIFY2(extra < durationS + 20.0, qPrintable(QString::number(extra)));
        const Finding *finding = findingOf(checked.run, "motion");
        QVERIFY(finding);
        QVERIFY(finding->startS <= 500.0 && finding->endS >= 500.0 + durationS - gyro.intervalS);
    }
}

void TestQualityMotion::slowTilt_halfDpsInNoise_isMasked()
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        RestingGyro gyro;
        gyro.seed = seed;
        Recording recording = restingRecording(gyro);
        turn(recording, 700.0, 760.0, 0.5, 2);
        const CheckedRun checked = checkRun(std::move(recording));
        QVERIFY2(maskedBetween(checked.run, 700.0, 760.0) > 560, qPrintable(QString::number(seed)));
        QVERIFY(checked.run.mask.count(MaskReason::Motion) < 800);
    }
}

void TestQualityMotion::handlingShocks_areMasked()
{
    Recording recording = restingRecording();
    for (const double startS : {200.0, 640.0}) {
        for (Eigen::Index i = 0; i < recording.size(); ++i) {
            const double timeS = recording.timeS[i] - startS;
            if (timeS >= 0.0 && timeS < 1.5)
                recording.rateDps(i, 0) += 20.0 * std::sin(2.0 * std::numbers::pi * 1.7 * timeS + 0.3);
        }
    }
    const CheckedRun checked = checkRun(std::move(recording));
    QVERIFY(maskedBetween(checked.run, 200.0, 201.5) == 15);
    QVERIFY(maskedBetween(checked.run, 640.0, 641.5) == 15);
    QVERIFY(checked.run.mask.count(MaskReason::Motion) < 100);
    QCOMPARE(checked.run.findings.back().kind, std::string("motion"));
}

void TestQualityMotion::turnBetweenShocks_isMaskedWhole()
{
    Recording recording = restingRecording();
    Random random(3);
    turn(recording, 300.0, 400.0, 3.0);
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        const double timeS = recording.timeS[i];
        if ((timeS >= 298.0 && timeS < 303.0) || (timeS >= 398.0 && timeS < 402.0))
            recording.rateDps(i, 0) += 15.0 * random.normal();
    }
    const CheckedRun checked = checkRun(std::move(recording));
    QVERIFY(maskedBetween(checked.run, 298.5, 401.5) >= 1029);
    QVERIFY(checked.run.mask.count(MaskReason::Motion) < 1300);
}

void TestQualityMotion::tableStartsLate_itsStartIsMasked()
{
    Recording recording = restingRecording();
    turn(recording, 20.0, 1e9, 25.0);
    const CheckedRun checked = checkRun(std::move(recording));
    QCOMPARE(maskedBetween(checked.run, 0.0, 20.0), 200);
    QVERIFY(checked.run.mask.count(MaskReason::Motion) < 300);
}

void TestQualityMotion::biasStep_isReportedNotMasked()
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        RestingGyro gyro;
        gyro.seed = seed;
        Recording recording = restingRecording(gyro);
        turn(recording, 600.0, 1e9, 0.5, 2);
        const CheckedRun checked = checkRun(std::move(recording));
        QCOMPARE(checked.run.mask.count(MaskReason::Motion), 0);
        const Finding *finding = findingOf(checked.run, "bias step");
        QVERIFY(finding);
        QVERIFY(std::abs(finding->startS - 600.0) < 10.0);
        QVERIFY2(finding->message.find("bias of z steps by 0.") != std::string::npos,
                 finding->message.c_str());
    }
}

QTEST_APPLESS_MAIN(TestQualityMotion)
#include "tst_quality_motion.moc"
