#include "engine/base/result.h"
#include "support/cli_process.h"
#include "support/test_data.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include <csignal>
#include <memory>
#include <set>

using namespace driftbench;
using namespace driftbench::test;

class TestCliFit : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init();

    void fit_leaveOneRunOut_writesWhatItPromises();
    void fit_results_goToStandardOutputOnly();
    void fit_json_isTheComparison();
    void fit_numbersOfRuns_areSaidInTheBand_data();
    void fit_numbersOfRuns_areSaidInTheBand();
    void fit_holdOut_judgesOnlyThoseAndTrainsOnTheRest_data();
    void fit_holdOut_judgesOnlyThoseAndTrainsOnTheRest();
    void fit_sameSeed_isTheSameBytesWhateverTheThreads();
    void fit_otherRunsInTheSameFolder_leaveNoModelsOfTheEarlier();
    void fit_oddRunNames_haveFoldersOfTheirOwn();
    void fit_refused_keepsTheEarlierResult();
    void fit_interrupted_leavesNothing_data();
    void fit_interrupted_leavesNothing();

    void chamber_leaveOneRunOut_isYesOnYOnly();
    void chamber_asOneRun_isNeverBetterThanWithCare_data();
    void chamber_asOneRun_isNeverBetterThanWithCare();
    void dataflash_smallSpan_isRefusedUnlessForced();
    void noDriftControl_hasNoDriftAndNoExport();

private:
    QString run(int number) const { return m_campaign.filePath("run" + QString::number(number) + ".csv"); }
    QStringList runs(int count) const;
    QString out() const { return m_folder->filePath("fit"); }

    QTemporaryDir m_campaign; // twelve runs
    std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {

using Json = nlohmann::json;

Json jsonOf(const QString &path)
{
    return Json::parse(bytesOf(path).toStdString());
}

Outcome fit(const QStringList &files, const QString &folder,
            const QStringList &more = {"--models", "constant,linear"})
{
    return runCli(QStringList{"fit", "--out", folder} + more + files);
}

std::set<std::string> runsJudged(const Json &comparison)
{
    std::set<std::string> names;
    for (const auto &row : comparison["rows"])
        names.insert(row["run"].get<std::string>());
    return names;
}

// Left on an axis by a model, pooled over the samples of all runs.
double pooledRmsDps(const Json &comparison, const std::string &model, const std::string &axis)
{
    double sum = 0.0;
    double samples = 0.0;
    for (const auto &row : comparison["rows"]) {
        if (row["model"] != model || row["axis"] != axis)
            continue;
        sum += row["msd_after"].get<double>() * row["samples"].get<double>();
        samples += row["samples"].get<double>();
    }
    return std::sqrt(sum / samples);
}

QStringList chamberRuns(const std::filesystem::path &first)
{
    QStringList files;
    for (const char *name : {"run1_cooling.csv", "run2_heating.csv", "run3_cooling.csv"})
        files.append(QString::fromStdString((first.parent_path() / name).string()));
    return files;
}

} // namespace

QStringList TestCliFit::runs(int count) const
{
    QStringList files;
    for (int number = 1; number <= count; ++number)
        files.append(run(number));
    return files;
}

void TestCliFit::initTestCase()
{
    QVERIFY(m_campaign.isValid());
    simulateQuietly(m_campaign.path(), {"--runs", "12"});
}

void TestCliFit::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
}

