// Tables and cards of the pages Train, Compare and Export, with values of the engine.
#include "engine/base/text.h"
#include "engine/compensation/table_error.h"
#include "engine/evaluation/axis_finding.h"
#include "engine/evaluation/comparison.h"
#include "engine/evaluation/judged_traces.h"
#include "support/models_for_export.h"
#include "support/small_comparison.h"
#include "support/test_data.h"
#include "widgets/figure/figure_export.h"
#include "widgets/style/theme.h"
#include "widgets/tables/comparison_table_model.h"
#include "widgets/tables/data_table.h"
#include "widgets/tables/knots_table_model.h"
#include "widgets/tables/models_table_model.h"
#include "widgets/views/centres_view.h"
#include "widgets/views/judged_run_view.h"
#include "widgets/views/table_error_view.h"
#include "widgets/views/verdict_card.h"

#include <QClipboard>
#include <QHeaderView>
#include <QTest>

#include <cmath>

using namespace driftbench;
using namespace driftbench::test;

class TestWidgetsTables : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void comparisonTable_run_hasThePapersOrderAndSigns();
    void comparisonTable_allRuns_namesRunAndAxis();
    void tableAs_csv_readsBackExactly();
    void tableAs_markdownAndLatex_haveARowForEach();
    void tableAs_lettersOfEachFormat_areEscaped();
    void dataTable_sorted_goesByNumbers();
    void dataTable_copy_putsHeadsAndCells();
    void modelsTable_running_hasItsBarAndNote();
    void findingText_everyVerdict_saysWhatToDo();
    void tableErrors_randomModels_stayWithinTheBound();
    void views_engineValues_draw();

private:
    TrainingSet m_set;
    Comparison m_comparison;
};

void TestWidgetsTables::initTestCase()
{
    static Theme theme;
    SmallComparison small = smallComparison();
    m_set = std::move(small.set);
    m_comparison = std::move(small.comparison);
}

static QString headOf(const QAbstractItemModel &model, int column)
{
    return model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
}

static int columnOf(const QAbstractItemModel &model, const QString &head)
{
    for (int column = 0; column < model.columnCount(); ++column) {
        if (headOf(model, column) == head)
            return column;
    }
    qFatal("no column %s", qPrintable(head));
}

static double exact(const QAbstractItemModel &model, int row, const QString &head)
{
    return model.index(row, columnOf(model, head)).data(kExactRole).toDouble();
}

void TestWidgetsTables::comparisonTable_run_hasThePapersOrderAndSigns()
{
    ComparisonTableModel table;
    table.setData({m_comparison.rows, "rbf", "run2", 0.05, QStringLiteral("Run 2")});
    QCOMPARE(table.rowCount(), 3);
    QCOMPARE(headOf(table, 0), QStringLiteral("Run 2"));
    const QStringList order{"MSD1", "MSD4", "MSD5", "MSD6", "Q3", "Q4", "Q5"};
    for (int i = 0; i < order.size(); ++i)
        QVERIFY(headOf(table, 1 + i).startsWith(order[i] + '\n'));
    for (int axis = 0; axis < 3; ++axis) {
        const double linear = rowOf(m_comparison, "run2", axis, "linear").msdAfter;
        const double rbf = rowOf(m_comparison, "run2", axis, "rbf").msdAfter;
        QCOMPARE(exact(table, axis, "MSD4\nConv. 1"), linear);
        QCOMPARE(exact(table, axis, "MSD6\nNovel"), rbf);
        const double difference = exact(table, axis, "Q5 − Q3\n% of Q3");
        QVERIFY(std::abs(difference - 100.0 * (rbf - linear) / linear) < 1e-9 * std::abs(difference) + 1e-9);
        QVERIFY(std::isnan(exact(table, axis, "MSD5\nConv. 2"))); // was not compared
        QCOMPARE(table.index(axis, columnOf(table, "MSD5\nConv. 2")).data().toString(), QStringLiteral("–"));
        const bool passes = std::sqrt(rbf) <= 0.05;
        QCOMPARE(table.index(axis, columnOf(table, "Limit\n0.050")).data().toString(),
                 passes ? QStringLiteral("Pass") : QStringLiteral("Fail"));
    }
}

