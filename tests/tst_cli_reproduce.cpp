#include "engine/base/axes.h"
#include "engine/physics/gyro_simulator.h"
#include "engine/physics/sensor_presets.h"
#include "support/cli_process.h"

#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <csignal>

using namespace driftbench;
using namespace driftbench::test;
using Json = nlohmann::json;

class TestCliReproduce : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();

    void reproduce_text_saysThatItIsSimulatedBeforeAnyFigure();
    void reproduce_text_fitsTheTerminalAndItsColumnsAlign();
    void reproduce_text_marksExactlyTheCellsThatDoNotAgree();
    void reproduce_json_hasAllTables();
    void reproduce_json_simulatedColumnsFollowFromTheirMsds();
    void reproduce_json_lineIsThatOfPlainLeastSquares();
    void reproduce_csv_isALineACell();
    void reproduce_markdown_hasATableOfEachNumber();
    void reproduce_oneTable_hasTheFiguresOfAll();
    void reproduce_otherSeed_hasOtherFigures();
    void reproduce_checkOnly_hasNoSimulatedFigure();
    void reproduce_badOption_saysItInOneSentence_data();
    void reproduce_badOption_saysItInOneSentence();
    void reproduce_folderBelowAFile_isRefused();
    void reproduce_interrupted_leavesNothing();
    void help_fitsATerminalAndHasAnExample();

private:
    QTemporaryDir m_folder;
    QByteArray m_text;
    Json m_json; // of the same run
};

namespace {

QList<QByteArray> linesOf(const QByteArray &text)
{
    return text.split('\n');
}

const Json &rowOf(const Json &all, int table, std::size_t row)
{
    for (const Json &candidate : all["tables"]) {
        if (candidate["number"] == table)
            return candidate["rows"][row];
    }
    qFatal("no table %d", table);
}

// Sums of a straight line through samples, for the runs together and one by one.
struct LineSums
{
    double n = 0.0, t = 0.0, tt = 0.0, y = 0.0, ty = 0.0, yy = 0.0;

    void add(const LineSums &other)
    {
        n += other.n;
        t += other.t;
        tt += other.tt;
        y += other.y;
        ty += other.ty;
        yy += other.yy;
    }
};

LineSums sumsOf(const Recording &recording, double referenceRateDps, int axis)
{
    LineSums sums;
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        const double t = recording.temperatureC[i];
        const double y = recording.rateDps(i, axis) - referenceRateDps;
        sums.add({1.0, t, t * t, y, t * y, y * y});
    }
    return sums;
}

// Mean square of y - a - b t on one run, a and b from others.
double msdOnUnseen(const LineSums &run, const LineSums &others)
{
    const double b =
        (others.n * others.ty - others.t * others.y) / (others.n * others.tt - others.t * others.t);
    const double a = (others.y - b * others.t) / others.n;
    return (run.yy - 2.0 * a * run.y - 2.0 * b * run.ty + a * a * run.n + 2.0 * a * b * run.t +
            b * b * run.tt) /
           run.n;
}

} // namespace

