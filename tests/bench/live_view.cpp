// The live view with an hour of history at 10 kHz, while 3 x 10 kHz go on: what a repaint costs, how long the
// event loop is held up, how much memory it takes.
//
//   driftbench-live-bench [hours] [frames]       QT_QPA_PLATFORM=offscreen, or a display
//
// A repaint is refresh() (pyramid, ranges, drawing) and the paint event that follows. Times are given by the
// clock and as time that the thread computed: on a busy machine only the second says something about us.
#include "support/event_loop_watchdog.h"
#include "widgets/live/live_trace_view.h"

#include <QApplication>
#include <QFile>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

using namespace driftbench;

namespace {

constexpr double kRateHz = 10'000.0;
constexpr int kRowsABatch = 400; // 40 ms

SampleBlock batchAt(double startS, Eigen::MatrixX3d &compensated)
{
    SampleBlock block = SampleBlock::withRows(kRowsABatch);
    compensated.resize(kRowsABatch, 3);
    static std::uint32_t state = 1;
    const auto noise = [] {
        state = state * 1664525U + 1013904223U;
        return double(state >> 8) / double(1 << 24) - 0.5;
    };
    for (Eigen::Index i = 0; i < kRowsABatch; ++i) {
        const double timeS = startS + double(i) / kRateHz;
        block.timeS[i] = timeS;
        block.temperatureC[i] = -40.0 + timeS / 60.0;
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const double still = 5.0 * double(axis) + noise();
            compensated(i, axis) = still;
            block.rateDps(i, axis) = still + 2.0 * std::sin(timeS / 900.0);
        }
    }
    return block;
}

double cpuMs()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) * 1e3 + double(now.tv_nsec) / 1e6;
}

double quantile(std::vector<double> values, double share)
{
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, static_cast<std::size_t>(share * double(values.size())))];
}

QByteArray statusLine(const char *name)
{
    QFile status(QStringLiteral("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly))
        return {};
    for (const QByteArray &line : status.readAll().split('\n')) {
        if (line.startsWith(name))
            return line.mid(qsizetype(std::strlen(name)) + 1).trimmed();
    }
    return {};
}

void measure(LiveTraceView &view, const char *name, int frames, double &timeS)
{
    std::vector<double> wall, cpu;
    Eigen::MatrixX3d compensated;
    test::EventLoopWatchdog watchdog;
    QElapsedTimer clock;
    for (int frame = 0; frame < frames; ++frame) {
        view.append(batchAt(timeS, compensated), compensated);
        timeS += kRowsABatch / kRateHz;
        clock.start();
        const double before = cpuMs();
        view.refresh();
        view.plot().repaint();
        cpu.push_back(cpuMs() - before);
        wall.push_back(double(clock.nsecsElapsed()) / 1e6);
        QApplication::processEvents();
    }
    watchdog.stop();
    std::printf("%-22s repaint median %5.2f p95 %5.2f max %5.2f ms  (computing: %5.2f %5.2f %5.2f)  "
                "event loop held up at most %5.2f ms (computing %5.2f)\n",
                name, quantile(wall, 0.5), quantile(wall, 0.95), quantile(wall, 1.0), quantile(cpu, 0.5),
                quantile(cpu, 0.95), quantile(cpu, 1.0), watchdog.longestBlockMs(), watchdog.longestBusyMs());
}

} // namespace

int main(int argc, char **argv)
{
    const QApplication application(argc, argv);
    const double hours = argc > 1 ? std::atof(argv[1]) : 1.0;
    const int frames = argc > 2 ? std::atoi(argv[2]) : 300;
    LiveTraceView view;
    view.setReference(Eigen::Vector3d(0.0, 5.0, 10.0));
    view.setCompensated(true);
    view.setPlan(*TemperatureProfile::named("paper"));
    view.resize(768, 562);
    Eigen::MatrixX3d compensated;
    double timeS = 0.0;
    const double filledFrom = cpuMs();
    while (timeS < hours * 3600.0) {
        view.append(batchAt(timeS, compensated), compensated);
        timeS += kRowsABatch / kRateHz;
    }
    std::printf("%s, %.0f samples of 7 traces in %.0f s, pyramid %.0f MB\n",
                qPrintable(QGuiApplication::platformName()), double(view.traces().samples()),
                (cpuMs() - filledFrom) / 1e3, double(view.traces().bytes()) / 1e6);
    view.show();
    QApplication::processEvents();
    view.cursors().place(Cursor::A, 0.3 * timeS);
    view.cursors().place(Cursor::B, 0.8 * timeS);
    measure(view, "run, 768 x 562", frames, timeS);
    view.setSpan(LiveSpan::TenMinutes);
    measure(view, "10 min, 768 x 562", frames, timeS);
    view.setSpan(LiveSpan::OneMinute);
    measure(view, "1 min, 768 x 562", frames, timeS);
    view.setSpan(LiveSpan::Run);
    view.resize(1408, 905);
    QApplication::processEvents();
    measure(view, "run, 1408 x 905", frames, timeS);
    std::printf("memory: at most %s\n", statusLine("VmHWM:").constData());
    return 0;
}
