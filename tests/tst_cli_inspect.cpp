#include "support/cli_process.h"
#include "support/test_data.h"

#include <QFile>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

using namespace driftbench::test;

class TestCliInspect : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();

    void inspect_simulatedRun_saysWhatIsInIt();
    void inspect_json_isTheSameAndNothingElse();
    void inspect_faults_areFoundAndCounted();
    void inspect_excludedStretch_isMasked();
    void inspect_namedColumnsAndUnits_readTheSameRun();
    void inspect_sensorStated_isTheSensor();

    void inspect_dataflash_listsItsGyros();
    void inspect_dataflashInstance_masksMotionAndRefusesTheSpan();
    void inspect_publishedTsv_needsNoOptionsForItsColumns();
    void inspect_sampleLogs_areRead_data();
    void inspect_sampleLogs_areRead();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
};

static nlohmann::json inspectJson(const QStringList &arguments)
{
    const Outcome outcome = runCli(QStringList{"inspect", "--json"} + arguments);
    if (outcome.exitCode != 0 || !outcome.errors.isEmpty())
        qFatal("inspect failed: %s", outcome.errors.constData());
    return nlohmann::json::parse(outcome.output.toStdString());
}

void TestCliInspect::initTestCase()
{
    QVERIFY(m_folder.isValid());
    simulateQuietly(m_folder.path(), {"--runs", "1"});
}

void TestCliInspect::inspect_simulatedRun_saysWhatIsInIt()
{
    const Outcome outcome = runCli({"inspect", path("run1.csv")});
    QCOMPARE(outcome.exitCode, 0);
    QCOMPARE(outcome.errors, QByteArray());
    for (const char *part : {"I3G4250D SIM-0001, simulated data", "samples      3700", "10.00 Hz",
                             "verdict      can be calibrated\n"})
        QVERIFY2(outcome.output.contains(part), part);
}

void TestCliInspect::inspect_json_isTheSameAndNothingElse()
{
    const auto json = inspectJson({path("run1.csv")});
    QCOMPARE(json["format"].get<std::string>(), std::string("csv"));
    QCOMPARE(json["sensor"]["serial"].get<std::string>(), std::string("SIM-0001"));
    QCOMPARE(json["simulated"].get<bool>(), true);
    QCOMPARE(json["samples"].get<int>(), 3700);
    QCOMPARE(json["instances"].size(), std::size_t{1});
    QCOMPARE(json["can_be_calibrated"].get<bool>(), true);
    QVERIFY(json["lowest_temperature_C"].get<double>() < -39.9);
    QVERIFY(json["highest_temperature_C"].get<double>() > 84.0);
    // The white noise that the simulator is told by default.
    for (const auto &axis : json["axes"])
        QVERIFY(std::abs(axis["noise_differences_dps"].get<double>() / 0.14 - 1.0) < 0.1);
}

void TestCliInspect::inspect_faults_areFoundAndCounted()
{
    const QString folder = path("faults");
    simulateQuietly(folder, {"--runs", "1", "--nan", "0.01"});
    const auto refused = inspectJson({folder + "/run1.csv"});
    QCOMPARE(refused["can_be_calibrated"].get<bool>(), false);
    const auto masked = inspectJson({folder + "/run1.csv", "--mask-bad-rows"});
    QCOMPARE(masked["can_be_calibrated"].get<bool>(), true);
    const int usable = masked["usable"].get<int>();
    // A binomial count: 37 +- 6.
    QVERIFY(usable > 3700 - 37 - 40 && usable < 3700 - 37 + 30);
}

void TestCliInspect::inspect_excludedStretch_isMasked()
{
    const auto json = inspectJson({path("run1.csv"), "--exclude", "100:109.95", "--exclude", "200:204.95"});
    QCOMPARE(json["usable"].get<int>(), 3700 - 100 - 50);
}

void TestCliInspect::inspect_namedColumnsAndUnits_readTheSameRun()
{
    // The same run as milliseconds, kelvin and counts of 10 mdps, in another order, without names.
    QList<QByteArray> lines = bytesOf(path("run1.csv")).split('\n');
    QByteArray text;
    for (int i = 1; i + 1 < lines.size(); ++i) {
        const QList<QByteArray> row = lines[i].split(',');
        for (const int rate : {4, 3, 2})
            text += QByteArray::number(row[rate].toDouble() * 100.0, 'g', 15) + ';';
        text += QByteArray::number(row[1].toDouble() + 273.15, 'g', 15) + ';' +
                QByteArray::number(row[0].toDouble() * 1000.0, 'g', 15) + '\n';
    }
    writeBytes(path("counts.txt"), text);
    const auto json =
        inspectJson({path("counts.txt"), "--columns", "5,4,3,2,1", "--time-unit", "ms", "--temperature-unit",
                     "K", "--rate-unit", "counts", "--sensitivity", "10"});
    const auto expected = inspectJson({path("run1.csv")});
    QVERIFY(json["samples"] == expected["samples"]);
    QVERIFY(std::abs(json["duration_s"].get<double>() - expected["duration_s"].get<double>()) < 1e-9);
    for (const char *key : {"lowest_temperature_C", "highest_temperature_C"})
        QVERIFY(std::abs(json[key].get<double>() - expected[key].get<double>()) < 1e-9);
    for (std::size_t axis = 0; axis < 3; ++axis)
        QVERIFY(std::abs(json["axes"][axis]["mean_dps"].get<double>() -
                         expected["axes"][axis]["mean_dps"].get<double>()) < 1e-9);
}

