// The page Compare on real comparisons, and the reports that it writes.
#include "app/gui/compare/report_writer.h"
#include "app/gui/pages/compare_page.h"
#include "engine/formats/log_reader.h"
#include "support/gui_bench.h"
#include "support/test_data.h"
#include "widgets/controls/banner_slot.h"
#include "widgets/tables/data_table.h"
#include "widgets/views/judged_run_view.h"
#include "widgets/views/verdict_card.h"

#include <QFile>

using namespace driftbench;
using namespace driftbench::test;

class TestGuiCompare : public QObject
{
    Q_OBJECT

private slots:
    void page_withoutModels_saysWhatToDo();
    void page_judged_showsEveryRunAndFigure();
    void limit_changed_judgesAnewWithoutTraining();
    void judging_changed_trainsAgain();
    void report_pdfAndHtml_areWritten();
    void report_cancelled_writesNothing();
    void chamberLog_verdicts_sayNoYesAndWhy();
};

static const std::vector<std::string> kFast{"constant", "linear", "cubic", "rbf"};

static bool hasTraces(const ComparePage &page)
{
    return QTest::qWaitFor([&page] { return !page.plots().isEmpty(); }, 30000);
}

static QString cell(const ComparePage &page, int row, const QString &head)
{
    const QAbstractItemModel &model = *page.table().model();
    for (int column = 0; column < model.columnCount(); ++column) {
        if (model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().startsWith(head))
            return model.index(row, column).data().toString();
    }
    return {};
}

void TestGuiCompare::page_withoutModels_saysWhatToDo()
{
    GuiBench bench(2);
    ComparePage page(*bench.context);
    showPage(page);
    QVERIFY(!page.stepState().holds);
    QVERIFY(page.plots().isEmpty());
    page.writeReport(bench.folder.filePath("none.pdf").toStdString());
    QVERIFY(page.banners().holds(QStringLiteral("report")));
    QVERIFY(!QFile::exists(bench.folder.filePath("none.pdf")));
}

void TestGuiCompare::page_judged_showsEveryRunAndFigure()
{
    GuiBench bench(3);
    bench.setModels(kFast);
    ComparePage page(*bench.context);
    showPage(page);
    QVERIFY(bench.train());
    QVERIFY(hasTraces(page));
    QCOMPARE(page.origin(), Origin::Simulated);
    QCOMPARE(page.table().model()->rowCount(), 3);
    for (int run = 0; run < 3; ++run) {
        QTest::keyClick(&page, Qt::Key(Qt::Key_1 + run));
        page.chooseRun(run);
        QCOMPARE(page.run(), run);
        QCOMPARE(page.table().model()->headerData(0, Qt::Horizontal, Qt::DisplayRole).toString(),
                 QStringLiteral("run %1").arg(run + 1));
    }
    for (int axis = 0; axis < 3; ++axis)
        QVERIFY2(page.card(axis).accessibleName().contains(QStringLiteral("dps rms")),
                 qPrintable(page.card(axis).accessibleName()));
}

void TestGuiCompare::limit_changed_judgesAnewWithoutTraining()
{
    GuiBench bench(3);
    bench.setModels(kFast);
    ComparePage page(*bench.context);
    showPage(page);
    QVERIFY(bench.train());
    const auto result = bench.session().result();
    page.setLimit(100.0);
    QCOMPARE(bench.session().result(), result);
    QCOMPARE(cell(page, 0, QStringLiteral("Limit")), QStringLiteral("Pass"));
    QVERIFY(page.card(0).accessibleName().contains(QStringLiteral("Yes")));
    page.setLimit(1e-3);
    QCOMPARE(bench.session().result(), result);
    QCOMPARE(cell(page, 0, QStringLiteral("Limit")), QStringLiteral("Fail"));
    QVERIFY(page.card(0).accessibleName().contains(QStringLiteral("over the limit of 0.001")));
    QCOMPARE(page.stepState().mark, StepMark::Warning);
    page.setLimit(0.0);
    QVERIFY(!bench.session().plan().limitRmsDps);
}