void TestWidgetsTables::comparisonTable_allRuns_namesRunAndAxis()
{
    ComparisonTableModel table;
    table.setData({m_comparison.rows, "rbf", std::nullopt, std::nullopt, {}});
    QCOMPARE(table.rowCount(), 9);
    QCOMPARE(table.index(3, 0).data().toString(), QStringLiteral("run2"));
    QCOMPARE(table.index(4, 1).data().toString(), QStringLiteral("y"));
    QCOMPARE(table.index(0, table.columnCount() - 1).data().toString(), QString());
}

void TestWidgetsTables::tableAs_csv_readsBackExactly()
{
    ComparisonTableModel table;
    table.setData({m_comparison.rows, "rbf", std::nullopt, std::nullopt, {}});
    const QStringList lines = tableAs(gridOf(table), TableFormat::Csv).split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 10);
    const auto at = static_cast<int>(columnOf(table, "MSD6\nNovel"));
    for (int row = 0; row < 9; ++row) {
        const auto value = parseNumber(lines[row + 1].split(',')[at].toStdString());
        QVERIFY(value.has_value());
        QCOMPARE(*value, table.index(row, at).data(kExactRole).toDouble());
    }
}

void TestWidgetsTables::tableAs_markdownAndLatex_haveARowForEach()
{
    ComparisonTableModel table;
    table.setData({m_comparison.rows, "rbf", "run1", std::nullopt, QStringLiteral("Run 1")});
    const QStringList markdown =
        tableAs(gridOf(table), TableFormat::Markdown).split('\n', Qt::SkipEmptyParts);
    QCOMPARE(markdown.size(), 5);
    for (const QString &line : markdown)
        QCOMPARE(line.count('|'), table.columnCount() + 1);
    QVERIFY(markdown[1].contains("---:"));
    const QString latex = tableAs(gridOf(table), TableFormat::Latex);
    QCOMPARE(latex.count("\\\\\n"), 4);
    QCOMPARE(latex.count('&'), 4 * (table.columnCount() - 1));
    QVERIFY(latex.contains("\\midrule") && !latex.contains(QChar(0x2212)));
}

void TestWidgetsTables::tableAs_lettersOfEachFormat_areEscaped()
{
    TableGrid grid;
    grid.heads = {"a|b", "50 %"};
    grid.numeric = {false, true};
    grid.rows = {{{"x, \"y\"", "x, \"y\""}, {QString(QChar(0x2212)) + "1", "-1"}}};
    QVERIFY(tableAs(grid, TableFormat::Csv).contains("\"x, \"\"y\"\"\",-1"));
    QVERIFY(tableAs(grid, TableFormat::Markdown).contains("a\\|b"));
    const QString latex = tableAs(grid, TableFormat::Latex);
    QVERIFY(latex.contains("50 \\%") && latex.contains("$-$1"));
}

void TestWidgetsTables::dataTable_sorted_goesByNumbers()
{
    ComparisonTableModel model;
    model.setData({m_comparison.rows, "rbf", std::nullopt, std::nullopt, {}});
    DataTable table("Comparison");
    table.setTableModel(&model);
    table.setSortable(true);
    const int column = columnOf(model, "MSD4\nConv. 1");
    table.sortByColumn(column, Qt::DescendingOrder);
    double before = INFINITY;
    for (int row = 0; row < 9; ++row) {
        const double value = table.model()->index(row, column).data(kExactRole).toDouble();
        QVERIFY(value <= before);
        before = value;
    }
}

