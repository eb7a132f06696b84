#include "app/gui/start/guided_tour.h"

namespace driftbench {

static constexpr int kLookMs = 200;

GuidedTour::GuidedTour(std::vector<TourStep> steps, QObject *parent)
    : QObject(parent), m_steps(std::move(steps))
{
    m_timer.setInterval(kLookMs);
    connect(&m_timer, &QTimer::timeout, this, &GuidedTour::look);
}

void GuidedTour::start()
{
    enter(0);
}

void GuidedTour::enter(int at)
{
    m_working = false;
    m_trouble.clear();
    m_timer.stop();
    if (at >= count()) {
        m_at = -1;
        emit changed();
        emit finished();
        return;
    }
    m_at = at;
    emit pageWanted(step().page);
    emit changed();
}

void GuidedTour::next()
{
    if (!isActive() || m_working)
        return;
    if (step().isDone && step().isDone())
        return enter(m_at + 1);
    if (!step().perform)
        return enter(m_at + 1);
    m_working = true;
    m_trouble.clear();
    m_timer.start();
    step().perform();
    if (!isActive() || !m_working)
        return;
    emit changed();
    look();
}

void GuidedTour::look()
{
    if (!isActive() || !m_working)
        return;
    if (!step().isDone || step().isDone())
        return enter(m_at + 1);
    if (step().trouble) {
        if (const QString sentence = step().trouble(); !sentence.isEmpty())
            return fail(sentence);
    }
    if (step().carryOn)
        step().carryOn();
    emit changed();
}

void GuidedTour::fail(const QString &sentence)
{
    if (!isActive() || !m_working)
        return;
    m_working = false;
    m_timer.stop();
    m_trouble = sentence;
    emit changed();
}

void GuidedTour::skip()
{
    if (isActive())
        enter(m_at + 1);
}

void GuidedTour::stop()
{
    if (isActive())
        enter(count());
}

} // namespace driftbench