void TestGuiCompare::judging_changed_trainsAgain()
{
    GuiBench bench(2);
    bench.setModels({"constant", "linear", "rbf"});
    ComparePage page(*bench.context);
    showPage(page);
    QVERIFY(bench.train());
    QAbstractButton *anchored = nullptr;
    for (QAbstractButton *button : page.findChildren<QAbstractButton *>()) {
        if (button->text() == QStringLiteral("Anchored"))
            anchored = button;
    }
    QVERIFY(anchored != nullptr);
    anchored->click();
    QCOMPARE(bench.session().plan().judging, Judging::Anchored);
    QVERIFY(QTest::qWaitFor([&] { return bench.session().result() != nullptr; }, kTrainingPatienceMs));
    QCOMPARE(bench.session().result()->figures.judging, std::string("anchored"));
}

static QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void TestGuiCompare::report_pdfAndHtml_areWritten()
{
    GuiBench bench(2);
    bench.setModels({"constant", "linear", "rbf"});
    ComparePage page(*bench.context);
    showPage(page);
    QVERIFY(bench.train());
    for (const char *name : {"report.pdf", "report.html"}) {
        QSignalSpy finished(&page.reports(), &ReportWriter::finished);
        page.writeReport(bench.folder.filePath(name).toStdString());
        QVERIFY(page.reports().isRunning());
        QVERIFY(QTest::qWaitFor([&] { return !finished.isEmpty(); }, kTrainingPatienceMs));
        const QByteArray bytes = bytesOf(bench.folder.filePath(name));
        QVERIFY2(bytes.size() > 10000, name);
    }
    QVERIFY(bytesOf(bench.folder.filePath("report.pdf")).startsWith("%PDF"));
    const QString html = QString::fromUtf8(bytesOf(bench.folder.filePath("report.html")));
    QVERIFY(html.contains(QStringLiteral("Simulated data")) && html.contains(QStringLiteral("L3GD20H T-1")));
    QVERIFY(html.count(QStringLiteral("<svg")) >= 7);
}

void TestGuiCompare::report_cancelled_writesNothing()
{
    GuiBench bench(2);
    bench.setModels({"constant", "linear"});
    ComparePage page(*bench.context);
    showPage(page);
    QVERIFY(bench.train());
    QSignalSpy finished(&page.reports(), &ReportWriter::finished);
    page.writeReport(bench.folder.filePath("cut.pdf").toStdString());
    page.reports().cancel();
    QVERIFY(QTest::qWaitFor([&] { return !finished.isEmpty(); }, kTrainingPatienceMs));
    QVERIFY(!QFile::exists(bench.folder.filePath("cut.pdf")));
    QVERIFY(!page.reports().isRunning());
}

void TestGuiCompare::chamberLog_verdicts_sayNoYesAndWhy()
{
    REQUIRE_SHARED_DATA(folder, "climate_chamber");
    GuiBench bench(0);
    std::vector<std::filesystem::path> logs;
    for (const char *name : {"run1_cooling.csv", "run2_heating.csv", "run3_cooling.csv"})
        logs.push_back(folder / name);
    QVERIFY(bench.workbench->importLogs(logs).ok());
    QVERIFY(QTest::qWaitFor([&] { return bench.session().runs().size() == 3; }, 60000));
    bench.setModels(kFast);
    ComparePage page(*bench.context);
    showPage(page);
    QVERIFY(bench.train());
    page.setLimit(0.2);
    QCOMPARE(page.origin(), Origin::Real);
    QVERIFY2(page.card(0).accessibleName().contains(QStringLiteral("No table for x")),
             qPrintable(page.card(0).accessibleName()));
    QVERIFY2(page.card(1).accessibleName().contains(QStringLiteral("Write the table")),
             qPrintable(page.card(1).accessibleName()));
    QVERIFY(!page.card(2).accessibleName().contains(QStringLiteral("Write the table.")));
    page.chooseRun(1);
    QCOMPARE(cell(page, 0, QStringLiteral("Limit")), QStringLiteral("Fail"));
    QCOMPARE(cell(page, 1, QStringLiteral("Limit")), QStringLiteral("Pass"));
}

QTEST_MAIN(TestGuiCompare)
#include "tst_gui_compare.moc"
