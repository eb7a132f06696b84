// The report of a calibration: that it says everything, in both forms, and says where its data come from.
#include "app/report/report_data_loader.h"
#include "app/report/report_document.h"
#include "app/report/report_html.h"
#include "app/report/report_pdf.h"
#include "engine/base/text.h"
#include "support/session_runs.h"

#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <cmath>

using namespace driftbench;
using namespace driftbench::test;

class TestReportDocument : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void document_facts_areThoseOfTheData();
    void document_tables_holdEveryRowOfTheComparison();
    void document_germanLocale_writesNumbersAsFilesDo();
    void html_isOneFileWithItsFiguresInside();
    void html_hostileNames_areEscaped();
    void pdf_hasPagesTextAndVectors();
    void real_neverSaysSimulated();

private:
    std::shared_ptr<ReportData> m_data;
    ReportDocument m_document;
};

static const QDateTime kMade(QDate(2026, 5, 4), QTime(10, 11, 12));

void TestReportDocument::initTestCase()
{
    QTemporaryDir folder;
    auto session = Session::create(folder.filePath("r.driftbench").toStdString());
    QVERIFY(session.ok());
    addRuns(**session, 3);
    CalibrationPlan plan = (*session)->plan();
    plan.models = {"constant", "linear", "cubic", "rbf"};
    plan.limitRmsDps = 0.3;
    QVERIFY((*session)->editPlan(plan, "models").ok());
    const auto runs = loadRuns((*session)->file(), (*session)->plan(), {});
    QVERIFY(runs.ok());
    const auto prepared = prepareCampaign((*session)->plan(), *runs);
    QVERIFY(prepared.ok() && !prepared->refusal);
    const auto result = calibrate(*prepared);
    QVERIFY2(result.ok(), result.ok() ? "" : result.error().message.c_str());
    m_data = std::make_shared<ReportData>(reportDataOf(*prepared, *result));
    const auto document = completeReport(m_data, kMade);
    QVERIFY(document.ok());
    m_document = *document;
}

void TestReportDocument::document_facts_areThoseOfTheData()
{
    QString facts;
    for (const auto &[name, value] : m_document.facts)
        facts += name + QLatin1Char('=') + value + QLatin1Char('\n');
    for (const char *wanted :
         {"L3GD20H T-1", "Simulated data", "2026-05-04T10:11:12", "0.300 dps", "Absolute"})
        QVERIFY2(facts.contains(QString::fromUtf8(wanted)), qPrintable(facts));
    QCOMPARE(m_document.cards.size(), std::size_t(3));
    for (const ReportCard &card : m_document.cards)
        QVERIFY(!card.word.isEmpty() && !card.text.isEmpty() && !card.details.isEmpty());
    // Quantities over time, three axes, three runs before and after, residuals, three judged, centres.
    QCOMPARE(m_document.figures.size(), std::size_t(1 + 3 + 3 + 1 + 3 + 1));
}

void TestReportDocument::document_tables_holdEveryRowOfTheComparison()
{
    const TableGrid &grid = m_document.tables.front().grid;
    QCOMPARE(grid.rows.size(), std::size_t(9));
    const auto novel = static_cast<std::size_t>(grid.heads.indexOf(QStringLiteral("MSD6 Novel")));
    for (const auto &row : grid.rows) {
        const auto exact = parseNumber(row[novel].exact.toStdString());
        QVERIFY(exact.has_value());
        const bool known =
            std::any_of(m_data->rows.begin(), m_data->rows.end(), [&](const ComparisonRow &each) {
                return each.model == "rbf" && each.msdAfter == *exact;
            });
        QVERIFY(known);
    }
    const TableGrid &runs = m_document.tables.back().grid;
    QCOMPARE(runs.rows.size(), std::size_t(3));
}

void TestReportDocument::document_germanLocale_writesNumbersAsFilesDo()
{
    QLocale::setDefault(QLocale(QLocale::German));
    const ReportDocument document = reportDocument(*m_data, kMade);
    QCOMPARE(QLocale().language(), QLocale::German); // as it was
    QLocale::setDefault(QLocale::c());
    for (std::size_t row = 0; row < document.tables.front().grid.rows.size(); ++row) {
        for (std::size_t column = 0; column < document.tables.front().grid.rows[row].size(); ++column)
            QCOMPARE(document.tables.front().grid.rows[row][column].shown,
                     m_document.tables.front().grid.rows[row][column].shown);
    }
}

void TestReportDocument::html_isOneFileWithItsFiguresInside()
{
    const QString html = QString::fromUtf8(reportAsHtml(m_document, lightPalette()));
    QCOMPARE(html.count(QStringLiteral("<svg")), static_cast<qsizetype>(m_document.figures.size()));
    QVERIFY(!html.contains(QStringLiteral("<img")) && !html.contains(QStringLiteral("<script")));
    QVERIFY(!html.contains(QRegularExpression(QStringLiteral("(src|href)=\"(?!#)"))));
    QVERIFY(html.contains(QStringLiteral("Simulated data")));
    QCOMPARE(html.count(QStringLiteral("<table")), 4);
    for (const ReportFigure &figure : m_document.figures) {
        QVERIFY(html.contains(figure.title.toHtmlEscaped()));
        QVERIFY(figure.svg.contains("Simulated data"));
        QXmlStreamReader xml(figure.svg);
        while (!xml.atEnd())
            xml.readNext();
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    }
}

void TestReportDocument::html_hostileNames_areEscaped()
{
    ReportData data = *m_data;
    data.sensor = "<script>alert(1)</script>";
    data.facts.front().file = "a&b\"<i>.csv";
    const QString html = QString::fromUtf8(reportAsHtml(reportDocument(data, kMade), lightPalette()));
    QVERIFY(!html.contains(QStringLiteral("<script>")) && !html.contains(QStringLiteral("<i>")));
    QVERIFY(html.contains(QStringLiteral("a&amp;b")));
}

void TestReportDocument::pdf_hasPagesTextAndVectors()
{
    const QByteArray pdf = reportAsPdf(m_document);
    QVERIFY(pdf.startsWith("%PDF"));
    QVERIFY(pdf.count("/Type /Page\n") + pdf.count("/Type /Page ") >= 5);
    QVERIFY(!pdf.contains("/DCTDecode")); // no picture of pixels
    QVERIFY(pdf.size() > 50000 && pdf.size() < 20000000);
    const QString reader = QStandardPaths::findExecutable(QStringLiteral("pdftotext"));
    if (reader.isEmpty())
        QSKIP("pdftotext is not installed: the text of the PDF was not read back");
    QTemporaryDir folder;
    QFile file(folder.filePath("r.pdf"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(pdf);
    file.close();
    QProcess process;
    process.start(reader, {"-layout", file.fileName(), "-"});
    QVERIFY(process.waitForFinished());
    const QString text = QString::fromUtf8(process.readAllStandardOutput());
    for (const char *wanted :
         {"L3GD20H T-1", "Simulated data", "MSD6", "Averaging time", "Parameters", "Page 2"})
        QVERIFY2(text.contains(QString::fromUtf8(wanted)), wanted);
}

void TestReportDocument::real_neverSaysSimulated()
{
    ReportData data = *m_data;
    data.simulated = false;
    const ReportDocument document = reportDocument(data, kMade);
    QCOMPARE(document.origin, QStringLiteral("Real log"));
    QVERIFY(!document.title.contains(QStringLiteral("simulated")));
}

QTEST_MAIN(TestReportDocument)
#include "tst_report_document.moc"
