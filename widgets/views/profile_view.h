// The set-points of one run of a test plan over time, with what its parts are: holds, and the steps of its
// ramps.
#pragma once

#include "engine/physics/test_plan.h"
#include "widgets/plot/plot_view.h"

#include <optional>

namespace driftbench {

class ProfileView : public PlotView
{
    Q_OBJECT

public:
    explicit ProfileView(const Palette &look, QWidget *parent = nullptr);

    void setPlan(const std::optional<TestPlan> &plan); // one that checkTestPlan accepts, or nothing

    QSize figureSize() const override { return {768, 240}; }

protected:
    void build() override;

private:
    std::optional<TestPlan> m_plan;
};

} // namespace driftbench
