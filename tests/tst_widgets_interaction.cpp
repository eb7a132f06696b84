// Mouse and keys of the plots, by events as a user makes them.
#include "support/test_data.h"
#include "support/view_data.h"
#include "widgets/figure/plot_picture.h"
#include "widgets/plot/axis_moves.h"
#include "widgets/plot/plot_interaction.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/views/tcq_scatter_view.h"

#include <QDir>
#include <QMenu>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <qcustomplot.h>

#include <cmath>

using namespace driftbench;

namespace {

// Two strips over one time, 0 to 100, values -1 to 1.
class Strips
{
public:
    Strips()
    {
        applyPlotStyle(plot, lightPalette());
        plot.plotLayout()->clear();
        QList<QCPAxis *> keys;
        for (int row = 0; row < 2; ++row) {
            auto *panel = new QCPAxisRect(&plot);
            plot.plotLayout()->addElement(row, 0, panel);
            applyPlotStyle(*panel, lightPalette());
            panel->setAutoMargins(QCP::msNone);
            panel->setMargins(QMargins(60, 20, 20, 30));
            panel->axis(QCPAxis::atBottom)->setRange(0.0, 100.0);
            panel->axis(QCPAxis::atLeft)->setRange(-1.0, 1.0);
            addLine(*panel, {0.0, 50.0, 100.0}, {0.0, 0.5, -0.5}, QPen(Qt::black), QStringLiteral("wave"));
            keys.append(panel->axis(QCPAxis::atBottom));
        }
        linkAxes(keys);
        plot.resize(600, 400);
        plot.show();
        plot.replot();
        interaction = new PlotInteraction(&plot, lightPalette());
        interaction->rememberHome();
    }

    QCPAxisRect &panel(int row) const { return *plot.axisRects().at(row); }
    QCPRange keys(int row = 0) const { return panel(row).axis(QCPAxis::atBottom)->range(); }
    QCPRange values(int row = 0) const { return panel(row).axis(QCPAxis::atLeft)->range(); }
    QPoint at(double key, double value, int row = 0) const
    {
        return {static_cast<int>(std::lround(panel(row).axis(QCPAxis::atBottom)->coordToPixel(key))),
                static_cast<int>(std::lround(panel(row).axis(QCPAxis::atLeft)->coordToPixel(value)))};
    }
    void drag(const QPoint &from, const QPoint &to, Qt::KeyboardModifiers with = Qt::NoModifier)
    {
        QTest::mousePress(&plot, Qt::LeftButton, with, from);
        move((from + to) / 2, with);
        move(to, with);
        QTest::mouseRelease(&plot, Qt::LeftButton, with, to);
    }
    void move(const QPoint &to, Qt::KeyboardModifiers with = Qt::NoModifier)
    {
        QMouseEvent event(QEvent::MouseMove, to, plot.mapToGlobal(to), Qt::LeftButton, Qt::LeftButton, with);
        QApplication::sendEvent(&plot, &event);
    }
    void wheel(const QPoint &place, int notches)
    {
        QWheelEvent event(place, plot.mapToGlobal(place), QPoint(), QPoint(0, 120 * notches), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&plot, &event);
    }

    QCustomPlot plot;
    PlotInteraction *interaction = nullptr;
};

} // namespace

class TestWidgetsInteraction : public QObject
{
    Q_OBJECT

private slots:
    void wheel_insidePanel_zoomsAtTheMouse();
    void wheel_overAnAxis_zoomsThatAxisAlone();
    void wheel_horizontalOnly_leavesValues();
    void wheel_manyNotches_staysWithinSense();
    void drag_plain_panelFollowsTheMouse();
    void drag_logarithmic_panelFollowsTheMouse();
    void drag_withShift_zoomsToTheBox();
    void drag_selectKeys_reportsTheStretch();
    void drag_withControl_reportsTheBox();
    void doubleClick_afterZoom_fits();
    void keys_eachOfThem_movesTheView();
    void cursors_keysAndDrag_moveAndReport();
    void cursors_zoomedAway_canNotBeCaught();
    void menu_rightButton_offersTheSame();
    void table_ofThePlot_holdsWhatIsInView();
    void csv_oddTexts_readBackAsWritten();
    void save_eachEnding_writesThatFormat();
    void save_unknownEndingOrFolder_isRefused();
    void view_newDataWhileZoomed_keepsTheView();
    void focus_byKeyboard_isSeen();
};

