// The worst error of a compensation table in each cell, one panel an axis, logarithmic in mdps: against the
// bound that interpolation and fixed point together keep, and the limit that was asked for.
#pragma once

#include "widgets/plot/plot_view.h"
#include "widgets/tables/knots_table_model.h"

#include <memory>

namespace driftbench {

class TableErrorView : public PlotView
{
    Q_OBJECT

public:
    explicit TableErrorView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    // limitMdps: NaN where none was asked for.
    void setData(std::shared_ptr<const KnotsTableData> shown, double limitMdps);

    QSize figureSize() const override { return {1040, 260}; }

protected:
    void build() override;

private:
    void drawAxis(QCPAxisRect &rect, int axis) const;

    std::shared_ptr<const KnotsTableData> m_data;
    double m_limitMdps = 0.0;
};

// Two tables over temperature, less each other: what would change on the device. Axes by their dash.
class TableDifferenceView : public PlotView
{
    Q_OBJECT

public:
    explicit TableDifferenceView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    // fresh less current, where both are; null: nothing to show.
    void setData(std::shared_ptr<const CompensationTable> current,
                 std::shared_ptr<const CompensationTable> fresh);

    QSize figureSize() const override { return {320, 220}; }

protected:
    void build() override;

private:
    std::shared_ptr<const CompensationTable> m_current;
    std::shared_ptr<const CompensationTable> m_fresh;
};

} // namespace driftbench
