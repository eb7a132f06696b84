// driftbench: the workbench.
//
//   --bench-first-paint   prints the time from main() to the first paint of the window, and ends
#include "app/gui/app_context.h"
#include "app/gui/event_log.h"
#include "app/gui/main_window.h"
#include "widgets/style/theme.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTimer>

#include <cstdio>

int main(int argc, char **argv)
{
    using namespace driftbench;
    QElapsedTimer sinceStart;
    sinceStart.start();
    const QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("driftbench"));
    QApplication::setOrganizationName(QStringLiteral("driftbench"));
    QApplication::setApplicationDisplayName(QStringLiteral("Driftbench"));
    QApplication::setApplicationVersion(QStringLiteral(DRIFTBENCH_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("org.driftbench.Workbench"));

    Theme theme;
    EventLog events;
    Navigator navigator;
    AppContext context{theme, events, navigator};
    MainWindow window(context);
    if (QApplication::arguments().contains(QStringLiteral("--bench-first-paint"))) {
        window.onFirstPaint([&sinceStart] {
            std::printf("first paint after %lld ms\n", static_cast<long long>(sinceStart.elapsed()));
            QTimer::singleShot(0, qApp, &QCoreApplication::quit);
        });
    }
    window.show();
    return QApplication::exec();
}
