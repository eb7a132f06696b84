#include "engine/physics/plan_file.h"
#include "support/cli_process.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

using namespace driftbench;
using namespace driftbench::test;

class TestCliPlan : public QObject
{
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void plan_default_printsThePapersFigures();
    void plan_json_holdsEveryFigureInFull();
    void plan_overrides_reachThePlanFile();
    void plan_files_areThoseOfTheEngine();
    void plan_badValue_saysItInOneSentence_data();
    void plan_badValue_saysItInOneSentence();
    void plan_damagedFile_isRefused();
    void lag_ofASimulatedRun_isThatOfTheSimulator();
    void lag_fromAColumn_needsNoRates();
    void lag_constantSetpoint_isRefused();

private:
    QString path(const char *name) const { return m_folder->filePath(name); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCliPlan::plan_default_printsThePapersFigures()
{
    const Outcome outcome = runCli({"plan"});
    QCOMPARE(outcome.exitCode, 0);
    QCOMPARE(outcome.errors, QByteArray());
    for (const char *figure : {"0.55249 °C", "10.938", "25.766 s", "25766 s", "6115.1 s", "592 s", "3:05 h",
                               "555000 samples", "8.75/(4.9 + 10.9375)"})
        QVERIFY2(outcome.output.contains(figure), figure);
}

void TestCliPlan::plan_json_holdsEveryFigureInFull()
{
    const Outcome outcome = runCli({"plan", "--json"});
    QCOMPARE(outcome.exitCode, 0);
    const auto json = nlohmann::json::parse(outcome.output.toStdString());
    const auto value = [&json](const char *group, std::size_t index) {
        return json.at(group).at(index).at("value").get<double>();
    };
    QVERIFY(std::abs(value("control_interval", 3) - 10.9375) < 1e-12);
    QVERIFY(std::abs(value("control_interval", 5) - 0.5525) < 5e-5);
    QVERIFY(std::abs(value("control_period", 0) - 25.766) < 5e-4);
    QVERIFY(std::abs(value("control_period", 1) - 25766.0) < 0.5);
    QVERIFY(std::abs(value("control_period", 2) - 6115.0) < 0.5);
    QVERIFY(std::abs(json.at("still_air").at("slowest_mode_s").get<double>() - 592.0) < 0.5);
    QCOMPARE(json.at("samples_per_run").get<int>(), 111000);
    QCOMPARE(json.at("segments").size(), std::size_t{3});
}

void TestCliPlan::plan_overrides_reachThePlanFile()
{
    const Outcome outcome = runCli({"plan",
                                    "--sensor",
                                    "i3g4250d",
                                    "--low",
                                    "-20",
                                    "--high",
                                    "60",
                                    "--step",
                                    "0.25",
                                    "--period",
                                    "45",
                                    "--hold",
                                    "600",
                                    "--rate",
                                    "50",
                                    "--runs",
                                    "3",
                                    "--kind",
                                    "cycle",
                                    "--cycles",
                                    "2",
                                    "--edge",
                                    "0.4",
                                    "--specific-heat",
                                    "1010",
                                    "--density",
                                    "1.2",
                                    "--conductivity",
                                    "0.03",
                                    "--accuracy",
                                    "0.1",
                                    "--sensitivity",
                                    "17.5",
                                    "--range",
                                    "500",
                                    "--zero-rate",
                                    "20",
                                    "--zero-rate-range",
                                    "1000",
                                    "--sensitivity-change",
                                    "3",
                                    "--out",
                                    path("plan.json")});
    QCOMPARE(outcome.errors, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    const auto plan = readPlan(path("plan.json").toStdString());
    QVERIFY(plan.ok());
    QCOMPARE(plan->sensor.model, std::string("I3G4250D"));
    QVERIFY(plan->lowestC == -20.0 && plan->highestC == 60.0 && plan->stepC == 0.25);
    QVERIFY(plan->periodS == 45.0 && plan->holdS == 600.0 && plan->sampleRateHz == 50.0);
    QVERIFY(plan->runs == 3 && plan->cycles == 2 && plan->kind == PlanKind::Cycle);
    QVERIFY(plan->chamber.edgeM == 0.4 && plan->chamber.specificHeatJPerKgK == 1010.0);
    QVERIFY(plan->chamber.densityKgPerM3 == 1.2 && plan->chamber.conductivityWPerMK == 0.03);
    QVERIFY(plan->chamber.thermometerAccuracyC == 0.1 && plan->sensor.sensitivityMdps == 17.5);
    QVERIFY(plan->sensor.rangeDps == 500.0 && plan->sensor.zeroRateChangeMdpsPerC == 20.0);
    QVERIFY(plan->sensor.zeroRateChangeRangeDps == 1000.0 && plan->sensor.sensitivityChangePercent == 3.0);
    QCOMPARE(runCli({"plan", "--plan", path("plan.json")}).output, outcome.output);
    // Nothing that is asked for goes under.
    QCOMPARE(runCli({"plan", "--plan", path("plan.json"), "--step", "1"}).exitCode, 2);
}

void TestCliPlan::plan_files_areThoseOfTheEngine()
{
    const Outcome outcome = runCli({"plan", "--kind", "cooling", "--out", path("plan.json"), "--csv",
                                    path("steps.csv"), "--segments", path("segments.csv")});
    QCOMPARE(outcome.exitCode, 0);
    const auto plan = readPlan(path("plan.json").toStdString());
    QVERIFY(plan.ok());
    QCOMPARE(bytesOf(path("steps.csv")).toStdString(), planStepsToCsv(*plan));
    QCOMPARE(bytesOf(path("segments.csv")).toStdString(), planSegmentsToCsv(*plan));
    QCOMPARE(filesIn(m_folder->path()).size(), 3);
}

void TestCliPlan::plan_badValue_saysItInOneSentence_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("ramp rate 0") << QStringList{"--step", "0"};
    QTest::newRow("period 0") << QStringList{"--period", "0"};
    QTest::newRow("below absolute zero") << QStringList{"--low", "-300"};
    QTest::newRow("conductivity 0") << QStringList{"--conductivity", "0"};
    QTest::newRow("negative length") << QStringList{"--edge", "-0.6"};
    QTest::newRow("empty range") << QStringList{"--low", "20", "--high", "20"};
    QTest::newRow("endless") << QStringList{"--step", "1e-6"};
    QTest::newRow("no runs") << QStringList{"--runs", "0"};
    QTest::newRow("unknown gyro") << QStringList{"--sensor", "MPU"};
    QTest::newRow("unknown chamber") << QStringList{"--chamber", "oven"};
}

void TestCliPlan::plan_badValue_saysItInOneSentence()
{
    QFETCH(QStringList, arguments);
    const Outcome outcome = runCli(QStringList{"plan", "--out", path("plan.json")} + arguments);
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::InvalidOption));
    QCOMPARE(outcome.output, QByteArray());
    QVERIFY2(isOneSentence(outcome.errors), outcome.errors);
    QVERIFY(filesIn(m_folder->path()).isEmpty());
}

