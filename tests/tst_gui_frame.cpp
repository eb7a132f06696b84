// The frame of the window: rail, pages, menus, keys, colours, the session as a file, files that are dropped.
#include "support/gui_window.h"

#include "app/gui/accessible_areas.h"
#include "app/gui/shortcut_overview.h"
#include "app/gui/start/guided_tour.h"
#include "app/gui/start/simulated_tour.h"
#include "app/gui/start/start_page.h"
#include "app/gui/status_line.h"
#include "app/gui/step_rail.h"
#include "engine/physics/test_plan.h"
#include "widgets/plot/plot_view.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTest>

#include <map>

using namespace driftbench;
using namespace driftbench::test;

class TestGuiFrame : public QObject
{
    Q_OBJECT

private slots:
    void rail_everyStep_isNeverLocked();
    void keys_altAndNumber_showTheStep();
    void theme_switched_reachesEveryPalette();
    void theme_darkFromTheStart_reachesEveryPlot();
    void statusLine_narrow_leavesOutWhatMay();
    void session_named_isSaidInTheCorner();
    void session_otherOpened_reachesTheRail();
    void plan_undone_byTheFramesAction();
    void shortcuts_noKeyTwiceOnOnePage();
    void controls_ofEveryPage_haveNames();
    void scrollArea_askedForAChildThatIsGone_hasNone();
    void window_small_scrolls();
    void start_firstTime_offersTheTour();
    void tour_steps_goOnWhenTheyAreDone();
    void tour_firstSteps_doTheRealThing();
};

static TestPlan paperPlan()
{
    return *makeTestPlan(*namedSensor("L3GD20H"), *namedChamber("SET-Z-021"));
}

void TestGuiFrame::rail_everyStep_isNeverLocked()
{
    GuiWindow window;
    for (const Step step : kSteps) {
        const QModelIndex row = window.main().rail().model()->index(static_cast<int>(step), 0);
        QVERIFY(row.flags() & Qt::ItemIsEnabled);
        QTest::mouseClick(window.main().rail().viewport(), Qt::LeftButton, {},
                          window.main().rail().visualRect(row).center());
        QCOMPARE(window.main().currentStep(), step);
        QVERIFY(window.main().page(step)->isVisible());
        QVERIFY(!window.main().page(step)->hints().isEmpty());
    }
}

void TestGuiFrame::keys_altAndNumber_showTheStep()
{
    GuiWindow window;
    for (const Step step : {Step::Export, Step::Plan, Step::Record}) {
        QTest::keyClick(&window.main(), Qt::Key(Qt::Key_1 + static_cast<int>(step)), Qt::AltModifier);
        QCOMPARE(window.main().currentStep(), step);
        QCOMPARE(window.main().rail().currentIndex().row(), static_cast<int>(step));
    }
}

void TestGuiFrame::theme_switched_reachesEveryPalette()
{
    GuiWindow window;
    for (const ThemeMode mode : {ThemeMode::Dark, ThemeMode::Light}) {
        window.theme.setMode(mode);
        QCoreApplication::processEvents();
        const Palette &wanted = mode == ThemeMode::Dark ? darkPalette() : lightPalette();
        for (const QWidget *widget : window.main().findChildren<QWidget *>())
            QCOMPARE(lookOf(widget->palette()).dark, wanted.dark);
        QCOMPARE(window.main().grab().toImage().pixelColor(window.main().width() - 6, 400), wanted.page);
    }
}

void TestGuiFrame::theme_darkFromTheStart_reachesEveryPlot()
{
    Settings settings;
    settings.theme = ThemeChoice::Dark;
    GuiWindow window(settings);
    const auto plots = window.main().findChildren<PlotView *>();
    QVERIFY(plots.size() > 8);
    for (const PlotView *plot : plots)
        QVERIFY2(plot->look().dark, qPrintable(plot->accessibleName()));
}

