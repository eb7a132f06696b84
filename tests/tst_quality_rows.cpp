// Bad rows and what is too little to work with.
#include "engine/recording/quality.h"
#include "engine/recording/run_report.h"
#include "support/synthetic_recording.h"

#include <QTest>

#include <limits>

using namespace driftbench;
using namespace driftbench::test;

class TestQualityRows : public QObject
{
    Q_OBJECT

private slots:
    void cleanRecording_hasNothingMasked();
    void nonFiniteValue_isRefusedByRowAndColumn();
    void nonFiniteValue_maskBadRows_isMasked();
    void duplicateTimes_areMaskedAndCounted();
    void backwardTime_isRefusedBySampleAndTime();
    void backwardTime_maskBadRows_masksTheFewest();
    void gaps_areCountedWithWhatIsMissing();
    void excludedRange_isMasked();
    void startUpRows_areMasked();
    void saturation_isMasked();
    void spikes_areOutliersOfTraining();
    void constantNoise_hasNoOutliers();
    void tooLittle_isRefused_data();
    void tooLittle_isRefused();
    void smallSpan_override_isAWarning();
    void everythingExcluded_isRefused();
    void summarise_knownRun_givesItsFigures();
};

static std::string messages(const Run &run, const std::string &kind)
{
    std::string all;
    for (const Finding &finding : run.findings) {
        if (finding.kind == kind)
            all += finding.message;
    }
    return all;
}

static bool contains(const std::string &text, const std::string &part)
{
    return text.find(part) != std::string::npos;
}

void TestQualityRows::cleanRecording_hasNothingMasked()
{
    RestingGyro gyro;
    const auto run = prepareRun(restingRecording(gyro));
    QVERIFY(run);
    QCOMPARE(run->name, std::string("resting"));
    QCOMPARE(run->mask.countUsableForJudging(), 12000);
    QVERIFY(run->findings.empty() || run->findings.front().kind == "outlier");
}

void TestQualityRows::nonFiniteValue_isRefusedByRowAndColumn()
{
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()}) {
        Recording recording = restingRecording();
        recording.rateDps(41, 1) = bad;
        const auto run = prepareRun(std::move(recording));
        QVERIFY(!run);
        QCOMPARE(run.error().code, Errc::NonFiniteValue);
        QVERIFY(contains(run.error().message, "resting.csv: "));
        QVERIFY(contains(run.error().message, "sample 42 (rate of y)"));
    }
}

void TestQualityRows::nonFiniteValue_maskBadRows_isMasked()
{
    Recording recording = restingRecording();
    recording.temperatureC[100] = std::numeric_limits<double>::quiet_NaN();
    recording.timeS[200] = std::numeric_limits<double>::infinity();
    recording.rateDps(300, 0) = -std::numeric_limits<double>::infinity();
    recording.rateDps(300, 1) = std::numeric_limits<double>::infinity();
    QualityOptions options;
    options.maskBadRows = true;
    const auto run = prepareRun(std::move(recording), options);
    QVERIFY(run);
    QCOMPARE(run->mask.count(MaskReason::NonFinite), 3);
    QVERIFY(run->mask.has(100, MaskReason::NonFinite) && run->mask.has(200, MaskReason::NonFinite) &&
            run->mask.has(300, MaskReason::NonFinite));
    QCOMPARE(run->mask.countUsableForJudging(), 12000 - 3);
}

void TestQualityRows::duplicateTimes_areMaskedAndCounted()
{
    Recording recording = restingRecording();
    recording.timeS[501] = recording.timeS[500];
    recording.timeS[502] = recording.timeS[500];
    recording.timeS[900] = recording.timeS[899];
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    QCOMPARE(run->mask.count(MaskReason::BadTime), 3);
    QVERIFY(!run->mask.has(500, MaskReason::BadTime) && run->mask.has(502, MaskReason::BadTime));
    QVERIFY(contains(messages(*run, "duplicate time"), "3 samples repeat"));
}

