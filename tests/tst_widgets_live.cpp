// The live view while samples come.
#include "engine/base/random.h"
#include "support/test_data.h"
#include "widgets/figure/plot_picture.h"
#include "widgets/live/live_trace_view.h"
#include "widgets/live/msd_trend_view.h"

#include <QDir>
#include <QSignalSpy>
#include <QTest>
#include <qcustomplot.h>

#include <cmath>

using namespace driftbench;

namespace {

const Eigen::Vector3d kReference(25.0, 5.0, 53.0);

// 10 Hz from startS on: T rises by 1 degree a minute from -40, raw drifts by 0.02, 0.04, 0.01 dps a degree,
// compensated stays at the reference; noise of 0.14 dps on both.
SampleBlock blockAt(double startS, int rows, Eigen::MatrixX3d *compensated = nullptr, double rateHz = 10.0)
{
    static Random random(5);
    SampleBlock block = SampleBlock::withRows(rows);
    if (compensated)
        compensated->resize(rows, 3);
    const Eigen::Vector3d slope(0.02, 0.04, 0.01);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const double timeS = startS + double(i) / rateHz;
        block.timeS[i] = timeS;
        block.temperatureC[i] = -40.0 + timeS / 60.0;
        const Eigen::Vector3d noise =
            0.14 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
        block.rateDps.row(i) = (kReference + slope * (timeS / 60.0) + noise).transpose();
        if (compensated)
            compensated->row(i) = (kReference + noise).transpose();
    }
    return block;
}

class Live : public LiveTraceView
{
public:
    Live()
    {
        setReference(kReference);
        setPlan(*TemperatureProfile::named("paper"));
        setCompensated(true);
        resize(768, 562);
        show();
    }

    void stream(double fromS, double toS)
    {
        for (double timeS = fromS; timeS < toS - 1e-9; timeS += 60.0) {
            Eigen::MatrixX3d compensated;
            const SampleBlock block = blockAt(timeS, 600, &compensated);
            append(block, compensated);
        }
        refresh();
    }

    QCPRange keys() const { return plot().axisRects().front()->axis(QCPAxis::atBottom)->range(); }
    QCPRange values(int strip) const { return plot().axisRects().at(strip)->axis(QCPAxis::atLeft)->range(); }
    QString svg() { return QString::fromUtf8(plotAsSvg(plot(), size(), look.base, QStringLiteral("live"))); }

    Palette look = lightPalette();
};

} // namespace

class TestWidgetsLive : public QObject
{
    Q_OBJECT

private slots:
    void strips_streaming_showRunPlanAndTags();
    void strips_valueRanges_haveOneSpan();
    void repaint_fastStream_isCapped();
    void repaint_hidden_waitsUntilSeen();
    void pause_samplesGoOn_viewStands();
    void cursors_whileStreaming_readTenSecondMeans();
    void span_lastMinute_followsNow();
    void zoom_byTheUser_staysUntilFit();
    void quantity_tde_isRateLessReference();
    void gap_samplesLost_lineBreaksAndIsNamed();
    void events_many_areBounded();
    void pending_partNotRecorded_hasThePageColour();
    void table_visible_hasEveryTrace();
    void plan_none_runGrowsWithTheSamples();
    void clear_newRun_startsAnew();
    void look_dark_isDark();
    void msdTrend_beforeAndAfter_drawsBoth();

private:
    static void keep(Live &view, const char *name);
};

void TestWidgetsLive::keep(Live &view, const char *name)
{
    const QString folder = qEnvironmentVariable("DRIFTBENCH_FIGURES");
    if (!folder.isEmpty())
        view.grab().save(QDir(folder).filePath(QString::fromUtf8(name) + QStringLiteral(".png")));
}

