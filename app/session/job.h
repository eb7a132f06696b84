// Long work off the thread that owns it: progress comes as a signal, cancel() reaches the work at its next
// report, and the outcome is delivered to the owner's event loop. Destroying a job cancels it and waits for
// it.
//
// A job runs one piece of work at a time. The work gets only values: what it needs is copied or shared into
// it.
#pragma once

#include "app/session/owner_mailbox.h"
#include "engine/base/progress.h"
#include "engine/base/result.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <thread>

namespace driftbench {

class Job : public QObject
{
    Q_OBJECT

public:
    ~Job() override;

    bool isRunning() const { return m_running; }
    bool isCancelled() const { return m_cancelled; } // the running one, or the one before
    const QString &stage() const { return m_stage; }
    double fraction() const { return m_fraction; }

    void cancel();

signals:
    void runningChanged(bool running); // false: before the job's own signal of its outcome
    // At most 20 times a second, and how far the work was at its end.
    void progress(const QString &stage, double fraction);

protected:
    // Runs on the thread of the job; what it returns is called by the owner's thread at the end.
    using Deliver = std::function<void()>;
    using Work = std::function<Deliver(const ProgressHook &)>;

    explicit Job(QObject *parent);

    bool run(Work work); // false: it is still running
    // For derived destructors, so that no work outlives what it refers to.
    void cancelAndWait();
    OwnerMailbox::Sender sender() const { return m_mailbox.sender(); }

private:
    class Reporter;

    void finish(const Deliver &deliver);

    OwnerMailbox m_mailbox;
    std::atomic<bool> m_cancelled{false};
    bool m_running = false;
    QString m_stage;
    double m_fraction = 0.0;
    std::jthread m_thread;
};

// Any work with a Status: a copy of a session, a check of it, an export.
class TaskJob final : public Job
{
    Q_OBJECT

public:
    explicit TaskJob(QObject *parent = nullptr) : Job(parent) {}
    ~TaskJob() override { cancelAndWait(); }

    bool start(std::function<Status(const ProgressHook &)> task);

signals:
    void finished(const driftbench::Status &outcome); // Cancelled after cancel(), if the task heeds it
};

} // namespace driftbench