void TestQualityRows::backwardTime_isRefusedBySampleAndTime()
{
    Recording recording = restingRecording();
    recording.timeS[700] = 12.5;
    const auto run = prepareRun(std::move(recording));
    QVERIFY(!run);
    QCOMPARE(run.error().code, Errc::TimeBackwards);
    QVERIFY(contains(run.error().message, "sample 701, from 69.900 to 12.500 s"));
}

void TestQualityRows::backwardTime_maskBadRows_masksTheFewest()
{
    Recording recording = restingRecording();
    recording.timeS[700] = 12.5;    // one back
    recording.timeS[2000] = 9999.0; // one far ahead, which must not cost all that follow
    QualityOptions options;
    options.maskBadRows = true;
    const auto run = prepareRun(std::move(recording), options);
    QVERIFY(run);
    QCOMPARE(run->mask.count(MaskReason::BadTime), 2);
    QVERIFY(run->mask.has(700, MaskReason::BadTime) && run->mask.has(2000, MaskReason::BadTime));
}

void TestQualityRows::gaps_areCountedWithWhatIsMissing()
{
    Recording recording = restingRecording();
    recording.timeS.tail(6000).array() += 20.0;
    recording.timeS.tail(1000).array() += 3.0;
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    const std::string message = messages(*run, "gap");
    QVERIFY2(contains(message, "2 gaps in time: 23.0 s are missing"), message.c_str());
    QVERIFY2(contains(message, "from 599.9 to 620.0 s"), message.c_str());
}

void TestQualityRows::excludedRange_isMasked()
{
    QualityOptions options;
    options.excluded = {{100.0, 199.95}};
    const auto run = prepareRun(restingRecording(), options);
    QVERIFY(run);
    QCOMPARE(run->mask.count(MaskReason::Excluded), 1000);
}

void TestQualityRows::startUpRows_areMasked()
{
    Recording recording = restingRecording();
    recording.rateDps(0, 0) = 250.0;
    recording.rateDps(1, 2) = -40.0;
    recording.temperatureC[2] = 85.0;
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    QCOMPARE(run->mask.count(MaskReason::StartUp), 3);
    QCOMPARE(run->mask.countUsableForJudging(), 12000 - 3);
}

void TestQualityRows::saturation_isMasked()
{
    Recording recording = restingRecording();
    for (Eigen::Index i = 5000; i < 5020; ++i)
        recording.rateDps(i, 1) = 286.7;
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    QCOMPARE(run->mask.count(MaskReason::Saturated), 20);
    QVERIFY(contains(messages(*run, "saturation"), "The rate of y"));
}

void TestQualityRows::spikes_areOutliersOfTraining()
{
    Recording recording = restingRecording();
    for (Eigen::Index i = 50; i < recording.size(); i += 100)
        recording.rateDps(i, i % 3) += 3.0;
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    QCOMPARE(run->mask.countUsableForJudging(), 12000);
    for (Eigen::Index i = 50; i < 12000; i += 100)
        QVERIFY(run->mask.has(i, MaskReason::Outlier));
    QVERIFY(run->mask.count(MaskReason::Outlier) < 125);
}

void TestQualityRows::constantNoise_hasNoOutliers()
{
    Recording recording = restingRecording();
    recording.rateDps.col(0).setZero();
    recording.rateDps(6000, 0) = 0.01;
    recording.rateDps.col(1).setZero();
    recording.rateDps.col(2).setZero();
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    QCOMPARE(run->mask.count(MaskReason::Outlier), 0);
    QVERIFY(contains(messages(*run, "rate stuck"), "The rate of y is 0.000 dps in every sample"));
}

