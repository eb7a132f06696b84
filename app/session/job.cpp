#include "app/session/job.h"

#include <chrono>
#include <memory>

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

ProgressHook Job::hook()
{
    using Clock = std::chrono::steady_clock;
    const auto next = std::make_shared<Clock::time_point>();
    return [this, next, post = sender()](const Progress &now) {
        if (Clock::now() >= *next) {
            *next = Clock::now() + std::chrono::milliseconds(50);
            post.post([this, text = std::string(now.stage), part = now.fraction] {
                m_stage = QString::fromStdString(text);
                m_fraction = part;
                emit progress(m_stage, m_fraction);
            });
        }
        return m_cancelled ? Flow::Stop : Flow::Continue;
    };
}

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
    m_thread = std::jthread([this, work = std::move(work), report = hook(), post = sender()] {
        Deliver deliver = work(report);
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
