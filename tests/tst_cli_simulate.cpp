#include "engine/base/text.h"
#include "engine/physics/gyro_simulator.h"
#include "engine/physics/plan_file.h"
#include "engine/physics/sensor_presets.h"
#include "support/cli_process.h"
#include "support/test_data.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include <csignal>
#include <memory>

using namespace driftbench;
using namespace driftbench::test;

class TestCliSimulate : public QObject
{
    Q_OBJECT

private slots:
    void init();

    void simulate_defaultCampaign_writesWhatTheEngineSimulates();
    void simulate_everyOption_reachesTheEngine();
    void simulate_sensor_bringsItsFigures();
    void simulate_plan_isFollowed();
    void simulate_truth_isTheCurvesOfTheRuns();
    void simulate_sidecar_namesSensorAndReference();
    void simulate_sameSeed_isTheSameBytes();
    void simulate_json_listsTheFiles();
    void simulate_fewerRunsThanBefore_pointsOutTheOlderOne();
    void simulate_badOption_saysItInOneSentence_data();
    void simulate_badOption_saysItInOneSentence();
    void simulate_folderBelowAFile_isRefused();
    void simulate_fullDisk_leavesTheFolderAsItWas();
    void simulate_fullStandardOutput_isAnError();
    void simulate_interrupted_leavesNothing_data();
    void simulate_interrupted_leavesNothing();
    void help_everyCommand_fitsATerminalAndHasAnExample();
    void help_main_listsEveryExitCode();

private:
    QString out() const { return m_folder->filePath("campaign"); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {

// Whether the file holds the header and exactly the recording, to the last bit.
bool holds(const QByteArray &csv, const Recording &recording)
{
    const QList<QByteArray> lines = csv.split('\n');
    if (lines.size() != recording.size() + 2 || !lines.back().isEmpty())
        return false;
    if (lines.front() != "time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps")
        return false;
    const auto same = [](const QByteArray &text, double value) {
        const auto number = parseNumber(text.toStdString());
        return number && (*number == value || (std::isnan(*number) && std::isnan(value)));
    };
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        const QList<QByteArray> fields = lines[i + 1].split(',');
        if (fields.size() != 5 || !same(fields[0], recording.timeS[i]) ||
            !same(fields[1], recording.temperatureC[i]))
            return false;
        for (int axis = 0; axis < kAxisCount; ++axis) {
            if (!same(fields[axis + 2], recording.rateDps(i, axis)))
                return false;
        }
    }
    return true;
}

// The preset of the first sensor on another profile and with another curve.
SimulationOptions engineOptions(std::string_view profile, std::string_view truth)
{
    SimulationOptions options = *presetSimulation("I3G4250D", Eigen::Vector3d::Zero());
    options.profile = *TemperatureProfile::named(profile);
    if (truth != kCombDriftName)
        options.truth = *namedDriftCurves(truth);
    return options;
}

} // namespace

void TestCliSimulate::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
}

