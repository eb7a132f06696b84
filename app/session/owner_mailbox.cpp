#include "app/session/owner_mailbox.h"

#include <QCoreApplication>
#include <QEvent>

#include <mutex>
#include <vector>

namespace driftbench {

struct OwnerMailbox::State
{
    std::mutex mutex;
    OwnerMailbox *owner = nullptr; // null once it is gone
    std::vector<std::function<void()>> closures;
};

OwnerMailbox::OwnerMailbox(QObject *parent) : QObject(parent), m_state(std::make_shared<State>())
{
    m_state->owner = this;
}

OwnerMailbox::~OwnerMailbox()
{
    std::vector<std::function<void()>> dropped; // destroyed outside the lock
    const std::lock_guard lock(m_state->mutex);
    m_state->owner = nullptr;
    dropped.swap(m_state->closures);
}

void OwnerMailbox::Sender::post(std::function<void()> closure) const
{
    const std::lock_guard lock(m_state->mutex);
    if (!m_state->owner)
        return;
    m_state->closures.push_back(std::move(closure));
    if (m_state->closures.size() == 1)
        QCoreApplication::postEvent(m_state->owner, new QEvent(QEvent::User));
}

void OwnerMailbox::customEvent(QEvent * /*event*/)
{
    deliver();
}

void OwnerMailbox::deliver()
{
    std::vector<std::function<void()>> closures;
    {
        const std::lock_guard lock(m_state->mutex);
        closures.swap(m_state->closures);
    }
    // A closure may destroy the mailbox with its owner.
    const std::shared_ptr<State> state = m_state;
    for (std::function<void()> &closure : closures) {
        {
            const std::lock_guard lock(state->mutex);
            if (!state->owner)
                return;
        }
        closure();
    }
}

} // namespace driftbench
