// Curves over one quantity in panels side by side: for physics, where a panel has its own quantity and unit
// and no axis of the gyro. The same role has the same pen in every panel.
#pragma once

#include "widgets/plot/plot_view.h"
#include "widgets/style/role_pens.h"

#include <QVector>

#include <vector>

namespace driftbench {

struct CurveSeries
{
    QString label; // in the margin, where the curve ends; empty: none
    Role role = Role::Compensated;
    QVector<double> keys;
    QVector<double> values;
};

struct CurvePanel
{
    QString name;
    QString note;
    QString keyLabel;
    QString valueLabel;
    bool zeroLine = false;
    std::vector<CurveSeries> curves;
};

class CurvePanelsView : public PlotView
{
    Q_OBJECT

public:
    CurvePanelsView(const QString &accessibleName, const Palette &look, QWidget *parent = nullptr);

    // Row by row, so many panels in a row.
    void setPanels(std::vector<CurvePanel> panels, int columns);

    QSize figureSize() const override;

protected:
    void build() override;

private:
    void buildPanel(QCPAxisRect &rect, const CurvePanel &panel) const;

    std::vector<CurvePanel> m_panels;
    int m_columns = 1;
};

} // namespace driftbench