void TestWidgetsInteraction::wheel_insidePanel_zoomsAtTheMouse()
{
    Strips strips;
    QSignalSpy spy(strips.interaction, &PlotInteraction::viewChanged);
    const QPoint place = strips.at(25.0, 0.5);
    const double before = strips.panel(0).axis(QCPAxis::atBottom)->pixelToCoord(place.x());
    strips.wheel(place, 2);
    QCOMPARE(spy.count(), 1);
    QVERIFY(std::abs(strips.keys().size() - 100.0 * 0.85 * 0.85) < 1e-9);
    QVERIFY(std::abs(strips.values().size() - 2.0 * 0.85 * 0.85) < 1e-9);
    QVERIFY(std::abs(strips.panel(0).axis(QCPAxis::atBottom)->pixelToCoord(place.x()) - before) < 1e-9);
    QCOMPARE(strips.keys(1).lower, strips.keys(0).lower); // linked
    QCOMPARE(strips.values(1).size(), 2.0);
}

void TestWidgetsInteraction::wheel_overAnAxis_zoomsThatAxisAlone()
{
    Strips strips;
    const QRect panel = strips.panel(0).rect();
    strips.wheel({panel.left() - 20, panel.center().y()}, 1);
    QCOMPARE(strips.keys().size(), 100.0);
    QVERIFY(strips.values().size() < 1.8);
    strips.wheel({panel.center().x(), panel.bottom() + 12}, -1);
    QVERIFY(strips.keys().size() > 110.0);
}

void TestWidgetsInteraction::wheel_horizontalOnly_leavesValues()
{
    Strips strips;
    strips.interaction->setFreeAxes(Qt::Horizontal);
    strips.wheel(strips.at(50.0, 0.0), 3);
    QVERIFY(strips.keys().size() < 70.0);
    QCOMPARE(strips.values().size(), 2.0);
}

void TestWidgetsInteraction::wheel_manyNotches_staysWithinSense()
{
    Strips strips;
    strips.wheel(strips.at(50.0, 0.0), 1000);
    QVERIFY(strips.keys().size() >= 100.0 * 0.99e-6);
    strips.wheel(strips.at(50.0, 0.0), -3000);
    QVERIFY(strips.keys().size() <= 100.0 * 101.0);
}

void TestWidgetsInteraction::drag_plain_panelFollowsTheMouse()
{
    Strips strips;
    const QPoint from = strips.at(20.0, 0.0);
    const QPoint to = from + QPoint(50, 30);
    const double key = strips.panel(0).axis(QCPAxis::atBottom)->pixelToCoord(from.x());
    const double value = strips.panel(0).axis(QCPAxis::atLeft)->pixelToCoord(from.y());
    strips.drag(from, to);
    QVERIFY(std::abs(strips.panel(0).axis(QCPAxis::atBottom)->pixelToCoord(to.x()) - key) < 1e-9);
    QVERIFY(std::abs(strips.panel(0).axis(QCPAxis::atLeft)->pixelToCoord(to.y()) - value) < 1e-9);
    QVERIFY(std::abs(strips.keys().size() - 100.0) < 1e-9);
}

