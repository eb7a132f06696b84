// How another thread reaches the objects of this one: closures are queued under a lock and run, in their
// order, by the event loop of the thread that the mailbox lives in. Once the mailbox is gone, what is posted
// is dropped; so a thread never calls a receiver that is dead.
//
//   OwnerMailbox mailbox;                        // a member, destroyed before what its closures use
//   std::jthread([sender = mailbox.sender()] { sender.post([this] { ... }); });
//
// Qt carries only the wake-up, all values go through the lock: so that a checker of threads can follow them.
#pragma once

#include <QObject>

#include <functional>
#include <memory>

namespace driftbench {

class OwnerMailbox : public QObject
{
private:
    struct State;

public:
    class Sender
    {
    public:
        void post(std::function<void()> closure) const; // from any thread

    private:
        friend class OwnerMailbox;
        explicit Sender(std::shared_ptr<State> state) : m_state(std::move(state)) {}

        std::shared_ptr<State> m_state;
    };

    explicit OwnerMailbox(QObject *parent = nullptr);
    ~OwnerMailbox() override;

    Sender sender() const { return Sender(m_state); }
    void deliver(); // what was posted so far, now

protected:
    void customEvent(QEvent *event) override;

private:
    std::shared_ptr<State> m_state;
};

} // namespace driftbench