void TestCliSimulate::simulate_defaultCampaign_writesWhatTheEngineSimulates()
{
    const Outcome outcome = runCli({"simulate", "--out", out()});
    QCOMPARE(outcome.errors, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    QCOMPARE(filesIn(out()), QStringList({"run1.csv", "run1.csv.meta.json", "run2.csv", "run2.csv.meta.json",
                                          "run3.csv", "run3.csv.meta.json", "run4.csv", "run4.csv.meta.json",
                                          "run5.csv", "run5.csv.meta.json", "truth.json"}));
    for (const int number : {0, 4})
        QVERIFY(holds(bytesOf(out() + "/run" + QString::number(number + 1) + ".csv"),
                      *simulateRun(engineOptions("paper", "comb"), number)));
}

void TestCliSimulate::simulate_everyOption_reachesTheEngine()
{
    const QStringList campaign{"simulate", "--out", out(), "--runs", "2", "--seed", "77"};
    const QStringList chamber{"--profile", "quick",    "--chamber-lag",       "4",   "--chamber-dead-time",
                              "2.5",       "--stairs", "--thermometer-noise", "0.02"};
    const QStringList drift{"--truth",           "steep",      "--spread", "0.01", "--turn-on",    "0.3",
                            "--reference-rate",  "-25,5,53.5", "--lag",    "3",    "--hysteresis", "0.1",
                            "--hysteresis-play", "2"};
    const QStringList output{
        "--rate",        "20",   "--noise", "0.2", "--bias-instability", "0.01", "--random-walk", "0.001",
        "--sensitivity", "17.5", "--range", "500"};
    const QStringList faults{"--steps", "2", "--step-size", "0.7",  "--motion", "3",
                             "--gaps",  "1", "--outliers",  "0.01", "--nan",    "0.02"};
    const Outcome outcome = runCli(campaign + chamber + drift + output + faults);
    QCOMPARE(outcome.errors, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    SimulationOptions options = engineOptions("quick", "steep");
    options.seed = 77;
    options.chamber.lagS = 4.0;
    options.chamber.deadTimeS = 2.5;
    options.chamber.thermometerNoiseC = 0.02;
    options.chamber.thermometerCountsPerC = 1.0;
    options.gyro.biasInstabilityDps = 0.01;
    options.gyro.rateRandomWalkDpsPerRootS = 0.001;
    options.gyro.hysteresisPlayC = 2.0;
    options.gyro.sensitivityMdps = 17.5;
    options.gyro.rangeDps = 500.0;
    options.faults.biasStepDps = 0.7;
    options.gyro.sampleRateHz = 20.0;
    options.gyro.referenceRateDps = {-25.0, 5.0, 53.5};
    options.gyro.noiseDps = 0.2;
    options.gyro.spread = 0.01;
    options.gyro.turnOnBiasDps = 0.3;
    options.gyro.packageLagS = 3.0;
    options.gyro.hysteresisDps = 0.1;
    options.faults.biasSteps = 2;
    options.faults.motionBursts = 3;
    options.faults.gaps = 1;
    options.faults.outlierFraction = 0.01;
    options.faults.nonFiniteFraction = 0.02;
    QVERIFY(holds(bytesOf(out() + "/run2.csv"), *simulateRun(options, 1)));
}

void TestCliSimulate::simulate_sensor_bringsItsFigures()
{
    const Outcome outcome = runCli({"simulate", "--out", out(), "--runs", "1", "--sensor", "l3gd20h",
                                    "--range", "2000", "--reference-rate", "500,5,-53"});
    QCOMPARE(outcome.errors, QByteArray());
    SimulationOptions options = *presetSimulation("L3GD20H", Eigen::Vector3d::Zero());
    options.gyro.rangeDps = 2000.0;
    options.gyro.referenceRateDps = {500.0, 5.0, -53.0};
    options.truth = *combDriftCurves(*options.combs, options.gyro.referenceRateDps);
    QVERIFY(holds(bytesOf(out() + "/run1.csv"), *simulateRun(options, 0)));
    const auto truth = nlohmann::json::parse(bytesOf(out() + "/truth.json").toStdString());
    QCOMPARE(truth["combs"]["y"]["rest_dps"].get<double>(), options.combs->axes[1].restDps);
    QCOMPARE(truth["options"]["bias_instability_dps"].get<double>(), options.gyro.biasInstabilityDps);
}

void TestCliSimulate::simulate_plan_isFollowed()
{
    TestPlan plan = *makeTestPlan(*namedSensor("L3GD20H"), *namedChamber("SET-Z-021"));
    plan.lowestC = 20.0;
    plan.highestC = 40.0;
    plan.holdS = 60.0;
    plan.runs = 2;
    plan.sampleRateHz = 5.0;
    const QString path = m_folder->filePath("plan.json");
    QVERIFY(writePlan(plan, path.toStdString()).ok());
    const Outcome outcome = runCli({"simulate", "--out", out(), "--plan", path});
    QCOMPARE(outcome.errors, QByteArray());
    QCOMPARE(filesIn(out()).size(), 5);
    SimulationOptions options = *presetSimulation("L3GD20H", Eigen::Vector3d::Zero());
    options.profile = *plan.profile();
    options.gyro.sampleRateHz = 5.0;
    QVERIFY(holds(bytesOf(out() + "/run2.csv"), *simulateRun(options, 1)));
    QCOMPARE(runCli({"simulate", "--out", out(), "--plan", path, "--profile", "quick"}).exitCode, 2);
    QCOMPARE(runCli({"simulate", "--out", out(), "--plan", path + "x"}).exitCode,
             static_cast<int>(Errc::FileNotFound));
}

void TestCliSimulate::simulate_truth_isTheCurvesOfTheRuns()
{
    QCOMPARE(runCli({"simulate", "--out", out(), "--runs", "2", "--profile", "quick", "--seed", "5",
                     "--steps", "2", "--motion", "1", "--gaps", "3"})
                 .exitCode,
             0);
    const auto truth = nlohmann::json::parse(bytesOf(out() + "/truth.json").toStdString());
    SimulationOptions options = engineOptions("quick", "comb");
    options.seed = 5;
    QCOMPARE(truth["seed"].get<int>(), 5);
    QCOMPARE(truth["simulated"].get<bool>(), true);
    QCOMPARE(truth["options"]["spread"].get<double>(), options.gyro.spread);
    const auto &temperaturesC = truth["temperature_C"];
    QCOMPARE(temperaturesC.size(), std::size_t{1251});
    QCOMPARE(temperaturesC.front().get<double>(), -40.0);
    QCOMPARE(temperaturesC[1].get<double>(), -39.9);
    QCOMPARE(temperaturesC.back().get<double>(), 85.0);
    const auto isCurve = [&](const nlohmann::json &curve, const DriftTable &table) {
        for (std::size_t i = 0; i < temperaturesC.size(); ++i) {
            const Eigen::Vector3d rateDps = table.rateDps(temperaturesC[i].get<double>());
            if (curve["x"][i] != rateDps[0] || curve["y"][i] != rateDps[1] || curve["z"][i] != rateDps[2])
                return false;
        }
        return curve["x"].size() == temperaturesC.size();
    };
    QVERIFY(isCurve(truth["curve_dps"], campaignTruth(options)));
    QCOMPARE(truth["runs"].size(), std::size_t{2});
    QVERIFY(isCurve(truth["runs"][1]["curve_dps"], GyroSimulator::create(options, 1)->truth()));
    QCOMPARE(truth["runs"][0]["file"].get<std::string>(), std::string("run1.csv"));
    QCOMPARE(truth["runs"][0]["bias_steps"].size(), std::size_t{2});
    QCOMPARE(truth["runs"][0]["motion"].size(), std::size_t{1});
    QCOMPARE(truth["runs"][0]["gaps"].size(), std::size_t{3});
}

void TestCliSimulate::simulate_sidecar_namesSensorAndReference()
{
    QCOMPARE(runCli({"simulate", "--out", out(), "--runs", "1", "--profile", "quick", "--sensor", "L3GD20H",
                     "--serial", "A \"7\"", "--reference-rate=-1,2,3.5"})
                 .exitCode,
             0);
    const auto meta = nlohmann::json::parse(bytesOf(out() + "/run1.csv.meta.json").toStdString());
    const auto expected = nlohmann::json::parse(
        R"({"sensor": {"model": "L3GD20H", "serial": "A \"7\""}, "simulated": true, "reference_rate_dps": [-1, 2, 3.5]})");
    QVERIFY(meta == expected);
}

