// The temperature-correlated quantities dT, dT^2, dT^(1/2) and the TDE of the three axes over the time of one
// run (Fig. 7 of the paper): the quantities left, the axes right, all over the same time.
#pragma once

#include "engine/features/run_features.h"
#include "widgets/plot/plot_view.h"

#include <memory>

namespace driftbench {

class TcqTimeView : public PlotView
{
    Q_OBJECT

public:
    explicit TcqTimeView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    void setRun(std::shared_ptr<const RunFeatures> run); // null: nothing to show

    QSize figureSize() const override { return {1040, 560}; }

protected:
    void build() override;

private:
    std::shared_ptr<const RunFeatures> m_run;
};

} // namespace driftbench
