// The frame of the window: rail, pages, menus, keys, colours.
#include "app/gui/app_context.h"
#include "app/gui/event_log.h"
#include "app/gui/main_window.h"
#include "app/gui/status_line.h"
#include "app/gui/step_rail.h"
#include "widgets/style/theme.h"

#include <QStandardPaths>
#include <QTest>

using namespace driftbench;

class TestGuiFrame : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void rail_everyStep_isNeverLocked();
    void keys_altAndNumber_showTheStep();
    void theme_switched_reachesEveryPalette();
};

namespace {

struct Window
{
    Theme theme;
    EventLog events;
    Navigator navigator;
    AppContext context{theme, events, navigator};
    MainWindow main{context};

    Window()
    {
        main.show();
        QVERIFY(QTest::qWaitForWindowExposed(&main));
    }
};

} // namespace

void TestGuiFrame::rail_everyStep_isNeverLocked()
{
    Window window;
    for (const Step step : kSteps) {
        const QModelIndex row = window.main.rail().model()->index(static_cast<int>(step), 0);
        QVERIFY(row.flags() & Qt::ItemIsEnabled);
        QTest::mouseClick(window.main.rail().viewport(), Qt::LeftButton, {},
                          window.main.rail().visualRect(row).center());
        QCOMPARE(window.main.currentStep(), step);
        QVERIFY(window.main.page(step)->isVisible());
        QVERIFY(!window.main.page(step)->hints().isEmpty());
    }
}

void TestGuiFrame::keys_altAndNumber_showTheStep()
{
    Window window;
    for (const Step step : {Step::Export, Step::Plan, Step::Record}) {
        QTest::keyClick(&window.main, Qt::Key(Qt::Key_1 + static_cast<int>(step)), Qt::AltModifier);
        QCOMPARE(window.main.currentStep(), step);
        QCOMPARE(window.main.rail().currentIndex().row(), static_cast<int>(step));
    }
}

void TestGuiFrame::theme_switched_reachesEveryPalette()
{
    Window window;
    for (const ThemeMode mode : {ThemeMode::Dark, ThemeMode::Light}) {
        window.theme.setMode(mode);
        QCoreApplication::processEvents();
        const Palette &wanted = mode == ThemeMode::Dark ? darkPalette() : lightPalette();
        const auto widgets = window.main.findChildren<QWidget *>();
        QVERIFY(!widgets.isEmpty());
        for (const QWidget *widget : widgets)
            QCOMPARE(lookOf(widget->palette()).dark, wanted.dark);
        QCOMPARE(window.main.grab().toImage().pixelColor(window.main.width() - 6, 400), wanted.page);
    }
}

QTEST_MAIN(TestGuiFrame)
#include "tst_gui_frame.moc"