void TestCliSimulate::simulate_sameSeed_isTheSameBytes()
{
    const QStringList common{"--runs", "2", "--profile", "quick", "--gaps", "1"};
    const auto into = [&](const QString &name, const QString &seed) {
        const QString folder = m_folder->filePath(name);
        QStringList arguments{"simulate", "--out", folder, "--seed", seed};
        if (runCli(arguments + common).exitCode != 0)
            qFatal("simulate failed");
        return folder;
    };
    const QString first = into("first", "3");
    const QString again = into("again", "3");
    const QString other = into("other", "4");
    for (const QString &name : filesIn(first)) {
        QCOMPARE(bytesOf(first + '/' + name), bytesOf(again + '/' + name));
        if (!name.endsWith(".meta.json"))
            QVERIFY(bytesOf(first + '/' + name) != bytesOf(other + '/' + name));
    }
    QVERIFY(bytesOf(first + "/run1.csv") != bytesOf(first + "/run2.csv"));
}

void TestCliSimulate::simulate_json_listsTheFiles()
{
    const Outcome outcome =
        runCli({"simulate", "--out", out(), "--runs", "2", "--profile", "quick", "--json"});
    QCOMPARE(outcome.exitCode, 0);
    const auto json = nlohmann::json::parse(outcome.output.toStdString());
    QCOMPARE(json["simulated"].get<bool>(), true);
    QCOMPARE(json["runs"].size(), std::size_t{2});
    QCOMPARE(json["runs"][0]["samples"].get<int>(), 3700);
    QVERIFY(QFile::exists(QString::fromStdString(json["runs"][1]["file"].get<std::string>())));
    QVERIFY(QFile::exists(QString::fromStdString(json["truth"].get<std::string>())));
}