void TestWidgetsInteraction::drag_logarithmic_panelFollowsTheMouse()
{
    Strips strips;
    applyLogScale(*strips.panel(0).axis(QCPAxis::atLeft), 0.001, 10.0);
    const QPoint from = strips.at(50.0, 0.1);
    const double value = strips.panel(0).axis(QCPAxis::atLeft)->pixelToCoord(from.y());
    strips.drag(from, from + QPoint(0, 40));
    const double now = strips.panel(0).axis(QCPAxis::atLeft)->pixelToCoord(from.y() + 40);
    QVERIFY(std::abs(now / value - 1.0) < 1e-9);
    QVERIFY(std::abs(strips.values().upper / strips.values().lower - 1e4) < 1e-3);
}

void TestWidgetsInteraction::drag_withShift_zoomsToTheBox()
{
    Strips strips;
    strips.drag(strips.at(60.0, 0.5), strips.at(30.0, -0.5), Qt::ShiftModifier);
    QVERIFY(std::abs(strips.keys().lower - 30.0) < 0.5);
    QVERIFY(std::abs(strips.keys().upper - 60.0) < 0.5);
    QVERIFY(std::abs(strips.values().lower + 0.5) < 0.02);
    QVERIFY(std::abs(strips.values().upper - 0.5) < 0.02);
}

void TestWidgetsInteraction::drag_selectKeys_reportsTheStretch()
{
    Strips strips;
    strips.interaction->setDragAction(PlotInteraction::DragAction::SelectKeys);
    QSignalSpy selected(strips.interaction, &PlotInteraction::keysSelected);
    QSignalSpy ended(strips.interaction, &PlotInteraction::selectionEnded);
    strips.drag(strips.at(70.0, 0.0), strips.at(40.0, 0.0));
    QCOMPARE(ended.count(), 1);
    QVERIFY(std::abs(selected.last().at(1).toDouble() - 40.0) < 0.5);
    QVERIFY(std::abs(selected.last().at(2).toDouble() - 70.0) < 0.5);
    QCOMPARE(strips.keys().size(), 100.0); // no pan
}

void TestWidgetsInteraction::drag_withControl_reportsTheBox()
{
    Strips strips;
    strips.interaction->setBoxSelection(true);
    QSignalSpy spy(strips.interaction, &PlotInteraction::boxSelected);
    strips.drag(strips.at(20.0, 0.8, 1), strips.at(50.0, -0.2, 1), Qt::ControlModifier);
    QCOMPARE(spy.count(), 1);
    QCOMPARE(spy.first().at(0).value<QCPAxisRect *>(), &strips.panel(1));
    const QRectF box = spy.first().at(1).toRectF();
    QVERIFY(std::abs(box.left() - 20.0) < 0.5 && std::abs(box.right() - 50.0) < 0.5);
    QVERIFY(std::abs(box.top() + 0.2) < 0.03 && std::abs(box.bottom() - 0.8) < 0.03);
}

void TestWidgetsInteraction::doubleClick_afterZoom_fits()
{
    Strips strips;
    strips.wheel(strips.at(50.0, 0.0), 5);
    QVERIFY(strips.interaction->isMoved());
    QTest::mouseDClick(&strips.plot, Qt::LeftButton, Qt::NoModifier, strips.at(50.0, 0.0));
    QVERIFY(!strips.interaction->isMoved());
    QCOMPARE(strips.keys().lower, 0.0);
    QCOMPARE(strips.keys().upper, 100.0);
    QCOMPARE(strips.values().size(), 2.0);
}

void TestWidgetsInteraction::keys_eachOfThem_movesTheView()
{
    Strips strips;
    QTest::keyClick(&strips.plot, Qt::Key_Right);
    QVERIFY(std::abs(strips.keys().lower - 10.0) < 0.2);
    QTest::keyClick(&strips.plot, Qt::Key_Left);
    QVERIFY(std::abs(strips.keys().lower) < 0.2);
    QTest::keyClick(&strips.plot, Qt::Key_Up);
    QVERIFY(std::abs(strips.values().lower + 0.8) < 0.02);
    QTest::keyClick(&strips.plot, Qt::Key_Down);
    QTest::keyClick(&strips.plot, Qt::Key_Plus);
    QVERIFY(std::abs(strips.keys().size() - 75.0) < 1e-9);
    QTest::keyClick(&strips.plot, Qt::Key_Minus);
    QVERIFY(std::abs(strips.keys().size() - 100.0) < 1e-9);
    QTest::keyClick(&strips.plot, Qt::Key_F);
    QCOMPARE(strips.keys().lower, 0.0);
    QKeyEvent other(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier);
    QVERIFY(!strips.interaction->handleKey(&other)); // the page's
}