void TestCliPlan::plan_damagedFile_isRefused()
{
    writeBytes(path("plan.json"), "{\"format\": ");
    const Outcome outcome = runCli({"plan", "--plan", path("plan.json")});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::PlanDamaged));
    QVERIFY2(isOneSentence(outcome.errors), outcome.errors);
}

void TestCliPlan::lag_ofASimulatedRun_isThatOfTheSimulator()
{
    QCOMPARE(
        runCli({"simulate", "--out", path("campaign"), "--runs", "1", "--chamber-lag", "45", "--rate", "2"})
            .exitCode,
        0);
    const Outcome outcome = runCli({"plan", "--lag-from", path("campaign/run1.csv"), "--json"});
    QCOMPARE(outcome.errors, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    const auto json = nlohmann::json::parse(outcome.output.toStdString());
    // The simulator answers a step at the sample that falls on it: early by up to one interval.
    QVERIFY(std::abs(json.at("time_constant_s").get<double>() - 45.0) < 0.5);
    QVERIFY(std::abs(json.at("dead_time_s").get<double>()) < 0.7);
    QVERIFY(json.at("residual_rms_C").get<double>() < 0.02);
}

void TestCliPlan::lag_fromAColumn_needsNoRates()
{
    QByteArray csv = "time_s,setpoint_C,actual_C\n";
    for (int i = 0; i < 3000; ++i) {
        const double setpointC = i < 500 ? 20.0 : 30.0;
        const double ageS = i - 500.0 - 25.0;
        const double actualC = 20.0 + (ageS > 0.0 ? -10.0 * std::expm1(-ageS / 120.0) : 0.0);
        csv += QByteArray::number(i) + "," + QByteArray::number(setpointC) + "," +
               QByteArray::number(actualC, 'g', 12) + "\n";
    }
    writeBytes(path("chamber.csv"), csv);
    const QStringList columns{"--setpoint-column", "setpoint_C", "--temperature-column", "actual_C"};
    const Outcome outcome =
        runCli(QStringList{"plan", "--lag-from", path("chamber.csv"), "--json"} + columns);
    QCOMPARE(outcome.errors, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    const auto json = nlohmann::json::parse(outcome.output.toStdString());
    QVERIFY(std::abs(json.at("dead_time_s").get<double>() - 25.0) < 1e-3);
    QVERIFY(std::abs(json.at("time_constant_s").get<double>() - 120.0) < 1e-3);
    const Outcome text = runCli(QStringList{"plan", "--lag-from", path("chamber.csv")} + columns);
    QVERIFY(text.output.contains("120.00 ± 0.00 s"));
}

void TestCliPlan::lag_constantSetpoint_isRefused()
{
    QByteArray csv = "time_s,setpoint_C,temperature_C\n";
    for (int i = 0; i < 100; ++i)
        csv += QByteArray::number(i) + ",20,20\n";
    writeBytes(path("chamber.csv"), csv);
    const Outcome outcome = runCli({"plan", "--lag-from", path("chamber.csv"), "--setpoint-column",
                                    "setpoint_C", "--temperature-column", "temperature_C"});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::ConstantTemperature));
    QVERIFY2(isOneSentence(outcome.errors), outcome.errors);
}

QTEST_APPLESS_MAIN(TestCliPlan)
#include "tst_cli_plan.moc"
