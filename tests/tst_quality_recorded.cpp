// What the checks say about real logs.
#include "engine/formats/log_reader.h"
#include "engine/recording/quality.h"
#include "engine/recording/run_report.h"
#include "support/test_data.h"

#include <algorithm>

using namespace driftbench;
using namespace driftbench::test;

class TestQualityRecorded : public QObject
{
    Q_OBJECT

private slots:
    void chamber_keepsAllButTheFirstRow_data();
    void chamber_keepsAllButTheFirstRow();
    void chamber_biasStepsOfX_areReported();
    void warmUp_isRefusedForItsSpanAndNotMasked();
    void noDriftControl_saysSo();
};

static bool hasFinding(const Run &run, const std::string &kind)
{
    return std::any_of(run.findings.begin(), run.findings.end(),
                       [&](const Finding &finding) { return finding.kind == kind; });
}

void TestQualityRecorded::chamber_keepsAllButTheFirstRow_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("masked");
    QTest::newRow("cooling") << "climate_chamber/run1_cooling.csv" << 1;
    QTest::newRow("heating") << "climate_chamber/run2_heating.csv" << 0;
    QTest::newRow("cooling again") << "climate_chamber/run3_cooling.csv" << 0;
    QTest::newRow("all in one") << "climate_chamber/chamber_all.csv" << 1;
}

void TestQualityRecorded::chamber_keepsAllButTheFirstRow()
{
    QFETCH(const QString, file);
    QFETCH(const int, masked);
    REQUIRE_SHARED_DATA(path, file.toUtf8().constData());
    const CheckedRun checked = checkRun(readLog(path, {}).value());
    QVERIFY(!checked.refusal);
    const Eigen::Index size = checked.run.recording->size();
    QCOMPARE(size - checked.run.mask.countUsableForJudging(), masked);
    QCOMPARE(checked.run.mask.has(0, MaskReason::StartUp), masked == 1);
    QVERIFY(checked.run.mask.count(MaskReason::Outlier) < size / 100);
}

void TestQualityRecorded::chamber_biasStepsOfX_areReported()
{
    REQUIRE_SHARED_DATA(path, "climate_chamber/chamber_all.csv");
    const CheckedRun checked = checkRun(readLog(path, {}).value());
    const auto steps =
        std::find_if(checked.run.findings.begin(), checked.run.findings.end(), [](const Finding &finding) {
            return finding.kind == "bias step" && finding.message.find("bias of x") != std::string::npos;
        });
    QVERIFY(steps != checked.run.findings.end());
    QVERIFY(steps->startS > 400.0 && steps->startS < 1050.0);
}

void TestQualityRecorded::warmUp_isRefusedForItsSpanAndNotMasked()
{
    REQUIRE_SHARED_DATA(path, "dataflash_warmup/log171_IMU3_stationary_17s6-59s.csv");
    QualityOptions options;
    const auto refused = prepareRun(readLog(path, {}).value(), options);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, Errc::SpanTooSmall);
    QVERIFY(refused.error().message.find("4.4 °C") != std::string::npos);
    options.allowSmallSpan = true;
    options.allowShort = true;
    const auto run = prepareRun(readLog(path, {}).value(), options);
    QVERIFY(run);
    QCOMPARE(run->mask.countUsableForJudging(), run->recording->size());
    QVERIFY(hasFinding(*run, "small span") && hasFinding(*run, "short"));
}

void TestQualityRecorded::noDriftControl_saysSo()
{
    REQUIRE_SHARED_DATA(path, "no_drift_control/astropi_2015_sensehat.csv");
    QualityOptions options;
    options.allowSmallSpan = true;
    const auto run = prepareRun(readLog(path, {}).value(), options);
    QVERIFY(run);
    QVERIFY(hasFinding(*run, "no drift"));
    QVERIFY(hasFinding(*run, "gap"));
    const RunReport report = summarise(*run);
    QCOMPARE(report.samples, 24604);
    QVERIFY(std::abs(report.sampleRateHz - 0.1) < 1e-9);
    QVERIFY(std::abs(report.lowestTemperatureC - 24.66) < 1e-9);
}

QTEST_APPLESS_MAIN(TestQualityRecorded)
#include "tst_quality_recorded.moc"