void TestCliReproduce::initTestCase()
{
    QVERIFY(m_folder.isValid());
    const Outcome outcome = runCli({"reproduce", "--out", m_folder.filePath("tables")});
    QCOMPARE(outcome.errors, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    m_text = outcome.output;
    QCOMPARE(filesIn(m_folder.filePath("tables")), QStringList({"tables.csv", "tables.json", "tables.md"}));
    m_json = Json::parse(bytesOf(m_folder.filePath("tables/tables.json")).toStdString());
}

void TestCliReproduce::reproduce_text_saysThatItIsSimulatedBeforeAnyFigure()
{
    const qsizetype said = m_text.indexOf("simulated data");
    QVERIFY(said >= 0 && said < m_text.indexOf("Table 1."));
    const qsizetype unseen = m_text.indexOf("trained on the other four runs only");
    QVERIFY(unseen >= 0 && unseen < m_text.indexOf("Table 1."));
    QVERIFY(m_json["simulated"].get<bool>());
}

void TestCliReproduce::reproduce_text_fitsTheTerminalAndItsColumnsAlign()
{
    int rows = 0;
    qsizetype width = 0;
    for (const QByteArray &bytes : linesOf(m_text)) {
        const QString line = QString::fromUtf8(bytes);
        QVERIFY2(line.size() <= 120, bytes.constData());
        QVERIFY2(!line.endsWith(' '), bytes.constData());
        if (line.startsWith("Table "))
            width = 0;
        if (!line.contains(" printed ") || !line.contains('e'))
            continue;
        // Every last column ends where that of the other rows of the table does, but for the mark.
        if (line.size() > 90 && line.contains("e-")) {
            const qsizetype own = line.endsWith('*') ? line.size() - 1 : line.size();
            QVERIFY2(width == 0 || own == width, bytes.constData());
            width = own;
            ++rows;
        }
    }
    QCOMPARE(rows, 15);
}

void TestCliReproduce::reproduce_text_marksExactlyTheCellsThatDoNotAgree()
{
    qsizetype marks = 0;
    for (const QByteArray &line : linesOf(m_text.left(m_text.indexOf("Arithmetic of")))) {
        if (line.contains(" printed "))
            marks += line.count('*');
    }
    qsizetype disagreeing = 0;
    for (const Json &check : m_json["checks"])
        disagreeing += check["agreement"] == "no" ? 1 : 0;
    QCOMPARE(disagreeing, qsizetype{3});
    QCOMPARE(marks, disagreeing);
    QVERIFY(m_text.contains("24.91*"));
    QVERIFY(m_text.contains("Table 4, z, |Q4-Q3|/Q3               24.91       18.93"));
}

void TestCliReproduce::reproduce_json_hasAllTables()
{
    QCOMPARE(m_json["tables"].size(), std::size_t{6});
    QCOMPARE(m_json["tables"][0]["rows"].size(), std::size_t{5});
    for (std::size_t table = 1; table < 6; ++table)
        QCOMPARE(m_json["tables"][table]["rows"].size(), std::size_t{3});
    QCOMPARE(m_json["checks"].size(), std::size_t{105});
    QCOMPARE(m_json["statements"].size(), std::size_t{6});
    QCOMPARE(rowOf(m_json, 6, 2)["printed"]["MSD1"].get<double>(), 0.6588);
    QVERIFY(!m_json["findings_of_simulation"].empty());
    QVERIFY(m_json["experiments"][1]["reference_rate_dps"] == Json::parse("[25.0, 5.0, 53.0]"));
}

void TestCliReproduce::reproduce_json_simulatedColumnsFollowFromTheirMsds()
{
    for (const Json &table : m_json["tables"]) {
        for (const Json &row : table["rows"]) {
            for (const char *novel : {"rbf-paper", "rbf"}) {
                const Json &ours = row["simulated"][novel];
                const bool first = table["number"] == 1;
                const double before = ours["MSD1"];
                const double conventional = ours[first ? "MSD2" : "MSD5"];
                const double last = ours[first ? "MSD3" : "MSD6"];
                QVERIFY(std::abs(ours[first ? "Q2" : "Q5"].get<double>() * before / last - 1.0) < 1e-12);
                const double better = ours[first ? "|Q2-Q1|/Q1" : "|Q5-Q4|/Q4"];
                QVERIFY(std::abs(better - 100.0 * (1.0 - last / conventional)) < 1e-9);
            }
        }
    }
}

void TestCliReproduce::reproduce_json_lineIsThatOfPlainLeastSquares()
{
    const Eigen::Vector3d referenceRateDps(25.0, 5.0, 53.0);
    auto options = presetSimulation("I3G4250D", referenceRateDps);
    QVERIFY(options.ok());
    options->seed = m_json["experiments"][1]["seed"].get<std::uint64_t>();
    std::vector<Recording> runs;
    for (int run = 0; run < 5; ++run)
        runs.push_back(*simulateRun(*options, run));
    for (int axis = 0; axis < kAxisCount; ++axis) {
        std::vector<LineSums> sums;
        for (const Recording &run : runs)
            sums.push_back(sumsOf(run, referenceRateDps[axis], axis));
        for (std::size_t unseen = 0; unseen < runs.size(); ++unseen) {
            LineSums others;
            for (std::size_t run = 0; run < runs.size(); ++run) {
                if (run != unseen)
                    others.add(sums[run]);
            }
            const Json &ours = rowOf(m_json, static_cast<int>(unseen) + 2,
                                     static_cast<std::size_t>(axis))["simulated"]["rbf-paper"];
            const double before = sums[unseen].yy / sums[unseen].n;
            const double line = msdOnUnseen(sums[unseen], others);
            // Training works on cells of 0.02 degrees and leaves outliers of the noise out.
            QVERIFY(std::abs(ours["MSD1"].get<double>() / before - 1.0) < 1e-9);
            QVERIFY2(std::abs(ours["MSD4"].get<double>() / line - 1.0) < 1e-4,
                     qPrintable(QString::number(line)));
        }
    }
}

void TestCliReproduce::reproduce_csv_isALineACell()
{
    const QList<QByteArray> lines = linesOf(bytesOf(m_folder.filePath("tables/tables.csv")));
    QCOMPARE(lines.size(), qsizetype{1 + 5 * 6 + 15 * 10 + 1});
    for (const QByteArray &line : lines.first(lines.size() - 1))
        QCOMPARE(line.count(','), qsizetype{11});
    QVERIFY(lines[1].startsWith("1,1,x,MSD1,dps^2,9.5552,"));
    QVERIFY(std::any_of(lines.begin(), lines.end(), [](const QByteArray &line) {
        return line.startsWith("4,3,z,|Q5-Q4|/Q4,%,1.92,5.72687") && line.contains(",no,");
    }));
}

void TestCliReproduce::reproduce_markdown_hasATableOfEachNumber()
{
    const QByteArray markdown = bytesOf(m_folder.filePath("tables/tables.md"));
    for (int number = 1; number <= 6; ++number)
        QVERIFY(markdown.contains("\nTable " + QByteArray::number(number) + ". "));
    QVERIFY(markdown.contains("| 3.5555 × 10⁻² |"));
    QVERIFY(markdown.contains("simulated data"));
    // Every line of a table has as many bars as its head; escaped ones are text.
    qsizetype bars = 0;
    for (QByteArray line : linesOf(markdown)) {
        const qsizetype own = line.replace("\\|", "").count('|');
        QVERIFY2(own == 0 || bars == 0 || own == bars, line.constData());
        bars = own;
    }
}

void TestCliReproduce::reproduce_oneTable_hasTheFiguresOfAll()
{
    const Outcome outcome = runCli({"reproduce", "--tables", "1", "--json"});
    QCOMPARE(outcome.errors, QByteArray());
    const Json one = Json::parse(outcome.output.toStdString());
    QCOMPARE(one["tables"].size(), std::size_t{1});
    QVERIFY(one["tables"][0] == m_json["tables"][0]);
}

void TestCliReproduce::reproduce_otherSeed_hasOtherFigures()
{
    const Outcome outcome = runCli({"reproduce", "--tables", "1", "--json", "--seed", "7"});
    const Json other = Json::parse(outcome.output.toStdString());
    QCOMPARE(other["experiments"][0]["seed"].get<int>(), 7);
    for (std::size_t row = 0; row < 5; ++row) {
        QVERIFY(rowOf(other, 1, row)["printed"] == rowOf(m_json, 1, row)["printed"]);
        QVERIFY(rowOf(other, 1, row)["simulated"] != rowOf(m_json, 1, row)["simulated"]);
    }
}

void TestCliReproduce::reproduce_checkOnly_hasNoSimulatedFigure()
{
    const Outcome text = runCli({"reproduce", "--check-only"});
    QCOMPARE(text.errors, QByteArray());
    QVERIFY(!text.output.contains("imulated"));
    QVERIFY(m_text.contains(text.output)); // the same part as in the whole
    const Json json = Json::parse(runCli({"reproduce", "--check-only", "--json"}).output.toStdString());
    QVERIFY(!json["simulated"].get<bool>());
    QVERIFY(json["checks"] == m_json["checks"]);
    QVERIFY(!json["tables"][0]["rows"][0].contains("simulated"));
    const Json some = Json::parse(
        runCli({"reproduce", "--check-only", "--json", "--tables", "6,2-3"}).output.toStdString());
    QCOMPARE(some["tables"].size(), std::size_t{3});
    QCOMPARE(some["checks"].size(), std::size_t{3 * 18});
    QVERIFY(some["statements"].empty());
}

void TestCliReproduce::reproduce_badOption_saysItInOneSentence_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const QStringList &arguments, const QByteArray &says) {
        QTest::newRow(qPrintable(arguments.join(' '))) << arguments << says;
    };
    for (const char *tables : {"0", "7", "2-", "-3", "5-3", "1,,2", "one", "1-9", "", "1 2"})
        row({"--tables", tables}, "--tables");
    row({"--seed", "-1"}, "--seed");
    row({"--runs", "3"}, "--runs");
    row({"--check-only", "--out", "folder"}, "--check-only");
}

