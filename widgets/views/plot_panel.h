// A view in a panel of a page: its legend as a row above, mouse and keys on, following light and dark.
#pragma once

#include <QWidget>

class QHBoxLayout;

namespace driftbench {

class LegendRow;
class PlotView;

class PlotPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PlotPanel(PlotView *view, QWidget *parent = nullptr); // takes the view

    void addBeforeLegend(QWidget *control);
    void addAfterLegend(QWidget *control);

protected:
private:
    void showLegend();

    PlotView *m_view;
    LegendRow *m_legend;
    QHBoxLayout *m_head;
};

} // namespace driftbench
