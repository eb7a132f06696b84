// Plan: sensor, chamber and profile of a campaign, and what follows from them. Becomes the session's test
// plan when it is used.
#pragma once

#include "app/gui/page.h"
#include "engine/physics/test_plan.h"

#include <filesystem>

class QUndoStack;

namespace driftbench {

class IntervalPanel;
class PeriodPanel;
class PlanForm;
class ProfileView;
class SectionHead;
class Workbench;

class PlanPage : public Page
{
    Q_OBJECT

public:
    explicit PlanPage(AppContext &context, QWidget *parent = nullptr);
    ~PlanPage() override;

    StepState stepState() const override;
    QString hints() const override;
    QUndoStack *undoStack() const override { return m_undo; }

    TestPlan plan() const { return m_plan; }
    void edit(const TestPlan &plan); // as a user does it: can be undone
    void use();                      // makes it the session's
    Status openPlan(const std::filesystem::path &file);
    Status savePlan(const std::filesystem::path &file) const;
    Status saveControllerFile(const std::filesystem::path &file, bool ramps) const;

    const IntervalPanel &interval() const { return *m_interval; }
    const PeriodPanel &period() const { return *m_period; }
    ProfileView &profile() const { return *m_profile; }

protected:
    void retranslate() override;

private:
    friend class PlanEdit;

    QWidget *buildFigures();
    void buildActions();
    void show(const TestPlan &plan);
    void showFigures();
    void showStillAir();
    void takeSession();
    void askOpen();
    void askSave();
    void askController(bool ramps);
    void tell(const Status &outcome, const QString &what);

    TestPlan m_plan;
    QUndoStack *m_undo;
    PlanForm *m_form;
    SectionHead *m_runHead, *m_intervalHead, *m_periodHead;
    ProfileView *m_profile;
    IntervalPanel *m_interval;
    PeriodPanel *m_period = nullptr;
    QAction *m_use, *m_files, *m_open, *m_save, *m_steps, *m_ramps;
    QString m_dismissed; // the sentence of the banner that the user has closed
};

} // namespace driftbench
