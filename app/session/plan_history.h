// Undo and redo of edits of the calibration plan: one value a step, so that an undo gives back exactly the
// plan that was. An edit that changes nothing leaves no step; an edit after an undo drops what could be
// redone.
#pragma once

#include "app/session/calibration_plan.h"

#include <QString>

#include <cstddef>
#include <vector>

namespace driftbench {

class PlanHistory
{
public:
    static constexpr std::size_t kMostSteps = 200;

    explicit PlanHistory(CalibrationPlan plan = {}) : m_plan(std::move(plan)) {}

    const CalibrationPlan &plan() const { return m_plan; }

    // text: what the edit does, for the menu: "exclude 12 s of run 2". False: the plan is the same.
    bool edit(CalibrationPlan plan, const QString &text);
    bool undo();
    bool redo();
    bool canUndo() const { return !m_undo.empty(); }
    bool canRedo() const { return !m_redo.empty(); }
    QString undoText() const { return canUndo() ? m_undo.back().text : QString(); }
    QString redoText() const { return canRedo() ? m_redo.back().text : QString(); }

    // Not an edit: runs came or went. The plans that can be undone or redone follow.
    void fitToRuns(const std::vector<RunRecord> &runs);
    void reset(CalibrationPlan plan); // with no steps

private:
    struct Step
    {
        CalibrationPlan plan; // before (undo) or after (redo) the edit
        QString text;
    };

    bool step(std::vector<Step> &from, std::vector<Step> &to);

    CalibrationPlan m_plan;
    std::vector<Step> m_undo;
    std::vector<Step> m_redo;
};

} // namespace driftbench
