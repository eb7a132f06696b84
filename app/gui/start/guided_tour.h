// A walk through the steps: each says what it is about, does the real thing on Next, and knows by the session
// when it is done. What the steps are is a list; this is the mechanism.
//
// No step hangs: one whose work has ended without what it was for, or was refused, says why and waits for
// Next, which does it again, or Skip.
#pragma once

#include "app/gui/step.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <vector>

namespace driftbench {

struct TourStep
{
    Step page = Step::Source;
    std::function<QString()> what{};  // one sentence, semibold
    std::function<QString()> why{};   // what it is for, one or two sentences
    std::function<void()> perform{};  // the real thing; may be empty: there is only something to see
    std::function<void()> carryOn{};  // asked for again and again until it is done, if it takes several goes
    std::function<bool()> isDone{};   // by what the session holds
    std::function<QString()> state{}; // while it works: "run 2 of 3"; may be empty
    // Why what is done so far can't go on, as a sentence that says what to do; empty: it can.
    std::function<QString()> trouble{};
};

class GuidedTour : public QObject
{
    Q_OBJECT

public:
    explicit GuidedTour(std::vector<TourStep> steps, QObject *parent = nullptr);

    void start();
    void next(); // does the step; goes on by itself when that is done
    void skip(); // to the next step, whatever this one holds
    void stop();
    void fail(const QString &sentence); // what the step was doing; nothing unless one works

    bool isActive() const { return m_at >= 0; }
    bool isWorking() const { return m_working; }
    const QString &trouble() const { return m_trouble; } // of this step; empty: none
    int at() const { return m_at; }
    int count() const { return static_cast<int>(m_steps.size()); }
    const TourStep &step() const { return m_steps[static_cast<std::size_t>(m_at)]; }

signals:
    void changed();  // another step, or its state
    void finished(); // after the last step, or stopped
    void pageWanted(driftbench::Step page);

private:
    void enter(int at);
    void look();

    std::vector<TourStep> m_steps;
    int m_at = -1;
    bool m_working = false;
    QString m_trouble;
    QTimer m_timer;
};

} // namespace driftbench
