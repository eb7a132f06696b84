// driftbench: the workbench.
//
//   driftbench [FILES]     opens logs and sessions
//   --bench-first-paint    prints the time from main() to the first paint of the window, and ends
#include "app/gui/accessible_areas.h"
#include "app/gui/app_context.h"
#include "app/gui/event_log.h"
#include "app/gui/main_window.h"
#include "app/gui/workbench.h"
#include "app/language/language.h"
#include "widgets/controls/icon.h"
#include "widgets/style/theme.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>

#include <algorithm>
#include <cstdio>

namespace driftbench {

static ThemeMode modeOf(ThemeChoice choice)
{
    return choice == ThemeChoice::System  ? ThemeMode::System
           : choice == ThemeChoice::Light ? ThemeMode::Light
                                          : ThemeMode::Dark;
}

static std::filesystem::path sessionFolder()
{
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    return std::filesystem::path(data.toStdString()) / "sessions";
}

static const QString kFirstPaint = QStringLiteral("bench-first-paint");

// Ends the program for --help, --version and wrong options.
static void parse(QCommandLineParser &parser)
{
    QCoreApplication::setApplicationName(QStringLiteral("driftbench"));
    QCoreApplication::setOrganizationName(QStringLiteral("driftbench"));
    QCoreApplication::setApplicationVersion(QStringLiteral(DRIFTBENCH_VERSION));
    parser.setApplicationDescription(
        QStringLiteral("Calibrates the temperature drift of MEMS gyros. Headless: driftbench-cli."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOption({kFirstPaint, QStringLiteral("Prints the time to the first paint, and ends.")});
    parser.addPositionalArgument(QStringLiteral("files"), QStringLiteral("Logs and sessions to open."),
                                 QStringLiteral("[files...]"));
    parser.process(*QCoreApplication::instance());
}

// Without X or Wayland Qt ends the program with an abort.
static bool hasDisplay(int argc, char **argv)
{
#ifndef Q_OS_LINUX
    return true;
#endif
    for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        if (qEnvironmentVariableIsSet(name))
            return true;
    }
    return std::any_of(argv, argv + argc, [](const char *each) {
        return QByteArrayView(each).startsWith("-platform") || QByteArrayView(each).startsWith("--platform");
    });
}

static int sayNoDisplay(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parse(parser);
    std::fprintf(stderr,
                 "driftbench: There is no display to open the window on. Start it in a desktop session, or "
                 "use driftbench-cli.\n");
    return 1;
}

static int run(const QElapsedTimer &sinceStart)
{
    QCommandLineParser parser;
    parse(parser);
    installAccessibleAreas();
    QSettings store;
    const Settings settings = loadSettings(store);
    Language language;
    language.set(settings.language);
    Theme theme;
    theme.setMode(modeOf(settings.theme));
    EventLog events;
    Navigator navigator;
    auto bench = Workbench::create({sessionFolder()}, settings);
    if (!bench) {
        std::fprintf(stderr, "driftbench: %s\n", bench.error().message.c_str());
        return static_cast<int>(bench.error().code);
    }
    QObject::connect(bench->get(), &Workbench::settingsChanged, &store,
                     [&] { saveSettings((*bench)->settings(), store); });
    AppContext context{theme, events, navigator, bench->get()};
    MainWindow window(context, language);
    const bool timed = parser.isSet(kFirstPaint);
    window.onFirstPaint([&window, &sinceStart, timed, files = parser.positionalArguments()] {
        if (timed) {
            std::printf("first paint after %lld ms\n", static_cast<long long>(sinceStart.elapsed()));
            std::fflush(stdout);
            return QTimer::singleShot(0, qApp, &QCoreApplication::quit);
        }
        std::vector<std::filesystem::path> paths;
        for (const QString &file : files)
            paths.emplace_back(file.toStdString());
        if (!paths.empty())
            QTimer::singleShot(0, &window, [&window, paths] { window.openFiles(paths); });
    });
    window.restoreSession();
    window.show();
    return QApplication::exec();
}

} // namespace driftbench

int main(int argc, char **argv)
{
    QElapsedTimer sinceStart;
    sinceStart.start();
    if (!driftbench::hasDisplay(argc, argv))
        return driftbench::sayNoDisplay(argc, argv);
    QApplication application(argc, argv);
    QApplication::setApplicationDisplayName(QStringLiteral("Driftbench"));
    QApplication::setDesktopFileName(QStringLiteral("org.driftbench.Workbench"));
    QApplication::setWindowIcon(driftbench::applicationIcon());
    return driftbench::run(sinceStart);
}