void TestWidgetsTables::dataTable_copy_putsHeadsAndCells()
{
    ComparisonTableModel model;
    model.setData({m_comparison.rows, "rbf", "run1", std::nullopt, QStringLiteral("Run 1")});
    DataTable table("Comparison");
    table.setTableModel(&model);
    table.selectionModel()->select({table.model()->index(0, 1), table.model()->index(1, 2)},
                                   QItemSelectionModel::Select);
    QTest::keySequence(&table, QKeySequence::Copy);
    const QStringList lines = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 3);
    QCOMPARE(lines[0], QStringLiteral("MSD1 before\tMSD4 Conv. 1"));
    QCOMPARE(lines[1].split('\t').front(), model.index(0, 1).data().toString());
    table.copyAs(TableFormat::Markdown);
    QVERIFY(QApplication::clipboard()->text().startsWith("| Run 1 |"));
}

void TestWidgetsTables::modelsTable_running_hasItsBarAndNote()
{
    ModelsTableModel model;
    ModelsTableData data;
    data.models.resize(2);
    data.models[0].name = "rbf";
    data.models[0].state = ModelLine::State::Finished;
    data.models[0].timeS = 0.31;
    data.models[0].msd = {0.02, 0.02, 0.02};
    data.models[1].name = "bpnn";
    data.models[1].state = ModelLine::State::Running;
    data.models[1].progress = 0.4;
    data.models[1].note = "Training.";
    data.floor = {0.019, 0.019, 0.019};
    model.setData(data);
    QCOMPARE(model.rowCount(), 3);
    const int time = columnOf(model, "Time");
    QCOMPARE(model.index(0, time).data().toString(), QStringLiteral("310 ms"));
    QVERIFY(!model.index(0, time).data(kProgressRole).isValid());
    QCOMPARE(model.index(1, time).data(kProgressRole).toDouble(), 0.4);
    QCOMPARE(model.index(1, time + 1).data(kSpanRole).toInt(), 6);
    QCOMPARE(model.index(2, 0).data().toString(), QStringLiteral("Noise floor"));
    QCOMPARE(trainingTimeText(0.0001), QStringLiteral("< 1 ms"));
    QCOMPARE(trainingTimeText(12.94), QStringLiteral("12.9 s"));
}

void TestWidgetsTables::findingText_everyVerdict_saysWhatToDo()
{
    const auto rows = rowsBy({{0.246, 0.217}, {0.398, 0.583}, {0.539, 0.6}});
    const FindingText no = findingText(findAxis(rows, 0, "rbf", Verdict::NotRepeatable, 0.2), NAN);
    QCOMPARE(no.toDo, QStringLiteral("No table for x."));
    QVERIFY2(no.figures.contains("0.246, 0.398, 0.539 dps rms, over the limit of 0.200"),
             qPrintable(no.figures));
    QVERIFY(no.reason.contains("run1"));
    const auto good = rowsBy({{0.089, 1.0}, {0.058, 1.1}});
    const FindingText yes = findingText(findAxis(good, 1, "rbf", Verdict::Yes, 0.2), 0.03);
    QVERIFY(yes.figures.isEmpty() || !yes.toDo.isEmpty());
    const FindingText yesX = findingText(findAxis(good, 0, "rbf", Verdict::Yes, 0.2), 0.03);
    QCOMPARE(yesX.toDo, QStringLiteral("Write the table."));
    QVERIFY2(yesX.figures.contains("11 to 19 times less"), qPrintable(yesX.figures));
    QVERIFY2(yesX.reason.contains("3 times the noise"), qPrintable(yesX.reason));
    VerdictCard card;
    card.setFinding(findAxis(rows, 0, "rbf", Verdict::NotRepeatable, 0.2), NAN, "because");
    QVERIFY(card.accessibleName().contains("No table for x."));
}

