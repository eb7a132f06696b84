// Allan deviation before and after compensation, for each axis, over the averaging time (both logarithmic):
// noise falls with the time, drift rises with it, and compensation must lower the right end.
#pragma once

#include "engine/evaluation/allan.h"
#include "widgets/plot/plot_view.h"

namespace driftbench {

struct AllanData
{
    AllanCurve before;
    AllanCurve after;
    QString afterText; // what compensated it
};

class AllanView : public PlotView
{
    Q_OBJECT

public:
    explicit AllanView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    void setData(AllanData shown);

    QSize figureSize() const override { return {1040, 320}; }

protected:
    void build() override;

private:
    AllanData m_data;
};

} // namespace driftbench
