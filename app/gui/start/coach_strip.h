// The strip under the pages that speaks for the guided tour: where one is, what the step is about, Next,
// Skip, End.
#pragma once

#include <QFrame>

class QProgressBar;

namespace driftbench {

class ActionButton;
class GuidedTour;
class TextLabel;

class CoachStrip : public QFrame
{
    Q_OBJECT

public:
    explicit CoachStrip(GuidedTour &tour, QWidget *parent = nullptr);

    ActionButton &next() const { return *m_next; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void showStep();

    GuidedTour &m_tour;
    TextLabel *m_count;
    TextLabel *m_what;
    TextLabel *m_why;
    ActionButton *m_next;
    ActionButton *m_skip;
    ActionButton *m_end;
};

} // namespace driftbench