void TestGuiFrame::statusLine_narrow_leavesOutWhatMay()
{
    StatusLine line;
    line.setHints(QStringLiteral("Drag in the time strip to select"));
    line.setParts({{QStringLiteral("3 runs, 8 400 samples"), Tone::Plain},
                   {QStringLiteral("Simulated bridge"), Tone::Plain, 1},
                   {QStringLiteral("51 GB free"), Tone::Plain, 2},
                   {QStringLiteral("3 dropped of 400"), Tone::Caution}});
    line.resize(1280, 24);
    line.show();
    QCOMPARE(line.parts().size(), 4);
    qsizetype before = 4;
    for (int width = 1270; width > 200; width -= 10) {
        line.resize(width, 24);
        const QStringList parts = line.parts();
        QVERIFY(parts.size() <= before);
        before = parts.size();
        // The disk goes before the source, and neither what counts nor what is wrong.
        QVERIFY(parts.contains(QStringLiteral("Simulated bridge")) ||
                !parts.contains(QStringLiteral("51 GB free")));
        QVERIFY(parts.contains(QStringLiteral("3 runs, 8 400 samples")));
        QVERIFY(parts.contains(QStringLiteral("3 dropped of 400")));
    }
    QCOMPARE(before, 2);
    line.resize(1280, 24);
    QCOMPARE(line.parts().size(), 4);
}

void TestGuiFrame::session_named_isSaidInTheCorner()
{
    GuiWindow window;
    QVERIFY(window.main().sessionText().contains("not saved yet"));
    QVERIFY(window.bench->session().setTestPlan(paperPlan()).ok());
    const auto file = window.folder() / "five-runs.driftbench";
    QVERIFY(window.bench->saveSessionAs(file).ok());
    QCOMPARE(window.main().sessionText(), QString("Session: five-runs.driftbench · saved"));
    QCOMPARE(window.bench->settings().recentSessions.value(0), QString::fromStdString(file.string()));
}

void TestGuiFrame::session_otherOpened_reachesTheRail()
{
    GuiWindow window;
    QVERIFY(window.bench->session().setTestPlan(paperPlan()).ok());
    StepModel &steps = window.main().rail().steps();
    QCOMPARE(steps.state(Step::Plan).note, QString("−40 to 85 °C"));
    QCOMPARE(steps.state(Step::Plan).mark, StepMark::Done);
    const auto file = window.folder() / "plan.driftbench";
    QVERIFY(window.bench->saveSessionAs(file).ok());
    QVERIFY(window.bench->newSession().ok());
    QCOMPARE(steps.state(Step::Plan).mark, StepMark::None);
    window.main().openFiles({file});
    QCOMPARE(steps.state(Step::Plan).mark, StepMark::Done);
}

void TestGuiFrame::plan_undone_byTheFramesAction()
{
    GuiWindow window;
    window.main().showStep(Step::Plan);
    QAction *undo = window.context.actions.undo;
    QVERIFY(!undo->isEnabled());
    auto &page = static_cast<PlanPage &>(*window.main().page(Step::Plan));
    TestPlan changed = page.plan();
    changed.stepC = 1.0;
    page.edit(changed);
    QVERIFY(undo->isEnabled());
    undo->trigger();
    QCOMPARE(page.plan().stepC, 0.5);
    window.context.actions.redo->trigger();
    QCOMPARE(page.plan().stepC, 1.0);
    window.main().showStep(Step::Inspect);
    QVERIFY(!undo->isEnabled()); // the session has no edits
}

void TestGuiFrame::shortcuts_noKeyTwiceOnOnePage()
{
    GuiWindow window;
    std::map<QKeySequence, int> everywhere;
    for (const QAction *action : window.main().actions()) {
        for (const QKeySequence &keys : action->shortcuts())
            QCOMPARE(++everywhere[keys], 1);
    }
    for (const Step step : kSteps) {
        std::map<QKeySequence, int> seen = everywhere;
        for (const QAction *action : window.main().page(step)->pageActions()) {
            for (const QKeySequence &keys : action->shortcuts())
                QVERIFY2(++seen[keys] == 1, qPrintable(stepName(step) + ": " + keys.toString()));
        }
    }
}

void TestGuiFrame::controls_ofEveryPage_haveNames()
{
    GuiWindow window;
    for (const Step step : {Step::Source, Step::Plan}) {
        window.main().showStep(step);
        for (const QWidget *widget : window.main().page(step)->findChildren<QWidget *>()) {
            const bool inside = qobject_cast<const QAbstractSpinBox *>(widget->parentWidget()) ||
                                widget->objectName().startsWith("qt_");
            if (inside || !widget->isVisible() || !(widget->focusPolicy() & Qt::TabFocus))
                continue;
            const auto *button = qobject_cast<const QAbstractButton *>(widget);
            const bool named = !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
            const QWidget *parent = widget->parentWidget();
            QVERIFY2(named || (parent && !parent->accessibleName().isEmpty()),
                     qPrintable(stepName(step) + ": " + widget->metaObject()->className()));
        }
    }
}