void TestCliInspect::inspect_sensorStated_isTheSensor()
{
    writeBytes(path("bare.csv"), bytesOf(path("run1.csv")));
    QCOMPARE(inspectJson({path("bare.csv")})["sensor"]["model"].get<std::string>(), std::string());
    const auto json = inspectJson({path("bare.csv"), "--sensor", "L3GD20H:0042"});
    QCOMPARE(json["sensor"]["model"].get<std::string>(), std::string("L3GD20H"));
    QCOMPARE(json["sensor"]["serial"].get<std::string>(), std::string("0042"));
}

void TestCliInspect::inspect_dataflash_listsItsGyros()
{
    REQUIRE_SHARED_DATA(log, "dataflash_warmup/log171.bin");
    const QString file = QString::fromStdString(log.string());
    const Outcome outcome = runCli({"inspect", file});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(outcome.output.contains("holds 3 gyros") && outcome.output.contains("2  IMU3  11916 samples"));
    QVERIFY(outcome.output.endsWith("Choose one with --instance N.\n"));
    const auto json = inspectJson({file});
    QCOMPARE(json["instances"].size(), std::size_t{3});
    QVERIFY(std::abs(json["instances"][2]["highest_temperature_C"].get<double>() - 42.0) < 0.1);
}

void TestCliInspect::inspect_dataflashInstance_masksMotionAndRefusesTheSpan()
{
    REQUIRE_SHARED_DATA(log, "dataflash_warmup/log171.bin");
    const auto json = inspectJson({QString::fromStdString(log.string()), "--instance", "2"});
    QCOMPARE(json["can_be_calibrated"].get<bool>(), false);
    QVERIFY(json["masked"]["motion"].get<int>() > json["samples"].get<int>() / 2);
    const auto refusal = std::find_if(json["findings"].begin(), json["findings"].end(),
                                      [](const auto &finding) { return finding["severity"] == "refusal"; });
    QVERIFY(refusal != json["findings"].end());
    QVERIFY((*refusal)["message"].get<std::string>().find("at least 10 °C") != std::string::npos);
    QCOMPARE(runCli({"inspect", QString::fromStdString(log.string()), "--instance", "5"}).exitCode, 17);
}

void TestCliInspect::inspect_publishedTsv_needsNoOptionsForItsColumns()
{
    REQUIRE_SHARED_DATA(log, "climate_chamber/raw_as_published.tsv");
    const QString file = QString::fromStdString(log.string());
    const auto guessed = inspectJson({file});
    const auto stated =
        inspectJson({file, "--rate-unit", "rad/s", "--time-unit", "us", "--separator", "tab"});
    QCOMPARE(guessed["samples"].get<int>(), 8400);
    QVERIFY(stated["instances"][0]["duration_s"] == guessed["instances"][0]["duration_s"]);
    QVERIFY(std::abs(stated["duration_s"].get<double>() / 60.0 - 70.7) < 0.1);
    // The log calls rad/s deg/s; only the noise gives that away.
    QCOMPARE(guessed["warnings"].size(), std::size_t{2});
    QVERIFY(guessed["warnings"][1].get<std::string>().find("rad/s") != std::string::npos);
    QVERIFY(stated["warnings"].empty());
    const double ratio =
        stated["axes"][1]["highest_dps"].get<double>() / guessed["axes"][1]["highest_dps"].get<double>();
    QVERIFY(std::abs(ratio - 57.29577951308232) < 1e-6);
}

void TestCliInspect::inspect_sampleLogs_areRead_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("gyros");
    QTest::addColumn<QString>("format");
    QTest::newRow("ulog") << "formats/pyulog_sample_log_small.ulg" << 4 << "ulog";
    QTest::newRow("dataflash") << "formats/pymavlink_test.BIN" << 2 << "dataflash";
}

void TestCliInspect::inspect_sampleLogs_areRead()
{
    QFETCH(const QString, file);
    QFETCH(const int, gyros);
    QFETCH(const QString, format);
    REQUIRE_SHARED_DATA(log, file.toUtf8().constData());
    const QString name = QString::fromStdString(log.string());
    QCOMPARE(static_cast<int>(inspectJson({name})["instances"].size()), gyros);
    for (int instance = 0; instance < gyros; ++instance) {
        const auto json = inspectJson({name, "--instance", QString::number(instance)});
        QCOMPARE(json["format"].get<std::string>(), format.toStdString());
        QVERIFY(json["samples"].get<int>() > 0);
        QVERIFY(json["lowest_temperature_C"].get<double>() > 0.0);
    }
}

QTEST_GUILESS_MAIN(TestCliInspect)
#include "tst_cli_inspect.moc"
