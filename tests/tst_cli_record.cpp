// `record` as its users run it: from the simulated bridge and from logs into logs that the other commands
// read, ended by a duration, a plan, Ctrl-C or a kill.
#include "engine/formats/log_reader.h"
#include "engine/physics/plan_file.h"
#include "support/cli_process.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include <csignal>

using namespace driftbench;
using namespace driftbench::test;

class TestCliRecord : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();

    void record_duration_isThatLong();
    void record_plan_isFollowedToItsEnd();
    void record_runsOfACampaign_canBeFitted();
    void record_file_isTheSameLogAgain();
    void record_compensate_takesTheTableOff();
    void record_interrupt_keepsWhatWasRecorded();
    void record_kill_losesAtMostASecond();
    void record_existingLog_needsOverwrite();
    void record_badInput_saysWhichInOneSentence_data();
    void record_badInput_saysWhichInOneSentence();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    Outcome record(const QString &source, const QString &out, const QStringList &more = {}) const
    {
        return runCli(QStringList{"record", "--source", source, "--out", path(out)} + more);
    }
    Eigen::Index samplesIn(const QString &name) const;

    QTemporaryDir m_folder;
};

namespace {

using Json = nlohmann::json;

Json parsed(const QByteArray &bytes)
{
    return Json::parse(bytes.toStdString());
}

// Until a file has so many bytes.
bool waitForBytes(const QString &path, qint64 bytes)
{
    QElapsedTimer timer;
    timer.start();
    while (QFile(path).size() < bytes && timer.elapsed() < 60000)
        QTest::qSleep(10);
    return QFile(path).size() >= bytes;
}

} // namespace

void TestCliRecord::initTestCase()
{
    QVERIFY(m_folder.isValid());
    TestPlan plan = *makeTestPlan(*namedSensor("I3G4250D"), *namedChamber("SET-Z-021"));
    plan.lowestC = 10.0;
    plan.highestC = 40.0;
    plan.stepC = 1.0;
    plan.periodS = 10.0;
    plan.holdS = 30.0;
    QVERIFY(writePlan(plan, path("plan.json").toStdString()).ok());
}

Eigen::Index TestCliRecord::samplesIn(const QString &name) const
{
    const auto log = readLog(path(name).toStdString(), {});
    return log ? log->size() : -1;
}

void TestCliRecord::record_duration_isThatLong()
{
    const Outcome outcome = record("simulated:L3GD20H:N-7", "short.csv",
                                   {"--duration", "30", "--rate", "200", "--speed", "0", "--json"});
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    QVERIFY(outcome.errors.isEmpty());
    const Json json = parsed(outcome.output);
    QCOMPARE(json["samples"].get<int>(), 6000);
    QCOMPARE(json["ended_by"].get<std::string>(), std::string("duration"));
    QCOMPARE(json["lost_samples"].get<int>(), 0);
    QVERIFY(std::abs(json["measured_rate_hz"].get<double>() - 200.0) < 0.1);
    QCOMPARE(samplesIn("short.csv"), Eigen::Index(6000));
    QCOMPARE(filesIn(m_folder.path()).filter("short"),
             (QStringList{"short.csv", "short.csv.events.csv", "short.csv.meta.json"}));
    const Json sidecar = parsed(bytesOf(path("short.csv.meta.json")));
    QCOMPARE(sidecar["sensor"]["serial"].get<std::string>(), std::string("N-7"));
    QVERIFY(sidecar["recording"]["complete"].get<bool>());
}

void TestCliRecord::record_plan_isFollowedToItsEnd()
{
    const Outcome outcome = record("simulated", "planned.csv", {"--plan", path("plan.json"), "--speed", "0"});
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    QVERIFY(
        outcome.output.contains("samples      3600 in 359.9 s, 10.00 Hz")); // 30 + 30 x 10 + 30 s at 10 Hz
    const auto log = readLog(path("planned.csv").toStdString(), {});
    QVERIFY(log->temperatureC.minCoeff() < 10.5 && log->temperatureC.maxCoeff() > 39.0);
    QCOMPARE(runCli({"inspect", path("planned.csv")}).exitCode, 0);
}

