#include "app/session/plan_history.h"

namespace driftbench {

bool PlanHistory::edit(CalibrationPlan plan, const QString &text)
{
    if (plan == m_plan)
        return false;
    m_undo.push_back({std::move(m_plan), text});
    if (m_undo.size() > kMostSteps)
        m_undo.erase(m_undo.begin());
    m_redo.clear();
    m_plan = std::move(plan);
    return true;
}

bool PlanHistory::step(std::vector<Step> &from, std::vector<Step> &to)
{
    if (from.empty())
        return false;
    Step step = std::move(from.back());
    from.pop_back();
    std::swap(step.plan, m_plan);
    to.push_back(std::move(step));
    return true;
}

bool PlanHistory::undo()
{
    return step(m_undo, m_redo);
}

bool PlanHistory::redo()
{
    return step(m_redo, m_undo);
}

void PlanHistory::fitToRuns(const std::vector<RunRecord> &runs)
{
    m_plan = fittedToRuns(std::move(m_plan), runs);
    for (std::vector<Step> *steps : {&m_undo, &m_redo}) {
        for (Step &step : *steps)
            step.plan = fittedToRuns(std::move(step.plan), runs);
        // A step about a run that is gone does nothing any more.
        const CalibrationPlan *next = &m_plan;
        for (std::size_t i = steps->size(); i-- > 0;) {
            if ((*steps)[i].plan == *next)
                steps->erase(steps->begin() + static_cast<std::ptrdiff_t>(i));
            else
                next = &(*steps)[i].plan;
        }
    }
}

void PlanHistory::reset(CalibrationPlan plan)
{
    *this = PlanHistory(std::move(plan));
}

} // namespace driftbench