void TestCliFit::fit_leaveOneRunOut_writesWhatItPromises()
{
    const Outcome outcome = fit(runs(3), out(), {"--models", "constant,linear,cubic,rbf"});
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    QStringList expected{"comparison.csv",     "comparison.json", "comparison.md",   "recommendation.json",
                         "recommendation.txt", "request.json",    "models/auto.json"};
    for (const char *model : {"constant", "linear", "cubic", "rbf"}) {
        expected.append(QString("models/%1.json").arg(model));
        for (int number = 1; number <= 3; ++number)
            expected.append(QString("held-out/run%1/%2.json").arg(number).arg(model));
    }
    expected.sort();
    QCOMPARE(filesBelow(out()), expected);

    const Json comparison = jsonOf(out() + "/comparison.json");
    QCOMPARE(comparison["rows"].size(), std::size_t{3 * 3 * 4});
    for (const auto &row : comparison["rows"]) {
        for (const char *key : {"run", "axis", "model", "msd_before", "msd_after", "q", "noise_floor",
                                "excess_over_floor", "rms10s_dps", "samples", "trained_on"})
            QVERIFY2(row.contains(key), key);
        QCOMPARE(row["trained_on"].size(), std::size_t{2});
        for (const auto &name : row["trained_on"])
            QVERIFY(name != row["run"]);
        const Json heldOut =
            jsonOf(out() + "/held-out/" + QString::fromStdString(row["run"].get<std::string>()) + "/" +
                   QString::fromStdString(row["model"].get<std::string>()) + ".json");
        QVERIFY(heldOut["trained_on"] == row["trained_on"]);
    }
    for (const char *model : {"constant", "linear", "cubic", "rbf", "auto"})
        QVERIFY(
            (jsonOf(out() + "/models/" + model + ".json")["trained_on"] == Json({"run1", "run2", "run3"})));

    const Json verdicts = jsonOf(out() + "/recommendation.json");
    QCOMPARE(verdicts.size(), std::size_t{3});
    for (const auto &verdict : verdicts) {
        for (const char *key : {"axis", "verdict", "model", "gain", "gain_model_free", "reason"})
            QVERIFY2(verdict.contains(key), key);
        QCOMPARE(verdict["verdict"].get<std::string>(), std::string("yes"));
    }
}

void TestCliFit::fit_results_goToStandardOutputOnly()
{
    const Outcome outcome = fit(runs(3), out());
    QCOMPARE(outcome.exitCode, 0);
    QCOMPARE(outcome.output, bytesOf(out() + "/recommendation.txt"));
    // No progress and no warnings: there is nothing wrong with these runs.
    QCOMPARE(outcome.errors, QByteArray());
}

void TestCliFit::fit_json_isTheComparison()
{
    const Outcome outcome = fit(runs(2), out(), {"--models", "constant,linear", "--json"});
    QCOMPARE(outcome.exitCode, 0);
    Json printed = Json::parse(outcome.output.toStdString());
    QVERIFY(printed["timings_s"]["read"].get<double>() >= 0.0);
    QVERIFY(printed["timings_s"]["compare"].get<double>() > 0.0);
    printed.erase("timings_s");
    QVERIFY(printed == jsonOf(out() + "/comparison.json"));
}

void TestCliFit::fit_numbersOfRuns_areSaidInTheBand_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("folds");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("one") << 1 << 5 << QByteArray("There is only one run");
    QTest::newRow("two") << 2 << 2 << QByteArray("Two runs give no 95 % band");
    QTest::newRow("three") << 3 << 3 << QByteArray();
    QTest::newRow("twelve") << 12 << 12 << QByteArray();
}

void TestCliFit::fit_numbersOfRuns_areSaidInTheBand()
{
    QFETCH(int, count);
    QFETCH(int, folds);
    QFETCH(QByteArray, says);
    const Outcome outcome = fit(runs(count), out(), {"--models", "constant,linear,rbf"});
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    QCOMPARE(filesIn(out() + "/held-out").size(), folds);
    QCOMPARE(outcome.output.contains("Warning: "), !says.isEmpty());
    QVERIFY2(outcome.output.contains(says), outcome.output.constData());
    const Json comparison = jsonOf(out() + "/comparison.json");
    QCOMPARE(comparison["band"].is_null(), count == 1);
    if (count > 1)
        QCOMPARE(comparison["band"]["runs"].get<int>(), count);
    QCOMPARE(comparison["warnings"].empty(), says.isEmpty());
    for (const auto &verdict : comparison["verdicts"])
        QCOMPARE(verdict["verdict"].get<std::string>(), std::string(count == 1 ? "with care" : "yes"));
}

void TestCliFit::fit_holdOut_judgesOnlyThoseAndTrainsOnTheRest_data()
{
    QTest::addColumn<bool>("byFile");
    QTest::newRow("by name") << false;
    QTest::newRow("by file") << true;
}

