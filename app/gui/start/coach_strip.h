// The strip under the pages that speaks for the guided tour: where one is, what the step is about, Next,
// Skip, End, each with a key while the tour goes on.
#pragma once

#include <QFrame>

#include <array>

class QAction;

namespace driftbench {

class ActionButton;
class GuidedTour;
class TextLabel;

class CoachStrip : public QFrame
{
    Q_OBJECT

public:
    explicit CoachStrip(GuidedTour &tour, QWidget *parent = nullptr);

    // Next, Skip, End tour.
    const std::array<QAction *, 3> &tourActions() const { return m_actions; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void buildActions();
    void showTexts();
    void showStep();
    void enableNext(bool enabled);

    GuidedTour &m_tour;
    TextLabel *m_count;
    TextLabel *m_what;
    TextLabel *m_why;
    ActionButton *m_nextButton = nullptr;
    QAction *m_next;
    QAction *m_skip;
    QAction *m_end;
    std::array<QAction *, 3> m_actions;
};

} // namespace driftbench
