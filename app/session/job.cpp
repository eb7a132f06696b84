#include "app/session/job.h"

#include <chrono>
#include <string>
#include <utility>

namespace driftbench {

Job::Job(QObject *parent) : QObject(parent) {}

Job::~Job()
{
    cancelAndWait();
}

void Job::cancel()
{
    m_cancelled = true;
}

void Job::cancelAndWait()
{
    cancel();
    if (m_thread.joinable())
        m_thread.join();
}

// On the thread of the work: thins out what it reports.
class Job::Reporter
{
public:
    explicit Reporter(Job &job) : m_job(job), m_post(job.sender()) {}

    Flow take(const Progress &now)
    {
        m_stage = now.stage;
        m_fraction = now.fraction;
        m_untold = true;
        if (Clock::now() >= m_next)
            tell();
        return m_job.m_cancelled ? Flow::Stop : Flow::Continue;
    }
    void tell()
    {
        if (!std::exchange(m_untold, false))
            return;
        m_next = Clock::now() + std::chrono::milliseconds(50);
        m_post.post([job = &m_job, stage = m_stage, fraction = m_fraction] {
            job->m_stage = QString::fromStdString(stage);
            job->m_fraction = fraction;
            emit job->progress(job->m_stage, job->m_fraction);
        });
    }

private:
    using Clock = std::chrono::steady_clock;

    Job &m_job;
    OwnerMailbox::Sender m_post;
    std::string m_stage;
    double m_fraction = 0.0;
    bool m_untold = false;
    Clock::time_point m_next;
};

bool Job::run(Work work)
{
    if (m_running)
        return false;
    if (m_thread.joinable())
        m_thread.join();
    m_cancelled = false;
    m_running = true;
    m_stage.clear();
    m_fraction = 0.0;
    emit runningChanged(true);
    m_thread = std::jthread([this, work = std::move(work), post = sender()] {
        Reporter reporter(*this);
        Deliver deliver = work([&reporter](const Progress &now) { return reporter.take(now); });
        reporter.tell();
        post.post([this, deliver = std::move(deliver)] { finish(deliver); });
    });
    return true;
}

void Job::finish(const Deliver &deliver)
{
    m_thread.join();
    m_running = false;
    emit runningChanged(false);
    if (deliver)
        deliver();
}

bool TaskJob::start(std::function<Status(const ProgressHook &)> task)
{
    return run([this, task = std::move(task)](const ProgressHook &hook) -> Deliver {
        return [this, outcome = task(hook)] { emit finished(outcome); };
    });
}

} // namespace driftbench