void TestCliSimulate::simulate_fewerRunsThanBefore_pointsOutTheOlderOne()
{
    const auto withRuns = [this](const QString &runs) {
        return runCli({"simulate", "--out", out(), "--profile", "quick", "--runs", runs});
    };
    QCOMPARE(withRuns("3").exitCode, 0);
    const Outcome outcome = withRuns("2");
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(isOneSentence(outcome.errors));
    QVERIFY(outcome.errors.contains("run3.csv"));
}

void TestCliSimulate::simulate_badOption_saysItInOneSentence_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QByteArray>("says");
    constexpr int kUsage = 2;
    constexpr int kInvalidOption = static_cast<int>(Errc::InvalidOption);
    const auto row = [](const QStringList &arguments, int exitCode, const QByteArray &says) {
        QTest::newRow(qPrintable(arguments.join(' '))) << arguments << exitCode << says;
    };
    row({"--runs", "0"}, kInvalidOption, "number of runs is 0; give 1 to 200");
    row({"--runs", "-3"}, kInvalidOption, "number of runs is -3");
    row({"--runs", "201"}, kInvalidOption, "number of runs is 201");
    row({"--rate", "0"}, kInvalidOption, "sampling rate is 0 Hz; give more than 0 and at most 100000 Hz");
    row({"--rate", "-10"}, kInvalidOption, "sampling rate is -10 Hz");
    row({"--noise", "-0.1"}, kInvalidOption, "noise of the rate is -0.1 dps");
    row({"--spread", "-1"}, kInvalidOption, "spread between runs is -1");
    row({"--lag", "nan"}, kInvalidOption, "lag of the package is nan s");
    row({"--outliers", "2"}, kInvalidOption, "fraction of outliers is 2");
    row({"--bias-instability", "-1"}, kInvalidOption, "bias instability is -1 dps; give 0 to");
    row({"--chamber-dead-time", "-1"}, kInvalidOption, "dead time of the chamber is -1 s");
    row({"--sensor", "MPU6000"}, kInvalidOption, "no datasheet of a gyro \"MPU6000\"");
    row({"--gaps", "-1"}, kInvalidOption, "number of gaps is -1");
    row({"--profile", "desert"}, kInvalidOption, "no temperature profile \"desert\"");
    row({"--truth", "bent"}, kInvalidOption, "no drift curve \"bent\"");
    row({"--reference-rate", "1,2,999"}, kInvalidOption, "reference rate on z is 999 dps");
    row({"--reference-rate", "1,2"}, kUsage, "is not three numbers");
    row({"--reference-rate", "1,2,3,4"}, kUsage, "is not three numbers");
    row({"--reference-rate", "1,2,x"}, kUsage, "is not three numbers");
    row({"--runs", "many"}, kUsage, "--runs");
    row({"--seed", "-1"}, kUsage, "--seed");
    row({"--colour", "red"}, kUsage, "--colour");
    row({"--rate"}, kUsage, "--rate");
}

void TestCliSimulate::simulate_badOption_saysItInOneSentence()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    QFETCH(QByteArray, says);
    const QStringList command{"simulate", "--out", out()};
    const Outcome outcome = runCli(command + arguments);
    QCOMPARE(outcome.exitCode, exitCode);
    QVERIFY2(isOneSentence(outcome.errors), outcome.errors.constData());
    QVERIFY2(outcome.errors.contains(says), outcome.errors.constData());
    QCOMPARE(outcome.output, QByteArray());
    QVERIFY(!QFile::exists(out()));
}

void TestCliSimulate::simulate_folderBelowAFile_isRefused()
{
    QFile file(m_folder->filePath("file"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    const Outcome outcome = runCli({"simulate", "--out", file.fileName() + "/campaign"});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::OutputNotWritable));
    QVERIFY(outcome.errors.startsWith("driftbench-cli: ") && outcome.errors.contains("can't be written"));
    QCOMPARE(outcome.errors.count('\n'), 1);
}

