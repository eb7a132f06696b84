// Sessions on the command line: logs in, a fit of what is in, everything noted, logs out.
#include "engine/base/result.h"
#include "support/cli_process.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include <csignal>
#include <sys/types.h>

using namespace driftbench;
using namespace driftbench::test;

class TestCliSession : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init();

    void import_logs_areRunsOfANewSession();
    void import_badLog_doesNotKeepTheOthersOut();
    void import_otherSensor_isRefused();
    void info_noSuchFile_isOneSentence();
    void info_noSession_isOneSentence();
    void exportCsv_run_readsBackTheSame();
    void exportCsv_unknownRun_namesTheKnown();
    void fit_session_findsWhatTheLogsGive();
    void fit_session_keepsWhatWasSaid();
    void fit_sessionBesideLogs_isRefused();
    void fit_logsWithoutOut_isRefused();
    void export_session_isNoted();
    void upload_session_isNoted();
    void apply_session_equalsItsModelFile();
    void export_sessionWithoutModels_saysWhatToDo();
    void evaluate_session_judgesItsRuns();
    void record_twice_areTwoRunsOfOneSession();
    void record_killed_isInterruptedAndGoesOn();
    void record_interruptedByTheUser_keepsEverything();
    void record_continueWithoutOne_saysSo();
    void record_optionsOfLogs_areRefused();
    void check_soundFile_findsNothing();
    void check_damagedFile_saysSo();

private:
    QString log(int run) const { return m_logs.filePath("run" + QString::number(run) + ".csv"); }
    QStringList logs() const { return {log(1), log(2), log(3)}; }
    QString session() const { return m_folder->filePath("gyro.driftbench"); }
    void import() const;

    QTemporaryDir m_logs;
    std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {

using Json = nlohmann::json;

Json jsonFrom(const Outcome &outcome)
{
    return Json::parse(outcome.output.toStdString());
}

const QStringList kQuickModels{"--models", "constant,linear,cubic"};

} // namespace

void TestCliSession::initTestCase()
{
    simulateQuietly(m_logs.path(), {"--runs", "3"});
}

void TestCliSession::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestCliSession::import() const
{
    const Outcome outcome = runCli(QStringList{"session", "import", session()} + logs());
    QCOMPARE(outcome.errors, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
}

void TestCliSession::import_logs_areRunsOfANewSession()
{
    import();
    const Json info = jsonFrom(runCli({"session", "info", session(), "--json"}));
    QCOMPARE(info["runs"].size(), std::size_t(3));
    QCOMPARE(info["runs"][1]["name"].get<std::string>(), std::string("run2"));
    QCOMPARE(info["runs"][1]["state"].get<std::string>(), std::string("imported"));
    QVERIFY(info["runs"][1]["samples"].get<int>() > 1000);
    QVERIFY(info["simulated"].get<bool>());
    QVERIFY(info["models"].empty());
    const QByteArray text = runCli({"session", "info", session()}).output;
    QVERIFY(text.contains("run3") && text.contains("simulated") && text.contains("No models"));
}

void TestCliSession::import_badLog_doesNotKeepTheOthersOut()
{
    const QString bad = m_folder->filePath("bad.csv");
    writeBytes(bad, "nothing of use\n");
    const Outcome outcome = runCli({"session", "import", session(), log(1), bad, log(2)});
    QVERIFY(outcome.exitCode != 0);
    QVERIFY(outcome.errors.contains("bad.csv"));
    QCOMPARE(outcome.output, QByteArray("run1\nrun2\n"));
    QCOMPARE(jsonFrom(runCli({"session", "info", session(), "--json"}))["runs"].size(), std::size_t(2));
}

void TestCliSession::import_otherSensor_isRefused()
{
    import();
    const QString other = m_folder->filePath("other");
    simulateQuietly(other, {"--runs", "1", "--sensor", "L3GD20H"});
    const Outcome outcome = runCli({"session", "import", session(), other + "/run1.csv"});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::DifferentSensors));
    QCOMPARE(jsonFrom(runCli({"session", "info", session(), "--json"}))["runs"].size(), std::size_t(3));
}

void TestCliSession::info_noSuchFile_isOneSentence()
{
    const Outcome outcome = runCli({"session", "info", session()});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::FileNotFound));
    QVERIFY(isOneSentence(outcome.errors));
    QVERIFY2(!QFile::exists(session()), "looking does not make it");
}