void TestCliFit::fit_holdOut_judgesOnlyThoseAndTrainsOnTheRest()
{
    QFETCH(bool, byFile);
    const QString indirect = m_campaign.path() + "/../" + QDir(m_campaign.path()).dirName() + "/run4.csv";
    const QStringList held = byFile ? QStringList{run(2), indirect} : QStringList{"run2", "run4"};
    const QStringList options{"--models", "constant,linear,rbf", "--reference-temperature", "-40"};
    const Outcome outcome =
        fit(runs(4), out(), options + QStringList{"--hold-out", held[0], "--hold-out", held[1]});
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    const Json comparison = jsonOf(out() + "/comparison.json");
    QVERIFY(runsJudged(comparison) == std::set<std::string>({"run2", "run4"}));
    QVERIFY((comparison["hold_out"] == Json({"run2", "run4"})));
    const Json others{"run1", "run3"};
    for (const auto &row : comparison["rows"])
        QVERIFY(row["trained_on"] == others);
    for (const QString &file : filesIn(out() + "/models"))
        QVERIFY(jsonOf(out() + "/models/" + file)["trained_on"] == others);
    // The same as training on these two alone.
    const QString alone = m_folder->filePath("alone");
    QCOMPARE(fit({run(1), run(3)}, alone, options).exitCode, 0);
    for (const char *model : {"constant", "linear", "rbf"}) {
        const QString file = QString("/models/%1.json").arg(model);
        QVERIFY(jsonOf(out() + file)["parameters"] == jsonOf(alone + file)["parameters"]);
    }
}

void TestCliFit::fit_sameSeed_isTheSameBytesWhateverTheThreads()
{
    const QStringList all{"--seed", "7"}; // every model
    const QString many = m_folder->filePath("many");
    const QString one = m_folder->filePath("one");
    const QString otherSeed = m_folder->filePath("other");
    QCOMPARE(fit(runs(3), many, all).exitCode, 0);
    QProcess process;
    process.start("taskset", QStringList{"-c", "0", cliPath(), "fit", "--out", one} + all + runs(3));
    QCOMPARE(finish(process).exitCode, 0);
    QCOMPARE(filesBelow(one), filesBelow(many));
    for (const QString &file : filesBelow(many))
        QVERIFY2(bytesOf(one + '/' + file) == bytesOf(many + '/' + file), qPrintable(file));
    QCOMPARE(fit(runs(3), otherSeed, {"--seed", "8", "--models", "bpnn"}).exitCode, 0);
    QVERIFY(bytesOf(otherSeed + "/models/bpnn.json") != bytesOf(many + "/models/bpnn.json"));
}

void TestCliFit::fit_otherRunsInTheSameFolder_leaveNoModelsOfTheEarlier()
{
    QCOMPARE(fit(runs(3), out(), {"--models", "constant,linear,cubic"}).exitCode, 0);
    writeBytes(out() + "/models/notes.txt", "mine");
    writeBytes(out() + "/held-out/run1/notes.json", "mine");
    QCOMPARE(fit({run(3), run(4)}, out(), {"--models", "constant,linear"}).exitCode, 0);
    const QString fresh = m_folder->filePath("fresh");
    QCOMPARE(fit({run(3), run(4)}, fresh, {"--models", "constant,linear"}).exitCode, 0);
    QStringList expected = filesBelow(fresh) + QStringList{"models/notes.txt", "held-out/run1/notes.json"};
    expected.sort();
    QCOMPARE(filesBelow(out()), expected);
    QCOMPARE(filesIn(out() + "/held-out"), QStringList({"run1", "run3", "run4"}));
    for (const QString &file : filesBelow(fresh))
        QCOMPARE(bytesOf(out() + '/' + file), bytesOf(fresh + '/' + file));
}

