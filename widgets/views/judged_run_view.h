// A held-out run as it is judged, one column an axis: what is left over time before (less the constant) and
// after the model with the limit, below it the Allan deviation of both. Each trace has its own ticks, or the
// signal of a good axis would be hidden by that of a bad one.
#pragma once

#include "engine/evaluation/judged_traces.h"
#include "widgets/plot/plot_view.h"

#include <memory>
#include <optional>

namespace driftbench {

struct JudgedRunData
{
    std::shared_ptr<const JudgedTraces> traces; // null: nothing to show
    std::optional<double> limitDps;
};

class JudgedRunView : public PlotView
{
    Q_OBJECT

public:
    explicit JudgedRunView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    void setData(JudgedRunData shown);

    QSize figureSize() const override { return {1064, 348}; }

protected:
    void build() override;

private:
    void buildLegend();
    void drawTrace(QCPAxisRect &rect, int axis) const;
    void drawAllan(QCPAxisRect &rect, int axis) const;

    JudgedRunData m_data;
};

} // namespace driftbench
