// A legend as a row of the plot's layout, above the panels and never over data. It is part of the plot, so
// that pictures of the plot carry it.
#pragma once

#include "widgets/plot/legend_painter.h"

#include <qcustomplot.h>

namespace driftbench {

class LegendElement : public QCPLayoutElement
{
    Q_OBJECT

public:
    LegendElement(QCustomPlot *plot, std::vector<LegendEntry> entries, const Palette &palette);

    QSize minimumOuterSizeHint() const override;
    QSize maximumOuterSizeHint() const override;

protected:
    void applyDefaultAntialiasingHint(QCPPainter *painter) const override;
    void draw(QCPPainter *painter) override;

private:
    LegendPainter m_legend;
};

} // namespace driftbench