void TestCliFit::fit_oddRunNames_haveFoldersOfTheirOwn()
{
    const QString logs = m_folder->filePath("logs");
    QVERIFY(QDir().mkdir(logs) && QDir().mkdir(logs + "/again"));
    const QStringList names{"a b, block 1.csv",  "...csv",
                            ".hidden.csv",       "back\\slash.csv",
                            "new\nline.csv",     "Gr\u00f6\u00dfe \u00b0.csv",
                            "again/.hidden.csv", QString(240, 'n') + ".csv"};
    QStringList files;
    for (int i = 0; i < names.size(); ++i) {
        files.append(logs + '/' + names[i]);
        QVERIFY(QFile::copy(run(i + 1), files.back()));
    }
    const Outcome outcome = fit(files, out());
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    const QStringList folders = filesIn(out() + "/held-out");
    QCOMPARE(folders.size(), names.size());
    QVERIFY(folders.contains("a b, block 1"));
    std::set<std::string> left;
    for (const QString &folder : folders) {
        QVERIFY2(!folder.startsWith('.') && !folder.contains('\\') && !folder.contains('\n'),
                 qPrintable(folder));
        QCOMPARE(filesIn(out() + "/held-out/" + folder), QStringList({"constant.json", "linear.json"}));
        left.insert(jsonOf(out() + "/held-out/" + folder + "/linear.json")["trained_on"].dump());
    }
    QCOMPARE(left.size(), static_cast<std::size_t>(names.size()));
    QCOMPARE(filesIn(out()),
             QStringList({"comparison.csv", "comparison.json", "comparison.md", "held-out", "models",
                          "recommendation.json", "recommendation.txt", "request.json"}));
}

void TestCliFit::fit_refused_keepsTheEarlierResult()
{
    QCOMPARE(fit(runs(2), out()).exitCode, 0);
    const QByteArray comparison = bytesOf(out() + "/comparison.json");
    const QStringList files = filesBelow(out());
    writeBytes(m_folder->filePath("empty.csv"), "");
    QCOMPARE(fit({run(1), m_folder->filePath("empty.csv")}, out()).exitCode,
             static_cast<int>(Errc::FileEmpty));
    QCOMPARE(filesBelow(out()), files);
    QCOMPARE(bytesOf(out() + "/comparison.json"), comparison);
}

void TestCliFit::fit_interrupted_leavesNothing_data()
{
    QTest::addColumn<int>("signalNumber");
    QTest::newRow("SIGINT") << SIGINT;
    QTest::newRow("SIGTERM") << SIGTERM;
}

void TestCliFit::fit_interrupted_leavesNothing()
{
    QFETCH(int, signalNumber);
    QProcess process;
    process.start(cliPath(), QStringList{"fit", "--out", out() + "/below"} + runs(12)); // takes seconds
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(out() + "/below"), 30000);
    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signalNumber), 0);
    const Outcome outcome = finish(process);
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::Cancelled));
    QVERIFY2(isOneSentence(outcome.errors), outcome.errors.constData());
    QCOMPARE(outcome.output, QByteArray());
    QVERIFY(!QFile::exists(out()));
}

void TestCliFit::chamber_leaveOneRunOut_isYesOnYOnly()
{
    REQUIRE_SHARED_DATA(first, "climate_chamber/run1_cooling.csv");
    const Outcome outcome = fit(chamberRuns(first), out(), {});
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    const Json comparison = jsonOf(out() + "/comparison.json");
    QVERIFY2(pooledRmsDps(comparison, "rbf", "y") <= 0.10,
             std::to_string(pooledRmsDps(comparison, "rbf", "y")).c_str());
    QVERIFY(pooledRmsDps(comparison, "cubic", "y") <= 0.10);
    const Json verdicts = jsonOf(out() + "/recommendation.json");
    const std::array<std::string, 3> expected{"not repeatable", "yes", "not repeatable"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        QCOMPARE(verdicts[axis]["axis"].get<std::string>(), std::string(1, "xyz"[axis]));
        QCOMPARE(verdicts[axis]["verdict"].get<std::string>(), expected[axis]);
    }
    QCOMPARE(verdicts[0]["model"].get<std::string>(), std::string("constant"));
    QVERIFY(verdicts[1]["model"] != "constant");
    QVERIFY(verdicts[1]["gain"].get<double>() > 0.99);
    QVERIFY(std::abs(verdicts[1]["gain_model_free"].get<double>() - 0.993) < 0.001);
    // At 40 degrees the runs read these.
    const std::string reason = verdicts[0]["reason"].get<std::string>();
    for (const char *figure : {"\u22123.99", "\u22124.21", "\u22123.42"})
        QVERIFY2(reason.find(figure) != std::string::npos, reason.c_str());
}

