// The two panels under the profile: how far the chamber may step, and how fast, each with its terms as the
// paper prints them and in SI units.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/test_plan.h"
#include "widgets/controls/panel.h"

namespace driftbench {

class ReadoutGrid;
class Rule;
class StateWord;
class TextLabel;
class TransientView;

class IntervalPanel : public Panel
{
    Q_OBJECT

public:
    explicit IntervalPanel(QWidget *parent = nullptr);

    void setPlan(const TestPlan &plan); // nothing of it that can't be is shown
    const ReadoutGrid &figures() const { return *m_terms; }

private:
    ReadoutGrid *m_terms;
    ReadoutGrid *m_ratio;
    TextLabel *m_used;
    StateWord *m_verdict;
    TextLabel *m_remark;
};

class PeriodPanel : public Panel
{
    Q_OBJECT

public:
    explicit PeriodPanel(QWidget *parent = nullptr);

    void setPlan(const TestPlan &plan);
    const ReadoutGrid &figures() const { return *m_terms; }
    TransientView &transient() const { return *m_transient; }

private:
    ReadoutGrid *m_terms;
    TransientView *m_transient;
};

} // namespace driftbench