void TestWidgetsInteraction::cursors_keysAndDrag_moveAndReport()
{
    Strips strips;
    PlotCursors &cursors = strips.interaction->enableCursors();
    QSignalSpy spy(&cursors, &PlotCursors::changed);
    cursors.place(Cursor::A, 30.0);
    cursors.place(Cursor::B, 80.0);
    strips.plot.replot();
    QCOMPARE(spy.count(), 2);
    strips.drag(strips.at(30.0, 0.3) + QPoint(3, 0), strips.at(60.0, 0.3)); // 3 px beside the line
    QVERIFY(std::abs(*cursors.key(Cursor::A) - 60.0) < 0.5);
    QCOMPARE(strips.keys().size(), 100.0);
    const QPoint tag(strips.at(80.0, 0.0).x(), strips.panel(0).top() - 8);
    strips.drag(tag, tag + QPoint(-60, 0));
    QVERIFY(*cursors.key(Cursor::B) < 75.0);
    strips.drag(tag, QPoint(5000, tag.y())); // nothing there now: pans nothing, catches nothing
    const double before = *cursors.key(Cursor::B);
    QTest::keyClick(&strips.plot, Qt::Key_B);
    QVERIFY(*cursors.key(Cursor::B) != before);
    cursors.clear();
    QVERIFY(!cursors.key(Cursor::A) && !cursors.key(Cursor::B));
}

void TestWidgetsInteraction::cursors_zoomedAway_canNotBeCaught()
{
    Strips strips;
    PlotCursors &cursors = strips.interaction->enableCursors();
    cursors.place(Cursor::A, 30.0);
    const QPoint place = strips.at(30.0, 0.0);
    QCOMPARE(cursors.at(place), std::optional(Cursor::A));
    strips.panel(0).axis(QCPAxis::atBottom)->setRange(40.0, 60.0);
    QVERIFY(!cursors.at(place));
}

void TestWidgetsInteraction::menu_rightButton_offersTheSame()
{
    Strips strips;
    strips.interaction->enableCursors();
    QContextMenuEvent event(QContextMenuEvent::Mouse, strips.at(50.0, 0.0),
                            strips.plot.mapToGlobal(strips.at(50.0, 0.0)));
    QApplication::sendEvent(&strips.plot, &event);
    auto *menu = strips.plot.findChild<QMenu *>();
    QVERIFY(menu);
    QList<QKeySequence> keys;
    for (const QAction *action : menu->actions())
        keys.append(action->shortcut());
    for (const QKeySequence &wanted :
         {QKeySequence(Qt::Key_F), QKeySequence(Qt::Key_Plus), QKeySequence(Qt::Key_Minus),
          QKeySequence(Qt::Key_A), QKeySequence(Qt::Key_B), QKeySequence(Qt::CTRL | Qt::Key_E)})
        QVERIFY2(keys.contains(wanted), qPrintable(wanted.toString()));
    menu->close();
}

void TestWidgetsInteraction::table_ofThePlot_holdsWhatIsInView()
{
    Strips strips;
    strips.panel(0).axis(QCPAxis::atBottom)->setRange(40.0, 110.0);
    const PlotTable table = visibleData(strips.plot);
    QCOMPARE(table.rows(), 4); // two points of each panel
    QCOMPARE(table.columns[1].texts.front(), QStringLiteral("wave"));
    QCOMPARE(table.columns[2].numbers.front(), 50.0);
    strips.interaction->showTable();
    auto *view = strips.plot.findChild<QTableView *>();
    QVERIFY(view);
    QCOMPARE(view->model()->rowCount(), 4);
    QCOMPARE(view->model()->index(1, 3).data().toString(), QStringLiteral("−0.5000"));
}