void TestWidgetsTables::tableErrors_randomModels_stayWithinTheBound()
{
    Random random = announced(42);
    for (int i = 0; i < 8; ++i) {
        const TrainedModel model = randomModel(random);
        const std::array<bool, 3> axes{true, i % 2 == 0, true};
        const auto table = makeCompensationTable(model, axes);
        QVERIFY(table.ok());
        const FixedPointTable fixed = makeFixedPointTable(*table);
        const TableErrors errors = measureTableErrors(model, *table, fixed);
        QCOMPARE(errors.fixedPointDps.rows(), table->size() - 1);
        QVERIFY(errors.interpolationDps.maxCoeff() <= table->interpolationErrorBoundDps);
        QVERIFY(errors.fixedPointDps.maxCoeff() <= table->interpolationErrorBoundDps + fixed.errorBoundDps);
        QVERIFY(errors.interpolationDps.maxCoeff() > 0.0);
        if (!axes[1])
            QCOMPARE(errors.fixedPointDps.col(1).maxCoeff(), 0.0);
        KnotsTableModel knots;
        knots.setData(std::make_shared<const KnotsTableData>(KnotsTableData{*table, fixed, errors}));
        QCOMPARE(knots.rowCount(), static_cast<int>(table->size()));
        QCOMPARE(exact(knots, 3, "x\ndps"), table->tdeDps(3, 0));
        QCOMPARE(exact(knots, 3, "Worst\nmdps"), 1000.0 * errors.fixedPointDps.row(3).maxCoeff());
    }
}

void TestWidgetsTables::views_engineValues_draw()
{
    CentresData centres;
    centres.selection = m_comparison.rbfSelection;
    centres.curve = modelCurve(m_comparison.models[3]);
    const auto &network = std::get<RbfNetwork>(m_comparison.models[3].model);
    centres.centres = rbfCentres(network);
    centres.centreCount = network.centreCount;
    centres.runs = m_set.runs;
    centres.referenceTemperatureC = m_set.referenceTemperatureC;
    centres.levels = {{"linear", {120.0, 80.0, 40.0}}, {"cubic", {20.0, 8.0, 4.0}}};
    CentresView losses(lightPalette(), nullptr, CentresView::Part::Losses);
    losses.setData(centres);
    const QString svg = QString::fromUtf8(figureAsSvg(losses, losses.figureSize(), {"Losses", {}}));
    QVERIFY(svg.contains("Excess MSD (%)") && svg.contains(">cubic<"));
    QVERIFY(!svg.contains("TDE less line"));
    QCOMPARE(losses.countAt(-3.0), 0);
    QCOMPARE(losses.countAt(5.4), 5);
    QCOMPARE(losses.countAt(1e6), static_cast<int>(m_comparison.rbfSelection->heldOutLoss[0].size()) - 1);

    const Fold &fold = m_comparison.folds.front();
    const TrainedModel constant = heldOut(m_comparison, fold, 0, m_set);
    JudgedRunView judged;
    judged.setData({std::make_shared<const JudgedTraces>(judgedTraces(
                        fold.heldOut, heldOut(m_comparison, fold, 3, m_set), &constant, Judging::Absolute)),
                    0.2});
    const QString text = QString::fromUtf8(figureAsSvg(judged, judged.figureSize(), {"Run", {}}));
    QVERIFY(text.contains("Limit ±0.20 dps") && text.contains("trained on run2, run3"));

    const auto table = makeCompensationTable(m_comparison.models[3], {true, true, true});
    const auto fixed = makeFixedPointTable(*table);
    TableErrorView errors;
    QVERIFY(errors.isEmpty());
    errors.setData(std::make_shared<const KnotsTableData>(KnotsTableData{
                       *table, fixed, measureTableErrors(m_comparison.models[3], *table, fixed)}),
                   1.0);
    QVERIFY(!errors.isEmpty());
    TableDifferenceView difference;
    QVERIFY(difference.isEmpty());
    const auto shared = std::make_shared<const CompensationTable>(*table);
    difference.setData(shared, shared);
    QVERIFY(!difference.isEmpty());
}

QTEST_MAIN(TestWidgetsTables)
#include "tst_widgets_tables.moc"