void TestWidgetsLive::strips_streaming_showRunPlanAndTags()
{
    Live view;
    view.stream(0.0, 7200.0);
    view.setHolds({{0.0, 1800.0, -40.0}});
    view.cursors().place(Cursor::A, 3600.0);
    view.cursors().place(Cursor::B, 6300.0);
    view.refresh();
    keep(view, "live");
    QCOMPARE(view.keys().lower, 0.0);
    QCOMPARE(view.keys().upper, 11100.0);
    const QString svg = view.svg();
    for (const char *text : {"27.4", " raw", " comp.", "x rate (dps)", "T (°C)", "Time since start (h:min)",
                             "2:00", "plan", "plateau", ">A<", ">B<"})
        QVERIFY2(svg.contains(QString::fromUtf8(text)), text);
}

void TestWidgetsLive::strips_valueRanges_haveOneSpan()
{
    Live view;
    view.stream(0.0, 7200.0);
    const double span = view.values(0).size();
    QVERIFY(std::abs(view.values(1).size() - span) < 1e-9);
    QVERIFY(std::abs(view.values(2).size() - span) < 1e-9);
    QVERIFY(view.values(1).contains(5.0) && view.values(1).contains(5.0 + 0.04 * 120));
    QVERIFY(view.values(3).contains(-40.0) && view.values(3).contains(85.0)); // the plan's
}

void TestWidgetsLive::repaint_fastStream_isCapped()
{
    Live view;
    QSignalSpy spy(&view, &LiveTraceView::refreshed);
    QElapsedTimer clock;
    clock.start();
    double timeS = 0.0;
    while (clock.elapsed() < 600) {
        view.append(blockAt(timeS, 10));
        timeS += 1.0;
        QTest::qWait(2);
    }
    QVERIFY(spy.count() >= 2);
    QVERIFY2(spy.count() <= clock.elapsed() / LiveTraceView::kShortestRepaintMs + 2,
             qPrintable(QString::number(spy.count())));
}

void TestWidgetsLive::repaint_hidden_waitsUntilSeen()
{
    Live view;
    view.hide();
    QTest::qWait(60);
    QSignalSpy spy(&view, &LiveTraceView::refreshed);
    view.append(blockAt(0.0, 600));
    QTest::qWait(120);
    QCOMPARE(spy.count(), 0);
    view.show();
    QTRY_VERIFY(spy.count() > 0);
    QCOMPARE(view.traces().samples(), 600);
}

void TestWidgetsLive::pause_samplesGoOn_viewStands()
{
    Live view;
    view.stream(0.0, 600.0);
    view.setPaused(true);
    const double pausedS = view.pausedAtS();
    view.stream(600.0, 720.0);
    QCOMPARE(view.samplesSincePause(), 1200);
    QVERIFY(view.table().columns.front().numbers.last() <= pausedS + 10.0); // a column at most
    view.setPaused(false);
    view.refresh();
    QVERIFY(view.table().columns.front().numbers.last() > 700.0);
    QCOMPARE(view.samplesSincePause(), 0);
}

void TestWidgetsLive::cursors_whileStreaming_readTenSecondMeans()
{
    Live view;
    QVERIFY(!view.reading(Cursor::A));
    view.stream(0.0, 3600.0);
    view.cursors().place(Cursor::A, 600.0);
    view.cursors().place(Cursor::B, 3000.0);
    view.stream(3600.0, 4200.0);
    const auto a = view.reading(Cursor::A);
    const auto b = view.reading(Cursor::B);
    QVERIFY(a && b);
    // 100 samples of 0.14 dps: three standard errors are 0.042.
    QVERIFY(std::abs(a->means[TracePyramid::kRaw] - (25.0 + 0.02 * 10.0)) < 0.05);
    QVERIFY(std::abs(b->means[TracePyramid::kRaw + 1] - (5.0 + 0.04 * 50.0)) < 0.05);
    QVERIFY(std::abs(b->means[TracePyramid::kCompensated + 2] - 53.0) < 0.05);
    QVERIFY(std::abs(b->means[TracePyramid::kTemperature] - a->means[TracePyramid::kTemperature] - 40.0) <
            0.02);
    view.cursors().place(Cursor::A, 9000.0); // not recorded yet
    QVERIFY(!view.reading(Cursor::A));
}

