#include "support/cli_process.h"
#include "support/test_data.h"

#include <QFile>
#include <QTemporaryDir>

using namespace driftbench;
using namespace driftbench::test;

// driftbench-report on what a fit left.
class TestCliReport : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();

    void report_simulatedFit_hasEveryFigureAndSaysSimulated();
    void report_sameFitTwice_isTheSame();
    void report_folderOfNoFit_isRefused();
    void report_runGone_namesIt();
    void report_unknownOption_isAUsageError();

private:
    Outcome report(const QStringList &arguments) const;

    QTemporaryDir m_folder;
};

Outcome TestCliReport::report(const QStringList &arguments) const
{
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.start(driftbench::test::programFolder() + "/driftbench-report", arguments);
    return finish(process);
}

void TestCliReport::initTestCase()
{
    simulateQuietly(m_folder.filePath("runs"), {"--runs", "3"});
    const QString runs = m_folder.filePath("runs/run");
    const Outcome fit = runCli({"fit", runs + "1.csv", runs + "2.csv", runs + "3.csv", "--out",
                                m_folder.filePath("fit"), "--models", "constant,linear,cubic,rbf"});
    QVERIFY2(fit.exitCode == 0, fit.errors);
}

void TestCliReport::report_simulatedFit_hasEveryFigureAndSaysSimulated()
{
    const Outcome outcome = report({"fit", "--out", "report"});
    QVERIFY2(outcome.exitCode == 0, outcome.errors);
    const QStringList files = filesIn(m_folder.filePath("report"));
    for (const char *figure :
         {"fig7_tcq_over_time", "fig8_tcq_against_tde_x", "fig8_tcq_against_tde_y", "fig8_tcq_against_tde_z",
          "fig10_before_after_run1", "fig10_before_after_run3", "residuals", "allan_run1", "centres"}) {
        for (const char *ending : {".svg", ".pdf", ".png"})
            QVERIFY2(files.contains(QString(figure) + ending), figure);
    }
    const QByteArray page = bytesOf(m_folder.filePath("report/index.html"));
    QVERIFY(page.contains("Simulated data"));
    QVERIFY(page.contains("fig10_before_after_run2.svg"));
    const QByteArray figure = bytesOf(m_folder.filePath("report/residuals.svg"));
    QVERIFY(figure.contains("Simulated data"));
    QVERIFY(figure.contains("Residual (dps)"));
}

void TestCliReport::report_sameFitTwice_isTheSame()
{
    QCOMPARE(report({"fit", "--out", "first"}).exitCode, 0);
    QCOMPARE(report({"fit", "--out", "second"}).exitCode, 0);
    for (const char *file : {"index.html", "fig8_tcq_against_tde_y.svg", "centres.png"}) {
        QVERIFY2(bytesOf(m_folder.filePath("first/") + file) == bytesOf(m_folder.filePath("second/") + file),
                 file);
    }
}

void TestCliReport::report_folderOfNoFit_isRefused()
{
    const Outcome outcome = report({"runs", "--out", "nothing"});
    QCOMPARE(outcome.exitCode, 10);
    QVERIFY2(outcome.errors.contains("comparison.json"), outcome.errors);
    QVERIFY(!QFile::exists(m_folder.filePath("nothing")));
}

void TestCliReport::report_runGone_namesIt()
{
    const QString run = m_folder.filePath("runs/run2.csv");
    QVERIFY(QFile::rename(run, run + ".away"));
    const Outcome outcome = report({"fit", "--out", "nothing"});
    QVERIFY(QFile::rename(run + ".away", run));
    QCOMPARE(outcome.exitCode, 10);
    QVERIFY2(outcome.errors.contains("run2.csv"), outcome.errors);
    QVERIFY(!QFile::exists(m_folder.filePath("nothing")));
}

void TestCliReport::report_unknownOption_isAUsageError()
{
    const Outcome outcome = report({"fit", "--out", "nothing", "--colour"});
    QCOMPARE(outcome.exitCode, 2);
    QVERIFY2(outcome.errors.contains("--help"), outcome.errors);
}

QTEST_APPLESS_MAIN(TestCliReport)
#include "tst_cli_report.moc"