void TestCliRecord::record_runsOfACampaign_canBeFitted()
{
    QStringList logs;
    for (const char *run : {"1", "2", "3"}) {
        const QString name = QString("run%1.csv").arg(run);
        QCOMPARE(
            record("simulated", name,
                   {"--plan", path("plan.json"), "--speed", "0", "--run", run, "--reference-rate", "25,5,53"})
                .exitCode,
            0);
        logs << path(name);
    }
    QVERIFY(bytesOf(logs[0]) != bytesOf(logs[1]));
    const Outcome fit =
        runCli(QStringList{"fit"} + logs + QStringList{"--reference-rate", "25,5,53", "--out", path("fit")});
    QVERIFY2(fit.exitCode == 0, fit.errors.constData());
    QVERIFY(QFile::exists(path("fit/models/auto.json")));
}

void TestCliRecord::record_file_isTheSameLogAgain()
{
    QCOMPARE(record("simulated", "first.csv", {"--duration", "20", "--speed", "0"}).exitCode, 0);
    QCOMPARE(record("file:" + path("first.csv") + "*0", "again.csv").exitCode, 0);
    const auto rows = [&](const QString &name) {
        const QByteArray text = bytesOf(path(name));
        return text.mid(text.indexOf("time_s"));
    };
    const auto first = readLog(path("first.csv").toStdString(), {});
    const auto again = readLog(path("again.csv").toStdString(), {});
    QVERIFY(first->timeS == again->timeS && first->rateDps == again->rateDps);
    QVERIFY(first->temperatureC == again->temperatureC);
    QCOMPARE(again->info.sensor.serial, std::string("SIM-0001"));
    QVERIFY(again->info.simulated && rows("again.csv").startsWith("time_s"));
}

void TestCliRecord::record_compensate_takesTheTableOff()
{
    QVERIFY2(QFile::exists(path("fit/models/rbf.json")), "the campaign was not fitted");
    QCOMPARE(runCli({"device", "upload", "--force", "--model", path("fit/models/rbf.json"), "--flash",
                     path("flash.bin")})
                 .exitCode,
             0);
    const auto meanSquare = [&](const QString &out, const QStringList &more) {
        const Outcome outcome =
            record("simulated", out,
                   QStringList{"--plan", path("plan.json"), "--speed", "0", "--run", "9", "--flash",
                               path("flash.bin"), "--reference-rate", "25,5,53"} +
                       more);
        if (outcome.exitCode != 0)
            qWarning("%s", outcome.errors.constData());
        const auto log = readLog(path(out).toStdString(), {});
        return (log->rateDps.col(1).array() - 5.0).square().mean();
    };
    const double raw = meanSquare("raw.csv", {});
    const double compensated = meanSquare("compensated.csv", {"--compensate"});
    QVERIFY2(compensated < 0.6 * raw, qPrintable(QString("%1 of %2").arg(compensated).arg(raw)));
    QVERIFY(parsed(bytesOf(path("compensated.csv.meta.json")))["recording"]["compensated"].get<bool>());
}

void TestCliRecord::record_interrupt_keepsWhatWasRecorded()
{
    QProcess process;
    process.start(cliPath(),
                  {"record", "--source", "simulated", "--rate", "500", "--out", path("stopped.csv")});
    QVERIFY(process.waitForStarted());
    QVERIFY(waitForBytes(path("stopped.csv"), 20000));
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    const Outcome outcome = finish(process);
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(outcome.output.contains("stopped by you"));
    const Json meta = parsed(bytesOf(path("stopped.csv.meta.json")))["recording"];
    QVERIFY(meta["complete"].get<bool>());
    QCOMPARE(samplesIn("stopped.csv"), meta["samples"].get<Eigen::Index>());
}

void TestCliRecord::record_kill_losesAtMostASecond()
{
    QProcess process;
    process.start(cliPath(),
                  {"record", "--source", "simulated:L3GD20H", "--rate", "500", "--out", path("killed.csv")});
    QVERIFY(process.waitForStarted());
    QVERIFY(waitForBytes(path("killed.csv"), 20000));
    process.kill();
    QVERIFY(process.waitForFinished());
    const auto log = readLog(path("killed.csv").toStdString(), {});
    QVERIFY2(log.ok(), log ? "" : log.error().message.c_str());
    QVERIFY(log->size() > 300);
    QCOMPARE(log->info.sensor.model, std::string("L3GD20H"));
    QVERIFY(!parsed(bytesOf(path("killed.csv.meta.json")))["recording"]["complete"].get<bool>());
}