void TestQualityRows::tooLittle_isRefused_data()
{
    QTest::addColumn<double>("durationS");
    QTest::addColumn<double>("rampCPerS");
    QTest::addColumn<int>("code");
    QTest::newRow("no row") << 0.0 << 0.05 << static_cast<int>(Errc::TooFewSamples);
    QTest::newRow("one row") << 0.15 << 0.05 << static_cast<int>(Errc::TooFewSamples);
    QTest::newRow("59 s") << 59.0 << 1.0 << static_cast<int>(Errc::TooShort);
    QTest::newRow("constant") << 600.0 << 0.0005 << static_cast<int>(Errc::ConstantTemperature);
    QTest::newRow("9 degrees") << 600.0 << 0.015 << static_cast<int>(Errc::SpanTooSmall);
}

void TestQualityRows::tooLittle_isRefused()
{
    QFETCH(const double, durationS);
    QFETCH(const double, rampCPerS);
    QFETCH(const int, code);
    RestingGyro gyro;
    gyro.durationS = durationS;
    gyro.rampCPerS = rampCPerS;
    const auto run = prepareRun(restingRecording(gyro));
    QVERIFY(!run);
    QCOMPARE(static_cast<int>(run.error().code), code);
}

void TestQualityRows::smallSpan_override_isAWarning()
{
    RestingGyro gyro;
    gyro.rampCPerS = 0.005;
    QualityOptions options;
    options.allowSmallSpan = true;
    const auto small = prepareRun(restingRecording(gyro), options);
    QVERIFY(small);
    QVERIFY(contains(messages(*small, "small span"), "only 6.0 °C (0.0 to 6.0 °C)"));
    gyro.rampCPerS = 0.015;
    const auto advised = prepareRun(restingRecording(gyro));
    QVERIFY(advised);
    QVERIFY(contains(messages(*advised, "small span"), "25 °C are advised"));
}

void TestQualityRows::everythingExcluded_isRefused()
{
    QualityOptions options;
    options.excluded = {{-1.0, 1e6}};
    const CheckedRun checked = checkRun(restingRecording(), options);
    QVERIFY(checked.refusal);
    QCOMPARE(checked.refusal->code, Errc::NothingUsable);
    QCOMPARE(summarise(checked.run).usableForJudging, 0);
}

void TestQualityRows::summarise_knownRun_givesItsFigures()
{
    RestingGyro gyro;
    gyro.driftDpsPerC = 0.0;
    gyro.referenceRateDps = {25.0, 0.0, 0.0};
    Recording recording = restingRecording(gyro);
    // Up at 3 degrees a minute for the first half, down again for the second.
    for (Eigen::Index i = 6000; i < 12000; ++i)
        recording.temperatureC[i] = recording.temperatureC[11999 - i];
    const auto run = prepareRun(std::move(recording));
    QVERIFY(run);
    const RunReport report = summarise(*run);
    QVERIFY(std::abs(report.sampleRateHz - 10.0) < 1e-9);
    QVERIFY(std::abs(report.durationS - 1199.9) < 1e-9);
    QVERIFY(std::abs(report.largestHeatingCPerMin - 3.0) < 1e-6);
    QVERIFY(std::abs(report.largestCoolingCPerMin - 3.0) < 1e-6);
    QCOMPARE(report.coverage.size(), std::size_t{30});
    QCOMPARE(report.coverage[10].centreC, 10.5);
    QVERIFY(std::abs(report.coverage[10].heatingS - 20.0) < 0.11);
    QVERIFY(std::abs(report.coverage[10].coolingS - 20.0) < 0.11);
    QVERIFY(report.heatedAndCooledPart > 0.95);
    QVERIFY(std::abs(report.axes[0].meanDps - 25.0) < 0.01);
    for (const AxisReport &axis : report.axes) {
        QVERIFY(std::abs(axis.noiseWithinCellDps / gyro.noiseDps - 1.0) < 0.03);
        QVERIFY(std::abs(axis.noiseDifferencesDps / gyro.noiseDps - 1.0) < 0.05);
    }
}

QTEST_APPLESS_MAIN(TestQualityRows)
#include "tst_quality_rows.moc"