void TestWidgetsLive::span_lastMinute_followsNow()
{
    Live view;
    view.setSpan(LiveSpan::OneMinute);
    view.stream(0.0, 600.0);
    QVERIFY(std::abs(view.keys().size() - 60.0) < 1e-9);
    QVERIFY(view.keys().contains(599.9) && view.keys().upper < 605.0);
    view.setSpan(LiveSpan::TenMinutes);
    view.refresh();
    QVERIFY(std::abs(view.keys().size() - 600.0) < 1e-9);
}

void TestWidgetsLive::zoom_byTheUser_staysUntilFit()
{
    Live view;
    view.stream(0.0, 1200.0);
    QTest::qWait(10);
    view.interaction().zoomBy(0.1);
    QVERIFY(!view.isFollowing());
    const QCPRange zoomed = view.keys();
    view.stream(1200.0, 1800.0);
    QCOMPARE(view.keys().lower, zoomed.lower);
    QTest::mouseDClick(&view.plot(), Qt::LeftButton, Qt::NoModifier,
                       view.plot().axisRects().front()->center());
    QVERIFY(view.isFollowing());
    QCOMPARE(view.keys().upper, 11100.0);
}

void TestWidgetsLive::quantity_tde_isRateLessReference()
{
    Live view;
    view.stream(0.0, 1200.0);
    view.setQuantity(LiveQuantity::Tde);
    view.refresh();
    QVERIFY(view.values(2).contains(0.0) && view.values(2).upper < 5.0);
    QVERIFY(view.svg().contains(QStringLiteral("z TDE (dps)")));
}

void TestWidgetsLive::gap_samplesLost_lineBreaksAndIsNamed()
{
    Live view;
    view.stream(0.0, 600.0);
    const auto entries = view.legend();
    view.addGap({599.9, 1200.0, 6000, QStringLiteral("unplugged")});
    view.stream(1200.0, 1800.0);
    QVERIFY(view.legend().size() == entries.size() + 1);
    const QVector<double> means = view.table().columns[2].numbers;
    QVERIFY(std::any_of(means.begin(), means.end(), [](double mean) { return std::isnan(mean); }));
    const QCPAxisRect &panel = *view.plot().axisRects().front();
    const double x = panel.axis(QCPAxis::atBottom)->coordToPixel(599.9);
    const LiveMarks &marks = view.marks();
    const QString text = marks.textAt({x, panel.top() - 4.0});
    QVERIFY2(text.contains(QStringLiteral("0:09:59")) && text.contains(QStringLiteral("unplugged")),
             qPrintable(text));
    QVERIFY(marks.textAt({x + 40.0, panel.top() - 4.0}).isEmpty());
    view.refresh();
    const QImage picture = view.grab().toImage();
    const auto middle = static_cast<int>((x + panel.axis(QCPAxis::atBottom)->coordToPixel(1200.0)) / 2.0);
    QCOMPARE(picture.pixelColor(middle, panel.top() + 3), lightPalette().page);
}