// As a screen reader asks: it counted the children before a scroll bar went.
void TestGuiFrame::scrollArea_askedForAChildThatIsGone_hasNone()
{
    installAccessibleAreas();
    QScrollArea area;
    auto *inside = new QWidget;
    inside->setMinimumSize(2000, 2000);
    area.setWidget(inside);
    area.resize(200, 200);
    area.show();
    QCoreApplication::processEvents();
    QAccessibleInterface *told = QAccessible::queryAccessibleInterface(&area);
    QVERIFY(told != nullptr);
    const int before = told->childCount();
    QVERIFY(before >= 1);
    inside->setMinimumSize(10, 10);
    inside->resize(10, 10);
    QCoreApplication::processEvents();
    QVERIFY(told->childCount() <= before);
    for (const int index : {-1, told->childCount(), before + 5})
        QVERIFY(told->child(index) == nullptr);
    for (int index = 0; index < told->childCount(); ++index)
        QVERIFY(told->child(index) != nullptr);
}

void TestGuiFrame::window_small_scrolls()
{
    GuiWindow window;
    window.main().resize(800, 500);
    QCoreApplication::processEvents();
    QVERIFY(window.main().width() <= 800);
    QVERIFY(window.main().page(Step::Source)->width() >= 1080);
}

void TestGuiFrame::start_firstTime_offersTheTour()
{
    GuiWindow first;
    first.main().restoreSession();
    QVERIFY(first.main().isAtStart());
    QVERIFY(!first.main().rail().currentIndex().isValid());
    QTest::keyClick(&first.main(), Qt::Key_2, Qt::AltModifier);
    QVERIFY(!first.main().isAtStart());
    QCOMPARE(first.main().currentStep(), Step::Plan);

    Settings settings;
    settings.recentLogs << "/logs/run1.csv";
    GuiWindow later(settings);
    later.main().restoreSession();
    QVERIFY(!later.main().isAtStart());
}

void TestGuiFrame::tour_steps_goOnWhenTheyAreDone()
{
    int performed = 0;
    int carriedOn = 0;
    TourStep work{Step::Record};
    work.perform = [&] { ++performed; };
    work.carryOn = [&] { ++carriedOn; };
    work.isDone = [&] { return carriedOn >= 3; };
    TourStep look{Step::Compare};
    GuidedTour tour({work, look});
    QSignalSpy pages(&tour, &GuidedTour::pageWanted);
    QSignalSpy finished(&tour, &GuidedTour::finished);
    tour.start();
    QCOMPARE(tour.at(), 0);
    tour.next();
    QVERIFY(tour.isWorking());
    tour.next(); // while it works: nothing
    QCOMPARE(performed, 1);
    QTRY_COMPARE(tour.at(), 1);
    QCOMPARE(carriedOn, 3);
    tour.next(); // nothing to do there but to look
    QCOMPARE(finished.count(), 1);
    QVERIFY(!tour.isActive());
    QCOMPARE(pages.count(), 2);
}

void TestGuiFrame::tour_firstSteps_doTheRealThing()
{
    GuiWindow window;
    window.main().showStart();
    window.main().startPage().tour().click();
    QVERIFY(window.main().tour().isActive());
    QCOMPARE(window.main().currentStep(), Step::Source);
    window.main().tour().next();
    QTRY_COMPARE(window.main().tour().at(), 1);
    QVERIFY(window.bench->session().source()->as<SimulatedChoice>());
    QVERIFY(window.bench->session().source()->as<SimulatedChoice>()->speed > 100.0);
    window.main().tour().next();
    QTRY_COMPARE(window.main().tour().at(), 2);
    QCOMPARE(window.bench->session().testPlan()->runs, kTourRuns);
    QCOMPARE(window.main().currentStep(), Step::Record);
    window.main().tour().stop();
    QVERIFY(!window.main().tour().isActive());
}

QTEST_MAIN(TestGuiFrame)
#include "tst_gui_frame.moc"