void TestCliFit::chamber_asOneRun_isNeverBetterThanWithCare_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QStringList>("options");
    QTest::newRow("chamber_all") << "climate_chamber/chamber_all.csv" << QStringList();
    QTest::newRow("as published") << "climate_chamber/raw_as_published.tsv"
                                  << QStringList{"--rate-unit", "rad/s",       "--time-unit",
                                                 "us",          "--separator", "tab"};
    QTest::newRow("as published, its spelling")
        << "climate_chamber/raw_as_published.tsv" << QStringList{"--rate-unit", "rad/s"};
}

void TestCliFit::chamber_asOneRun_isNeverBetterThanWithCare()
{
    QFETCH(const QString, file);
    QFETCH(const QStringList, options);
    REQUIRE_SHARED_DATA(log, file.toUtf8().constData());
    const Outcome outcome = fit({QString::fromStdString(log.string())}, out(),
                                QStringList{"--models", "constant,linear,cubic,rbf"} + options);
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    const Json comparison = jsonOf(out() + "/comparison.json");
    QCOMPARE(runsJudged(comparison).size(), std::size_t{5});
    for (const auto &verdict : comparison["verdicts"])
        QVERIFY(verdict["verdict"] != "yes");
    QCOMPARE(comparison["verdicts"][1]["verdict"].get<std::string>(), std::string("with care"));
    // Samples of the same sweep are near each other whatever is held out: better than on whole runs.
    QVERIFY(pooledRmsDps(comparison, "rbf", "y") < 0.08);
    QVERIFY(outcome.output.contains("only one run"));
}

void TestCliFit::dataflash_smallSpan_isRefusedUnlessForced()
{
    REQUIRE_SHARED_DATA(log, "dataflash_warmup/log171.bin");
    const QStringList file{QString::fromStdString(log.string())};
    const Outcome unchosen = fit(file, out());
    QCOMPARE(unchosen.exitCode, static_cast<int>(Errc::NoSuchInstance));
    QVERIFY(unchosen.errors.contains("--instance N"));
    const QStringList chosen{"--models", "constant,linear", "--instance", "2"};
    const Outcome refused = fit(file, out(), chosen);
    QCOMPARE(refused.exitCode, static_cast<int>(Errc::SpanTooSmall));
    QVERIFY2(isOneSentence(refused.errors) && refused.errors.contains("at least 10 °C"),
             refused.errors.constData());
    QVERIFY(!QFile::exists(out()));
    const Outcome forced = fit(file, out(), chosen + QStringList{"--force-span"});
    QCOMPARE(forced.exitCode, 0);
    const Json facts = jsonOf(out() + "/comparison.json")["runs"][0];
    QCOMPARE(facts["instance"].get<int>(), 2);
    QVERIFY(facts["masked"]["motion"].get<int>() > facts["samples"].get<int>() / 2);
    QVERIFY(forced.errors.contains("The gyro moved"));
}

void TestCliFit::noDriftControl_hasNoDriftAndNoExport()
{
    REQUIRE_SHARED_DATA(log, "no_drift_control/astropi_2015_sensehat.csv");
    const QStringList file{QString::fromStdString(log.string())};
    QCOMPARE(fit(file, out()).exitCode, static_cast<int>(Errc::SpanTooSmall));
    const Outcome outcome = fit(file, out(), {"--force-span"});
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    for (const auto &verdict : jsonOf(out() + "/recommendation.json")) {
        QCOMPARE(verdict["verdict"].get<std::string>(), std::string("no drift"));
        QVERIFY(verdict["reason"].get<std::string>().find("no temperature drift") != std::string::npos);
    }
    const QString table = m_folder->filePath("table.csv");
    const Outcome exported =
        runCli({"export", "--model", out() + "/models/auto.json", "--format", "csv", "--out", table});
    QCOMPARE(exported.exitCode, static_cast<int>(Errc::VerdictForbids));
    QVERIFY2(isOneSentence(exported.errors) && exported.errors.contains("--force"),
             exported.errors.constData());
    QVERIFY(!QFile::exists(table));
}

QTEST_GUILESS_MAIN(TestCliFit)
#include "tst_cli_fit.moc"
