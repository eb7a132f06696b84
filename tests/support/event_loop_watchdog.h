// How long the event loop of this thread was held up at worst, while something else goes on in it.
//
// A timer ticks every 2 ms; whatever keeps it waiting would have kept a click waiting as long. Beside the
// time that passed, the time that this thread computed in it is taken: on a busy machine the first says how
// busy the machine was, the second how much of it was our own doing. Waiting for a lock or a disk is in the
// first only.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <algorithm>
#include <ctime>

namespace driftbench::test {

class EventLoopWatchdog : public QObject
{
public:
    static constexpr int kTickMs = 2;

    explicit EventLoopWatchdog(QObject *parent = nullptr) : QObject(parent)
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        m_timer.setInterval(kTickMs);
        connect(&m_timer, &QTimer::timeout, this, [this] { tick(); });
        start();
    }

    void start() // from now on, forgetting what was
    {
        m_longestMs = m_longestBusyMs = 0.0;
        m_ticks = 0;
        m_since.start();
        m_cpuMs = threadCpuMs();
        m_timer.start();
    }
    void stop()
    {
        tick();
        m_timer.stop();
    }

    double longestBlockMs() const { return m_longestMs; }    // by the clock
    double longestBusyMs() const { return m_longestBusyMs; } // computing
    qint64 ticks() const { return m_ticks; }

private:
    static double threadCpuMs()
    {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return double(now.tv_sec) * 1e3 + double(now.tv_nsec) / 1e6;
    }

    void tick()
    {
        const double cpuMs = threadCpuMs();
        m_longestMs = std::max(m_longestMs, double(m_since.nsecsElapsed()) / 1e6 - kTickMs);
        m_longestBusyMs = std::max(m_longestBusyMs, cpuMs - m_cpuMs);
        m_cpuMs = cpuMs;
        m_since.start();
        ++m_ticks;
    }

    QTimer m_timer;
    QElapsedTimer m_since;
    double m_cpuMs = 0.0;
    double m_longestMs = 0.0;
    double m_longestBusyMs = 0.0;
    qint64 m_ticks = 0;
};

} // namespace driftbench::test