void TestCliSimulate::simulate_fullDisk_leavesTheFolderAsItWas()
{
    const auto onDisk = runOnSmallDisk(m_folder->path(), "300k",
                                       "echo before > \"$1/run1.csv\" && "
                                       "\"$2\" simulate --out \"$1\" --profile quick --runs 5; "
                                       "echo \"exit $?\"; ls -A \"$1\"; cat \"$1/run1.csv\"");
    if (!onDisk)
        QSKIP("this machine does not let a test mount a small file system");
    const Outcome &outcome = *onDisk;
    QCOMPARE(outcome.output, QByteArray("exit 31\nrun1.csv\nbefore\n"));
    QVERIFY(outcome.errors.contains("no room is left on its disk"));
}

void TestCliSimulate::simulate_fullStandardOutput_isAnError()
{
    QProcess process;
    process.setStandardOutputFile("/dev/full");
    process.start(cliPath(), {"simulate", "--out", out(), "--profile", "quick", "--runs", "1"});
    const Outcome outcome = finish(process);
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::OutputFull));
    QVERIFY(isOneSentence(outcome.errors));
}

void TestCliSimulate::simulate_interrupted_leavesNothing_data()
{
    QTest::addColumn<int>("signalNumber");
    QTest::newRow("SIGINT") << SIGINT;
    QTest::newRow("SIGTERM") << SIGTERM;
}

void TestCliSimulate::simulate_interrupted_leavesNothing()
{
    QFETCH(int, signalNumber);
    QProcess process;
    process.start(cliPath(), {"simulate", "--out", out(), "--rate", "100000"}); // would take minutes
    QTRY_VERIFY_WITH_TIMEOUT(!filesIn(out()).isEmpty(), 30000);
    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signalNumber), 0);
    const Outcome outcome = finish(process);
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::Cancelled));
    QCOMPARE(outcome.errors,
             QByteArray("driftbench-cli: The simulation was cancelled; no file was written.\n"));
    QVERIFY(!QFile::exists(out()));
}

void TestCliSimulate::help_everyCommand_fitsATerminalAndHasAnExample()
{
    const QStringList commands{"plan",  "simulate", "inspect", "fit",     "evaluate",
                               "apply", "export",   "device",  "physics", "reproduce"};
    QList<QStringList> helps{{"--help"}};
    for (const QString &command : commands)
        helps.append({command, "--help"});
    for (const QStringList &arguments : helps) {
        const Outcome outcome = runCli(arguments);
        QCOMPARE(outcome.exitCode, 0);
        QCOMPARE(outcome.errors, QByteArray());
        QVERIFY(outcome.output.contains("Example:\n  driftbench-cli "));
        for (const QByteArray &line : outcome.output.split('\n'))
            QVERIFY2(QString::fromUtf8(line).size() <= 80, line.constData());
    }
    for (const QString &command : commands)
        QVERIFY(runCli({"--help"}).output.contains("\n  " + command.toUtf8()));
    const Outcome version = runCli({"--version"});
    QCOMPARE(version.exitCode, 0);
    QVERIFY(version.output.startsWith("driftbench-cli "));
    const Outcome nothing = runCli({});
    QCOMPARE(nothing.exitCode, 2);
    QVERIFY(isOneSentence(nothing.errors));
    const Outcome unknown = runCli({"sumilate"});
    QCOMPARE(unknown.exitCode, 2);
    QVERIFY(isOneSentence(unknown.errors) && unknown.errors.contains("sumilate"));
}

void TestCliSimulate::help_main_listsEveryExitCode()
{
    // What the command line promises in writing, whatever the names in the code become.
    const QByteArray help = runCli({"--help"}).output;
    for (const int code : {0,  1,  2,  10, 11, 12, 13, 14, 15, 16, 17, 20, 21, 22, 23, 24,
                           25, 26, 27, 28, 29, 30, 31, 40, 41, 42, 43, 44, 45, 50, 60, 70})
        QVERIFY2(help.contains(QByteArray::number(code).rightJustified(4) + "  "),
                 qPrintable(QString::number(code)));
}

QTEST_GUILESS_MAIN(TestCliSimulate)
#include "tst_cli_simulate.moc"
