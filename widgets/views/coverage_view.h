// Where the temperature has been: seconds in each degree, heating upwards, cooling downwards; the part of the
// wanted range that was not reached is shaded.
#pragma once

#include "engine/evaluation/campaign_inspection.h"
#include "widgets/plot/plot_view.h"

#include <optional>

namespace driftbench {

class CoverageView : public PlotView
{
    Q_OBJECT

public:
    explicit CoverageView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    // wanted: the plan's range; nothing: that of the data.
    void setData(TemperatureCoverage coverage, std::optional<std::pair<double, double>> wantedC);
    void setSelection(const std::optional<std::pair<double, double>> &rangeC);

    QSize figureSize() const override { return {296, 152}; }

signals:
    void selected(double lowestC, double highestC); // at the end of a drag

protected:
    void build() override;

private:
    TemperatureCoverage m_coverage;
    std::optional<std::pair<double, double>> m_wantedC, m_selectedC;
};

} // namespace driftbench