void TestCliReproduce::reproduce_badOption_saysItInOneSentence()
{
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, says);
    const Outcome outcome = runCli(QStringList{"reproduce"} + arguments);
    QCOMPARE(outcome.exitCode, 2);
    QVERIFY2(isOneSentence(outcome.errors), outcome.errors.constData());
    QVERIFY2(outcome.errors.contains(says), outcome.errors.constData());
    QCOMPARE(outcome.output, QByteArray());
}

void TestCliReproduce::reproduce_folderBelowAFile_isRefused()
{
    const QString file = m_folder.filePath("file");
    writeBytes(file, "text");
    const Outcome outcome = runCli({"reproduce", "--out", file + "/tables"});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::OutputNotWritable));
    QVERIFY(isOneSentence(outcome.errors));
}

void TestCliReproduce::reproduce_interrupted_leavesNothing()
{
    const QString folder = m_folder.filePath("interrupted");
    QProcess process;
    process.start(cliPath(), {"reproduce", "--out", folder});
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(folder), 30000);
    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
    const Outcome outcome = finish(process);
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::Cancelled));
    QVERIFY(isOneSentence(outcome.errors));
    QCOMPARE(outcome.output, QByteArray());
    QVERIFY(!QFileInfo::exists(folder));
}

void TestCliReproduce::help_fitsATerminalAndHasAnExample()
{
    const Outcome outcome = runCli({"reproduce", "--help"});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(outcome.output.contains("Example:\n  driftbench-cli reproduce"));
    for (const QByteArray &line : linesOf(outcome.output))
        QVERIFY2(QString::fromUtf8(line).size() <= 80, line.constData());
    QVERIFY(runCli({"--help"}).output.contains("\n  reproduce"));
}

QTEST_GUILESS_MAIN(TestCliReproduce)
#include "tst_cli_reproduce.moc"