void TestCliSession::info_noSession_isOneSentence()
{
    writeBytes(session(), QByteArray(5000, 'x'));
    const Outcome outcome = runCli({"session", "info", session()});
    QVERIFY(outcome.exitCode > 0);
    QVERIFY(isOneSentence(outcome.errors));
    QCOMPARE(bytesOf(session()), QByteArray(5000, 'x'));
}

void TestCliSession::exportCsv_run_readsBackTheSame()
{
    import();
    const QString out = m_folder->filePath("out.csv");
    const Outcome outcome = runCli({"session", "export-csv", session(), "--run", "run2", "--out", out});
    QCOMPARE(outcome.exitCode, 0);
    const QString again = m_folder->filePath("again.driftbench");
    QCOMPARE(runCli({"session", "import", again, out}).exitCode, 0);
    const QString twice = m_folder->filePath("twice.csv");
    QCOMPARE(runCli({"session", "export-csv", again, "--out", twice}).exitCode, 0);
    QCOMPARE(bytesOf(twice), bytesOf(out));
    const auto rows = [](const QByteArray &text) {
        QList<QByteArray> lines = text.split('\n');
        lines.removeIf([](const QByteArray &line) { return line.startsWith('#') || line.isEmpty(); });
        return lines;
    };
    const QList<QByteArray> before = rows(bytesOf(log(2)));
    const QList<QByteArray> after = rows(bytesOf(out));
    QCOMPARE(after.size(), before.size());
    for (qsizetype i = 1; i < before.size(); i += 997) {
        const QList<QByteArray> a = before[i].split(',');
        const QList<QByteArray> b = after[i].split(',');
        for (qsizetype column = 0; column < 5; ++column)
            QCOMPARE(b[column].toDouble(), a[column].toDouble());
    }
}

void TestCliSession::exportCsv_unknownRun_namesTheKnown()
{
    import();
    const Outcome outcome =
        runCli({"session", "export-csv", session(), "--run", "run9", "--out", m_folder->filePath("x.csv")});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::NoSuchRun));
    QVERIFY(isOneSentence(outcome.errors));
    QVERIFY(outcome.errors.contains("run1, run2, run3"));
}

void TestCliSession::fit_session_findsWhatTheLogsGive()
{
    import();
    const QString fromLogs = m_folder->filePath("logs");
    const QString fromSession = m_folder->filePath("session");
    QCOMPARE(runCli(QStringList{"fit"} + logs() + kQuickModels + QStringList{"--out", fromLogs}).exitCode, 0);
    const Outcome outcome = runCli(QStringList{"fit", session(), "--out", fromSession} + kQuickModels);
    QCOMPARE(outcome.exitCode, 0);
    for (const char *model : {"constant", "linear", "cubic", "auto"}) {
        const QString file = QString("/models/%1.json").arg(model);
        QCOMPARE(bytesOf(fromSession + file), bytesOf(fromLogs + file));
    }
    const Json a = Json::parse(bytesOf(fromLogs + "/comparison.json").toStdString());
    const Json b = Json::parse(bytesOf(fromSession + "/comparison.json").toStdString());
    QVERIFY(a["rows"] == b["rows"]);
    const Json info = jsonFrom(runCli({"session", "info", session(), "--json"}));
    QCOMPARE(info["models"].size(), std::size_t(4));
}

void TestCliSession::fit_session_keepsWhatWasSaid()
{
    import();
    QCOMPARE(runCli(QStringList{"fit", session(), "--hold-out", "run2", "--exclude", "10:20"} + kQuickModels)
                 .exitCode,
             0);
    const Outcome again = runCli({"fit", session(), "--json"});
    QCOMPARE(again.exitCode, 0);
    const Json comparison = jsonFrom(again);
    QVERIFY(comparison["hold_out"] == Json::array({"run2"}));
    QVERIFY(comparison["runs"][0]["masked"].contains("excluded"));
    QCOMPARE(comparison["rows"].size(), std::size_t(3 * 3));
    const Outcome unknown = runCli({"fit", session(), "--hold-out", "run9"});
    QCOMPARE(unknown.exitCode, static_cast<int>(Errc::NoSuchRun));
}

void TestCliSession::fit_sessionBesideLogs_isRefused()
{
    import();
    const Outcome outcome = runCli({"fit", session(), log(1), "--out", m_folder->filePath("fit")});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::InvalidOption));
    QVERIFY(isOneSentence(outcome.errors));
}

void TestCliSession::fit_logsWithoutOut_isRefused()
{
    const Outcome outcome = runCli(QStringList{"fit"} + logs());
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::InvalidOption));
    QVERIFY(outcome.errors.contains("--out"));
}

