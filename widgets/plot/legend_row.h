// A legend above a plot, as a row of the window.
#pragma once

#include "widgets/plot/legend_painter.h"

#include <QWidget>

namespace driftbench {

class LegendRow : public QWidget
{
    Q_OBJECT

public:
    explicit LegendRow(QWidget *parent = nullptr);

    void setEntries(std::vector<LegendEntry> entries, const Palette &palette);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    LegendPainter m_legend;
};

} // namespace driftbench