void TestCliRecord::record_existingLog_needsOverwrite()
{
    const QStringList brief{"--duration", "5", "--speed", "0"};
    QCOMPARE(record("simulated", "twice.csv", brief).exitCode, 0);
    const QByteArray before = bytesOf(path("twice.csv"));
    const Outcome refused = record("simulated", "twice.csv", brief + QStringList{"--seed", "2"});
    QCOMPARE(refused.exitCode, static_cast<int>(Errc::OutputNotWritable));
    QVERIFY(isOneSentence(refused.errors));
    QCOMPARE(bytesOf(path("twice.csv")), before);
    QCOMPARE(record("simulated", "twice.csv", brief + QStringList{"--seed", "2", "--overwrite"}).exitCode, 0);
    QVERIFY(bytesOf(path("twice.csv")) != before);
}

void TestCliRecord::record_badInput_saysWhichInOneSentence_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    const int option = static_cast<int>(Errc::InvalidOption);
    const int missing = static_cast<int>(Errc::DeviceNotFound);
    const QStringList simulated{"--source", "simulated", "--speed", "0"};
    QTest::newRow("source") << QStringList{"--source", "toaster"} << option;
    QTest::newRow("sensor") << QStringList{"--source", "simulated:X1"} << option;
    QTest::newRow("serial") << QStringList{"--source", "hid:NOT-THERE"} << missing;
    QTest::newRow("ids") << QStringList{"--source", "hid", "--usb-id", "dead:beef"} << missing;
    QTest::newRow("bad id") << QStringList{"--source", "hid", "--usb-id", "dead"} << option;
    QTest::newRow("chip") << QStringList{"--source", "i2c:ch341/auto"} << option;
    QTest::newRow("gyro") << QStringList{"--source", "i2c:cp2112/bmi088"} << option;
    QTest::newRow("chip serial") << QStringList{"--source", "i2c:cp2112:NOT-THERE/auto"} << missing;
    QTest::newRow("log") << QStringList{"--source", "file:/no/such.csv"}
                         << static_cast<int>(Errc::FileNotFound);
    QTest::newRow("rate") << simulated + QStringList{"--rate", "1e6"} << option;
    QTest::newRow("rate nan") << simulated + QStringList{"--rate", "nan"} << option;
    QTest::newRow("range") << simulated + QStringList{"--range", "7"} << option;
    QTest::newRow("thermometer") << simulated + QStringList{"--thermometer", "mercury"} << option;
    QTest::newRow("duration") << simulated + QStringList{"--duration", "-1"} << option;
    QTest::newRow("speed") << QStringList{"--source", "simulated", "--speed", "-1"} << option;
    QTest::newRow("speed of hid") << QStringList{"--source", "hid", "--speed", "2"} << option;
    QTest::newRow("seed of hid") << QStringList{"--source", "hid", "--seed", "2"} << option;
    for (const QStringList &ofLogs : {QStringList{"--columns", "1,2,3,4,5"},
                                      QStringList{"--rate-unit", "mdps"}, QStringList{"--instance", "0"}})
        QTest::addRow("%s of simulated", qPrintable(ofLogs[0])) << simulated + ofLogs << option;
    QTest::newRow("ids of simulated") << simulated + QStringList{"--usb-id", "1209:0001"} << option;
    QTest::newRow("i2c option") << simulated + QStringList{"--bus-speed", "100"} << option;
    QTest::newRow("plan") << simulated + QStringList{"--plan", "/no/plan.json"}
                          << static_cast<int>(Errc::FileNotFound);
    QTest::newRow("profile") << simulated + QStringList{"--profile", "tropical"} << option;
    QTest::newRow("folder") << simulated + QStringList{"--duration", "5", "--out", "/no/folder/a.csv"}
                            << static_cast<int>(Errc::OutputNotWritable);
    QTest::newRow("no source") << QStringList{} << 2;
    QTest::newRow("run 0") << simulated + QStringList{"--run", "0"} << 2;
}

void TestCliRecord::record_badInput_saysWhichInOneSentence()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    const QStringList out{"--out", path("bad.csv")};
    const Outcome outcome =
        runCli(QStringList{"record"} + arguments + (arguments.contains("--out") ? QStringList{} : out));
    QVERIFY2(outcome.exitCode == exitCode, outcome.errors.constData());
    QVERIFY2(isOneSentence(outcome.errors), outcome.errors.constData());
    QVERIFY(!QFile::exists(path("bad.csv")));
}

QTEST_APPLESS_MAIN(TestCliRecord)
#include "tst_cli_record.moc"