void TestCliSession::export_session_isNoted()
{
    import();
    QCOMPARE(runCli(QStringList{"fit", session()} + kQuickModels).exitCode, 0);
    const QString table = m_folder->filePath("table.h");
    const Outcome outcome = runCli(
        {"export", "--model", session(), "--name", "cubic", "--force", "--format", "c", "--out", table});
    QVERIFY2(outcome.exitCode == 0, outcome.errors);
    QVERIFY(QFile::exists(table));
    const Json info = jsonFrom(runCli({"session", "info", session(), "--json"}));
    QCOMPARE(info["exports"].get<int>(), 1);
    QVERIFY(runCli({"session", "info", session()}).output.contains("table.h (c)"));
    const Outcome unknown =
        runCli({"export", "--model", session(), "--name", "rbf", "--format", "c", "--out", table});
    QCOMPARE(unknown.exitCode, static_cast<int>(Errc::NoSuchRun));
    QVERIFY(unknown.errors.contains("constant, linear, cubic, auto"));
}

void TestCliSession::upload_session_isNoted()
{
    import();
    QCOMPARE(runCli(QStringList{"fit", session()} + kQuickModels).exitCode, 0);
    const Outcome outcome = runCli({"device", "upload", "--model", session(), "--name", "cubic", "--force",
                                    "--flash", m_folder->filePath("bridge.bin"), "--json"});
    QVERIFY2(outcome.exitCode == 0, outcome.errors);
    QVERIFY(jsonFrom(outcome)["activated"].get<bool>());
    QCOMPARE(jsonFrom(runCli({"session", "info", session(), "--json"}))["uploads"].get<int>(), 1);
    QVERIFY(runCli({"session", "info", session()}).output.contains("to simulated, verified, in use"));
}

void TestCliSession::apply_session_equalsItsModelFile()
{
    import();
    const QString fit = m_folder->filePath("fit");
    QCOMPARE(runCli(QStringList{"fit", session(), "--out", fit} + kQuickModels).exitCode, 0);
    const auto compensated = [&](const QStringList &model, const QString &name) {
        const QString out = m_folder->filePath(name);
        const Outcome outcome = runCli(QStringList{"apply", "--model"} + model + QStringList{logs()[1], out});
        QFile file(out);
        return outcome.exitCode == 0 && file.open(QIODevice::ReadOnly) ? file.readAll() : outcome.errors;
    };
    const QByteArray bySession = compensated({session(), "--name", "linear"}, "session.csv");
    QVERIFY(bySession.contains("comp_x_dps"));
    QVERIFY(bySession == compensated({fit + "/models/linear.json"}, "file.csv"));
}

void TestCliSession::export_sessionWithoutModels_saysWhatToDo()
{
    import();
    const Outcome outcome =
        runCli({"export", "--model", session(), "--format", "csv", "--out", m_folder->filePath("t.csv")});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::NoSuchRun));
    QVERIFY(outcome.errors.contains(" fit "));
}

void TestCliSession::evaluate_session_judgesItsRuns()
{
    import();
    QCOMPARE(runCli(QStringList{"fit", session(), "--hold-out", "run3"} + kQuickModels).exitCode, 0);
    const Outcome outcome =
        runCli({"evaluate", "--model", session(), "--name", "linear", session(), "--json"});
    QVERIFY2(outcome.exitCode == 0, outcome.errors);
    const Json judged = jsonFrom(outcome);
    QCOMPARE(judged["rows"].size(), std::size_t(3 * 3));
    const QString out = m_folder->filePath("fit");
    QCOMPARE(runCli(QStringList{"fit", session(), "--out", out}).exitCode, 0);
    const Json byFile =
        jsonFrom(runCli({"evaluate", "--model", out + "/models/linear.json", session(), "--json"}));
    QVERIFY(byFile["rows"] == judged["rows"]);
}

