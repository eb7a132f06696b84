// How long the window does not answer while it works: the whole window, with the longest time that its event
// loop was held up and the most memory that it took during each piece of work.
//
//   driftbench-gui-bench FOLDER LOG...    QT_QPA_PLATFORM=offscreen, or a display
//
// The logs are the runs of a campaign; in FOLDER a session of 50 million samples is made (another process
// makes it, so that memory is that of the window), and the reports are written.
#include "app/gui/pages/compare_page.h"
#include "app/gui/pages/inspect_page.h"
#include "bench/gyro_stream.h"
#include "support/event_loop_watchdog.h"
#include "support/gui_window.h"

#include <QApplication>
#include <QFile>

#include <cstdio>
#include <cstring>
#include <functional>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace driftbench;

namespace {

constexpr std::int64_t kLarge = 50'000'000;
constexpr double kRisingC = 40.0;
constexpr int kPatienceMs = 600'000;
constexpr int kSettleMs = 500;

double statusMegabytes(const char *name)
{
    QFile status(QStringLiteral("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly))
        return 0.0;
    for (const QByteArray &line : status.readAll().split('\n')) {
        if (line.startsWith(name))
            return line.mid(qsizetype(std::strlen(name)) + 1).trimmed().split(' ').front().toDouble() /
                   1024.0;
    }
    return 0.0;
}

// From now on VmHWM is the most that the program takes at a time.
void forgetMostMemory()
{
    QFile references(QStringLiteral("/proc/self/clear_refs"));
    if (references.open(QIODevice::WriteOnly))
        references.write("5");
}

// Begins, waits until it is done, and lets what follows from it be painted.
void measure(const char *what, const std::function<void()> &begin, const std::function<bool()> &done)
{
    forgetMostMemory();
    test::EventLoopWatchdog watchdog;
    QElapsedTimer clock;
    clock.start();
    begin();
    if (!QTest::qWaitFor(done, kPatienceMs))
        bench::fail(std::string(what) + ": not done");
    const double tookS = double(clock.elapsed()) / 1e3;
    QTest::qWait(kSettleMs);
    watchdog.stop();
    std::printf(
        "%-42s %7.2f s, held up at most %6.1f ms (computing %6.1f), memory %5.0f MB, at most %5.0f MB\n",
        what, tookS, watchdog.longestBlockMs(), watchdog.longestBusyMs(), statusMegabytes("VmRSS:"),
        statusMegabytes("VmHWM:"));
    std::fflush(stdout);
}

void makeLarge(const std::filesystem::path &path)
{
    std::filesystem::remove(path);
    const pid_t maker = ::fork();
    if (maker < 0)
        bench::fail("can't start a process");
    if (maker == 0) {
        bench::importStream(path, bench::GyroStream(kRisingC, kLarge), kLarge);
        std::_Exit(0);
    }
    int status = 0;
    if (::waitpid(maker, &status, 0) != maker || status != 0)
        bench::fail("the large session was not made");
}

// Devices that take their time to be listed, as a hub that is waking up does.
HidAccess slowDevices(std::atomic<int> &looked)
{
    HidAccess access = hidDevicesOfThisComputer();
    access.list = [&looked, list = access.list] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        auto found = list();
        ++looked;
        return found;
    };
    return access;
}

void trainAll(Workbench &bench, const char *what)
{
    measure(
        what,
        [&] {
            if (const Status started = bench.train(); !started)
                bench::fail(started.error().message);
        },
        [&] { return bench.session().result() && !bench.training().isRunning(); });
}

void measureCampaign(test::GuiWindow &window, const std::vector<std::filesystem::path> &logs)
{
    Workbench &bench = *window.bench;
    MainWindow &main = window.main();
    const auto inspected = [&] {
        auto &page = static_cast<InspectPage &>(*main.page(Step::Inspect));
        return page.seen() && page.seen()->prepared == bench.session().prepared();
    };
    measure(
        "reading the logs, preparing, Inspect", [&] { main.openFiles(logs); },
        [&] { return bench.session().runs().size() == logs.size() && inspected(); });
    measure(
        "page Train", [&] { main.showStep(Step::Train); }, [] { return true; });
    trainAll(bench, "training, all models");
    measure(
        "page Compare", [&] { main.showStep(Step::Compare); }, [] { return true; });
}

void measureReport(test::GuiWindow &window, const std::filesystem::path &file)
{
    auto &page = static_cast<ComparePage &>(*window.main().page(Step::Compare));
    std::filesystem::remove(file);
    measure(("report " + file.extension().string()).c_str(), [&] { page.writeReport(file); },
            [&] { return std::filesystem::exists(file) && page.banners().holds(QStringLiteral("report")); });
    std::filesystem::remove(file);
}

void measureLarge(test::GuiWindow &window, const std::filesystem::path &file)
{
    Workbench &bench = *window.bench;
    MainWindow &main = window.main();
    auto &inspect = static_cast<InspectPage &>(*main.page(Step::Inspect));
    measure(
        "opening a session of 50 M samples", [&] { main.openFiles({file}); },
        [&] { return !bench.session().isUnnamed(); });
    measure(
        "reading them, preparing, Inspect", [&] { main.showStep(Step::Inspect); },
        [&] {
            return bench.session().prepared() && inspect.seen() &&
                   inspect.seen()->prepared == bench.session().prepared();
        });
    trainAll(bench, "training all models on them");
    measure(
        "closing that session",
        [&] {
            if (const Status made = bench.newSession(); !made)
                bench::fail(made.error().message);
        },
        [] { return true; });
}

} // namespace

int main(int argc, char **argv)
{
    if (argc < 3)
        bench::fail("usage: driftbench-gui-bench FOLDER LOG...");
    // A log that can't be read would be waited for without end.
    for (int log = 2; log < argc; ++log) {
        if (!std::filesystem::is_regular_file(argv[log]))
            bench::fail(std::string("There is no log ") + argv[log] + "; give logs that exist.");
    }
    const std::filesystem::path folder = argv[1];
    const std::filesystem::path large = folder / "large.driftbench";
    makeLarge(large);
    const QApplication application(argc, argv);
    std::atomic<int> looked{0};
    test::GuiWindow window({}, slowDevices(looked));
    measure(
        "empty window", [] {}, [] { return true; });
    measure(
        "looking for devices (300 ms each), 3 times", [&] { window.bench->lookAgain(); },
        [&] {
            static int asked = looked;
            if (looked > asked) {
                asked = looked;
                window.bench->lookAgain();
            }
            return looked >= 4;
        });
    measureCampaign(window, {argv + 2, argv + argc});
    measureReport(window, folder / "report.pdf");
    measureReport(window, folder / "report.html");
    measure(
        "page Export", [&] { window.main().showStep(Step::Export); }, [] { return true; });
    measureLarge(window, large);
    std::printf("%s\n", qPrintable(QGuiApplication::platformName()));
    std::filesystem::remove(large);
    return 0;
}
