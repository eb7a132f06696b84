// The temperature-correlated quantities dT, dT^2, dT^(1/2) and the TDE of the three axes over the time of one
// run (Fig. 7 of the paper): the quantities left, the axes right, all over the same time.
#pragma once

#include "engine/features/run_features.h"
#include "widgets/plot/decimation.h"
#include "widgets/plot/plot_view.h"

#include <array>
#include <memory>

namespace driftbench {

// What is drawn: dT, dT^2, signed root, then TDE of x, y, z, in seconds since the start. Made of long runs
// off the thread of the window.
struct TcqTimeTraces
{
    double spanS = 0.0;
    std::array<Envelope, 6> traces;
};
TcqTimeTraces tcqTimeTraces(const RunFeatures &run);

class TcqTimeView : public PlotView
{
    Q_OBJECT

public:
    explicit TcqTimeView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    void setRun(std::shared_ptr<const RunFeatures> run); // null: nothing to show

    void setTraces(TcqTimeTraces traces);

    QSize figureSize() const override { return {1040, 560}; }

protected:
    void build() override;

private:
    TcqTimeTraces m_shown;
};

} // namespace driftbench