void TestCliSession::record_twice_areTwoRunsOfOneSession()
{
    for (const char *name : {"heating", "cooling"}) {
        const Outcome outcome =
            runCli({"record", "--source", "simulated", "--speed", "0", "--duration", "100", "--out",
                    session(), "--name", name, "--reference-rate", "1,2,3"});
        QVERIFY2(outcome.exitCode == 0, outcome.errors);
        QVERIFY(outcome.output.contains("1000 samples"));
    }
    const Json info = jsonFrom(runCli({"session", "info", session(), "--json"}));
    QCOMPARE(info["runs"].size(), std::size_t(2));
    QCOMPARE(info["runs"][1]["name"].get<std::string>(), std::string("cooling"));
    QCOMPARE(info["runs"][1]["state"].get<std::string>(), std::string("complete"));
    QCOMPARE(info["runs"][1]["samples"].get<int>(), 1000);
    const Outcome other = runCli(
        {"record", "--source", "simulated:L3GD20H", "--speed", "0", "--duration", "1", "--out", session()});
    QCOMPARE(other.exitCode, static_cast<int>(Errc::DifferentSensors));
}

void TestCliSession::record_killed_isInterruptedAndGoesOn()
{
    QProcess process;
    process.start(cliPath(), {"record", "--source", "simulated", "--rate", "1000", "--out", session()});
    QVERIFY(process.waitForStarted());
    const auto samples = [this] {
        const Outcome info = runCli({"session", "info", session(), "--json"});
        return info.exitCode == 0 && !jsonFrom(info)["runs"].empty()
                   ? jsonFrom(info)["runs"][0]["samples"].get<int>()
                   : 0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(samples() > 500, 60000);
    process.kill();
    QVERIFY(process.waitForFinished());
    const Json before = jsonFrom(runCli({"session", "info", session(), "--json"}))["runs"][0];
    QCOMPARE(before["state"].get<std::string>(), std::string("interrupted"));
    const Outcome more = runCli({"record", "--source", "simulated", "--rate", "1000", "--speed", "0",
                                 "--duration", "1", "--out", session(), "--continue"});
    QVERIFY2(more.exitCode == 0, more.errors);
    const Json after = jsonFrom(runCli({"session", "info", session(), "--json"}));
    QCOMPARE(after["runs"].size(), std::size_t(1));
    QCOMPARE(after["runs"][0]["state"].get<std::string>(), std::string("complete"));
    QCOMPARE(after["runs"][0]["samples"].get<int>(), before["samples"].get<int>() + 1000);
    QVERIFY(after["runs"][0]["gaps"].get<int>() >= 1);
    QCOMPARE(runCli({"session", "check", session()}).exitCode, 0);
}

void TestCliSession::record_interruptedByTheUser_keepsEverything()
{
    QProcess process;
    process.start(cliPath(),
                  {"record", "--source", "simulated", "--rate", "1000", "--out", session(), "--json"});
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(runCli({"session", "info", session()}).output.contains("recording"), 60000);
    QVERIFY(::kill(static_cast<pid_t>(process.processId()), SIGINT) == 0);
    const Outcome outcome = finish(process);
    QVERIFY2(outcome.exitCode == 0, outcome.errors);
    const Json recorded = jsonFrom(outcome);
    const Json info = jsonFrom(runCli({"session", "info", session(), "--json"}));
    QVERIFY(recorded["samples"].get<int>() > 0);
    QCOMPARE(info["runs"][0]["samples"].get<int>(), recorded["samples"].get<int>());
    QCOMPARE(info["runs"][0]["state"].get<std::string>(), std::string("complete"));
}

void TestCliSession::record_continueWithoutOne_saysSo()
{
    import();
    const Outcome outcome = runCli({"record", "--source", "simulated", "--out", session(), "--continue"});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::NoSuchRun));
    QVERIFY(isOneSentence(outcome.errors));
}

void TestCliSession::record_optionsOfLogs_areRefused()
{
    QCOMPARE(runCli({"record", "--source", "simulated", "--out", session(), "--overwrite"}).exitCode,
             static_cast<int>(Errc::InvalidOption));
    QCOMPARE(runCli({"record", "--source", "simulated", "--out", m_folder->filePath("a.csv"), "--continue"})
                 .exitCode,
             static_cast<int>(Errc::InvalidOption));
}

void TestCliSession::check_soundFile_findsNothing()
{
    import();
    const Outcome outcome = runCli({"session", "check", session(), "--json"});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(jsonFrom(outcome)["problems"].empty());
}

void TestCliSession::check_damagedFile_saysSo()
{
    import();
    QByteArray bytes = bytesOf(session());
    for (qsizetype at = bytes.size() / 3; at < bytes.size() * 2 / 3; at += 1000)
        bytes[at] = static_cast<char>(bytes[at] ^ 0x5a);
    writeBytes(session(), bytes);
    const Outcome outcome = runCli({"session", "check", session()});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::SessionDamaged));
}

QTEST_APPLESS_MAIN(TestCliSession)
#include "tst_cli_session.moc"