void TestWidgetsLive::events_many_areBounded()
{
    Live view;
    view.stream(0.0, 60.0);
    for (int i = 0; i < 20'000; ++i) {
        view.addGap({double(i), i + 0.5, 3, {}});
        view.addEvent(double(i), QStringLiteral("saturated on x"));
    }
    const LiveMarks &marks = view.marks();
    std::int64_t lost = 0;
    QVERIFY(marks.gaps.size() <= LiveMarks::kMostMarks);
    QVERIFY(marks.events.size() <= LiveMarks::kMostMarks);
    for (std::size_t i = 0; i < marks.gaps.size(); ++i) {
        lost += marks.gaps[i].lostSamples;
        QVERIFY(i == 0 || marks.gaps[i].startS > marks.gaps[i - 1].startS);
    }
    QCOMPARE(lost, std::int64_t{60'000}); // none is hidden
}

void TestWidgetsLive::pending_partNotRecorded_hasThePageColour()
{
    Live view;
    view.stream(0.0, 5400.0);
    const QImage picture = view.grab().toImage();
    const QCPAxisRect &panel = *view.plot().axisRects().front();
    QCOMPARE(picture.pixelColor(panel.right() - 20, panel.top() + 3), lightPalette().page);
    QCOMPARE(picture.pixelColor(panel.left() + 20, panel.top() + 3), lightPalette().base);
    view.setFinished(true);
    view.refresh();
    QCOMPARE(view.grab().toImage().pixelColor(panel.right() - 5, panel.top() + 2), lightPalette().base);
}

void TestWidgetsLive::table_visible_hasEveryTrace()
{
    Live view;
    view.stream(0.0, 3600.0);
    const PlotTable table = view.table();
    QCOMPARE(table.columns.size(), std::size_t{1 + 3 * 7});
    for (const PlotTable::Column &column : table.columns)
        QCOMPARE(column.numbers.size(), table.rows());
    for (qsizetype i = 0; i < table.rows(); ++i) {
        const auto at = [&](std::size_t column) { return table.columns[column].numbers[i]; };
        QVERIFY(at(1) <= at(2) && at(2) <= at(3));
    }
}

void TestWidgetsLive::plan_none_runGrowsWithTheSamples()
{
    Live view;
    view.setPlan(std::nullopt);
    view.refresh();
    QCOMPARE(view.keys().upper, 60.0);
    view.stream(0.0, 600.0);
    QVERIFY(view.keys().upper >= 600.0 && view.keys().upper < 800.0);
}

void TestWidgetsLive::clear_newRun_startsAnew()
{
    Live view;
    view.stream(0.0, 600.0);
    view.cursors().place(Cursor::A, 100.0);
    view.addGap({1.0, 2.0, 1, {}});
    view.setPaused(true);
    view.clear();
    QVERIFY(view.isEmpty() && !view.isPaused() && !view.reading(Cursor::A));
    view.stream(0.0, 60.0);
    QCOMPARE(view.traces().samples(), 600);
}

void TestWidgetsLive::look_dark_isDark()
{
    Live view;
    view.stream(0.0, 7200.0);
    view.look = darkPalette();
    view.setLook(darkPalette());
    view.cursors().place(Cursor::A, 3000.0);
    view.refresh();
    keep(view, "live-dark");
    const QImage picture = view.grab().toImage();
    QCOMPARE(picture.pixelColor(2, 2), darkPalette().base);
    QCOMPARE(view.keys().upper, 11100.0);
}

void TestWidgetsLive::msdTrend_beforeAndAfter_drawsBoth()
{
    MsdTrendView view;
    QVERIFY(view.isEmpty());
    for (int i = 1; i < 20'000; ++i) {
        const double grown = 1e-6 * i * i;
        view.append(0.25 * i, Eigen::Vector3d(grown, 2.0 * grown, 0.1 * grown),
                    Eigen::Vector3d::Constant(0.02));
    }
    view.showTrend();
    QVERIFY(!view.isEmpty());
    view.resize(280, 280);
    const QString svg =
        QString::fromUtf8(plotAsSvg(view.plot(), {280, 280}, lightPalette().base, QStringLiteral("msd")));
    QVERIFY(svg.contains(QStringLiteral(">xyz<")));
    QVERIFY(view.plot().axisRects().front()->graphs().front()->dataCount() <= 1200);
    view.clear();
    QVERIFY(view.isEmpty());
}

QTEST_MAIN(TestWidgetsLive)
#include "tst_widgets_live.moc"
