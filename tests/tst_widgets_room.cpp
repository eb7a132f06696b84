// What gives way where there is no room for all: ticks of an axis, columns of a table.
#include "widgets/tables/data_table.h"
#include "widgets/tables/table_text.h"
#include "widgets/views/curve_panels_view.h"

#include <QClipboard>
#include <QHeaderView>
#include <QHelpEvent>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QTest>
#include <QToolTip>

#include <qcustomplot.h>

#include <cmath>
#include <random>

using namespace driftbench;

class TestWidgetsRoom : public QObject
{
    Q_OBJECT

private slots:
    void ticks_anySize_labelsDoNotTouch();
    void ticks_roomAgain_comeBack();
    void dataTable_narrow_leavesOutYieldingColumns();
    void dataTable_keptInView_isNeverWider();
    void dataTable_cutText_standsInTheTooltip();
};

static constexpr std::uint64_t kSeed = 20261126;

static std::unique_ptr<CurvePanelsView> threePanels(double low, double high)
{
    std::vector<CurvePanel> panels(3);
    for (CurvePanel &panel : panels) {
        CurveSeries curve;
        for (int i = 0; i <= 20; ++i) {
            curve.keys.append(low + (high - low) * i / 20.0);
            curve.values.append(curve.keys.last() * 0.013);
        }
        panel.keyLabel = QStringLiteral("T (°C)");
        panel.valueLabel = QStringLiteral("TDE (dps)");
        panel.curves.push_back(std::move(curve));
    }
    auto view = std::make_unique<CurvePanelsView>(QStringLiteral("Curves"), lightPalette());
    view->setPanels(std::move(panels), 3);
    return view;
}

static int tickCountAt(CurvePanelsView &view, const QSize &size)
{
    view.resize(size);
    view.show();
    QApplication::processEvents();
    view.plot().replot();
    return static_cast<int>(
        view.plot().axisRects().front()->axis(QCPAxis::atBottom)->tickVectorLabels().size());
}

// The nearest two labels of an axis, in px between their edges.
static double gapBetweenLabels(const QCPAxis &axis)
{
    const QFontMetrics metrics(axis.tickLabelFont());
    const bool across = axis.orientation() == Qt::Horizontal;
    double least = INFINITY;
    for (qsizetype i = 1; i < axis.tickVector().size(); ++i) {
        const double apart =
            std::abs(axis.coordToPixel(axis.tickVector()[i]) - axis.coordToPixel(axis.tickVector()[i - 1]));
        const double size = across ? 0.5 * (metrics.horizontalAdvance(axis.tickVectorLabels()[i]) +
                                            metrics.horizontalAdvance(axis.tickVectorLabels()[i - 1]))
                                   : metrics.ascent();
        least = std::min(least, apart - size);
    }
    return least;
}

void TestWidgetsRoom::ticks_anySize_labelsDoNotTouch()
{
    std::mt19937_64 random(kSeed);
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    std::uniform_int_distribution<int> width(420, 1900);
    std::uniform_int_distribution<int> height(140, 700);
    std::uniform_real_distribution<double> decade(-2.0, 5.0);
    for (int round = 0; round < 60; ++round) {
        const double span = std::pow(10.0, decade(random));
        const auto view = threePanels(-0.4 * span, 0.6 * span);
        const QSize size(width(random), height(random));
        tickCountAt(*view, size);
        for (const QCPAxisRect *rect : view->plot().axisRects()) {
            for (const QCPAxis *axis : {rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft)})
                QVERIFY2(
                    gapBetweenLabels(*axis) > 0.0,
                    qPrintable(
                        QStringLiteral("%1 x %2, span %3").arg(size.width()).arg(size.height()).arg(span)));
        }
    }
}

void TestWidgetsRoom::ticks_roomAgain_comeBack()
{
    const auto view = threePanels(-40.0, 85.0);
    const int wide = tickCountAt(*view, {1500, 300});
    const int narrow = tickCountAt(*view, {420, 300});
    QVERIFY2(narrow < wide, qPrintable(QStringLiteral("%1, %2").arg(narrow).arg(wide)));
    QVERIFY(narrow > 0);
    QCOMPARE(tickCountAt(*view, {1500, 300}), wide);
}

static std::unique_ptr<QStandardItemModel> modelOf(const QStringList &heads, const QStringList &cells)
{
    auto model = std::make_unique<QStandardItemModel>(1, static_cast<int>(heads.size()));
    for (int column = 0; column < model->columnCount(); ++column) {
        model->setHeaderData(column, Qt::Horizontal, heads[column]);
        model->setItem(0, column, new QStandardItem(cells[column]));
    }
    return model;
}

void TestWidgetsRoom::dataTable_narrow_leavesOutYieldingColumns()
{
    const auto model = modelOf({"T", "x", "code", "worst"}, {"-40.0", "0.1234", "-123 456 789", "1.12"});
    DataTable table(QStringLiteral("Knots"));
    table.setTableModel(model.get());
    table.setYieldingColumns({2});
    table.resize(600, 200);
    table.show();
    QVERIFY(!table.isColumnHidden(2));
    table.resize(210, 200);
    QVERIFY(table.isColumnHidden(2));
    QVERIFY(!table.isColumnHidden(3));
    QTRY_COMPARE(table.horizontalScrollBar()->maximum(), 0);
    table.copyAs(TableFormat::Csv);
    QVERIFY(QApplication::clipboard()->text().contains(QStringLiteral("code")));
    table.resize(600, 200);
    QVERIFY(!table.isColumnHidden(2));
}

void TestWidgetsRoom::dataTable_keptInView_isNeverWider()
{
    std::mt19937_64 random(kSeed);
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    std::uniform_int_distribution<int> letters(1, 60);
    for (int round = 0; round < 30; ++round) {
        QStringList cells;
        for (int column = 0; column < 5; ++column)
            cells.append(QString(letters(random), QLatin1Char('m')));
        const auto model = modelOf({"a", "b", "c", "d", "e"}, cells);
        DataTable table(QStringLiteral("Facts"));
        table.setTableModel(model.get());
        table.setKeptInView(true);
        table.resize(300 + 20 * round, 120);
        table.show();
        QVERIFY(table.horizontalHeader()->length() <= table.viewport()->width());
        for (int column = 0; column < 5; ++column)
            QVERIFY(table.columnWidth(column) >= 24);
    }
}

void TestWidgetsRoom::dataTable_cutText_standsInTheTooltip()
{
    const QString text(80, QLatin1Char('m'));
    const auto model = modelOf({"a", "b"}, {"x", text});
    DataTable table(QStringLiteral("Facts"));
    table.setTableModel(model.get());
    table.setKeptInView(true);
    table.resize(240, 120);
    table.show();
    const QPoint place = table.visualRect(table.model()->index(0, 1)).center();
    QHelpEvent hover(QEvent::ToolTip, place, table.viewport()->mapToGlobal(place));
    QApplication::sendEvent(table.viewport(), &hover);
    QCOMPARE(QToolTip::text(), text);
}

QTEST_MAIN(TestWidgetsRoom)
#include "tst_widgets_room.moc"