void TestWidgetsInteraction::csv_oddTexts_readBackAsWritten()
{
    PlotTable table;
    table.columns = {{QStringLiteral("name, odd"), {QStringLiteral("a \"b\""), QStringLiteral("c")}, {}},
                     {QStringLiteral("T (°C)"), {}, {-0.1, NAN}}};
    QCOMPARE(QString::fromUtf8(plotTableAsCsv(table)),
             QStringLiteral("\"name, odd\",T (°C)\n\"a \"\"b\"\"\",-0.1\nc,\n"));
}

void TestWidgetsInteraction::save_eachEnding_writesThatFormat()
{
    Strips strips;
    QTemporaryDir folder;
    const std::map<QString, QByteArray> starts{{QStringLiteral("png"), "\x89PNG"},
                                               {QStringLiteral("svg"), "<?xml"},
                                               {QStringLiteral("pdf"), "%PDF"},
                                               {QStringLiteral("csv"), "Panel,Series,Key,Value\n"}};
    for (const auto &[ending, start] : starts) {
        const QString path = folder.filePath(QStringLiteral("plot.") + ending);
        const Status saved =
            savePlot(strips.plot, path, QStringLiteral("plot"), Qt::white, visibleData(strips.plot));
        QVERIFY(saved.ok());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(file.readAll().startsWith(start), qPrintable(ending));
    }
}

void TestWidgetsInteraction::save_unknownEndingOrFolder_isRefused()
{
    Strips strips;
    const Status ending = savePlot(strips.plot, QStringLiteral("plot.gif"), {}, Qt::white, {});
    QCOMPARE(ending.error().code, Errc::InvalidOption);
    const Status folder = savePlot(strips.plot, QStringLiteral("/nowhere/plot.png"), {}, Qt::white, {});
    QCOMPARE(folder.error().code, Errc::OutputNotWritable);
}

void TestWidgetsInteraction::view_newDataWhileZoomed_keepsTheView()
{
    TcqScatterView view;
    view.resize(800, 400);
    view.enableInteraction();
    TcqScatterData data;
    data.runs = test::syntheticRuns(1, 10.0);
    data.curves = {modelCurve(test::syntheticRbf())};
    view.setData(data);
    view.show();
    QCPAxis *axis = view.plot().axisRects().front()->axis(QCPAxis::atBottom);
    const QCPRange home = axis->range();
    view.interaction()->zoomBy(0.5);
    const QCPRange zoomed = axis->range();
    QVERIFY(zoomed.size() < 0.6 * home.size());
    view.setData(data);
    axis = view.plot().axisRects().front()->axis(QCPAxis::atBottom);
    QCOMPARE(axis->range().lower, zoomed.lower);
    view.interaction()->fit();
    QCOMPARE(axis->range().lower, home.lower);
    QCOMPARE(axis->range().upper, home.upper);
}

void TestWidgetsInteraction::focus_byKeyboard_isSeen()
{
    QWidget window;
    auto *plot = new QCustomPlot(&window);
    plot->resize(200, 100);
    PlotInteraction interaction(plot, lightPalette());
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    plot->clearFocus();
    const QImage before = plot->grab().toImage();
    plot->setFocus(Qt::TabFocusReason);
    QTRY_VERIFY(plot->hasFocus());
    const QImage after = plot->grab().toImage();
    QVERIFY(before != after);
    QCOMPARE(after.pixelColor(100, 1), lightPalette().accent);
}

QTEST_MAIN(TestWidgetsInteraction)
#include "tst_widgets_interaction.moc"
