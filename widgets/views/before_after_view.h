// A run before and after compensation (Figs. 10-11 of the paper): for each axis the rate as lowest, highest
// and mean of every stretch of time, the reference rate dashed, and the temperature below.
#pragma once

#include "widgets/plot/plot_view.h"

#include <Eigen/Core>

namespace driftbench {

struct BeforeAfterData
{
    Eigen::VectorXd timeS;        // N
    Eigen::VectorXd temperatureC; // N, or empty: no strip for it
    Eigen::MatrixX3d beforeDps;   // N x 3, rates
    Eigen::MatrixX3d afterDps;    // N x 3
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    QString afterText; // what compensated it: "RBF network trained on run2, run3"
};

class BeforeAfterView : public PlotView
{
    Q_OBJECT

public:
    explicit BeforeAfterView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    void setData(BeforeAfterData shown);

    QSize figureSize() const override { return {1040, 640}; }

protected:
    void build() override;

private:
    void drawAxis(QCPAxisRect &rect, int axis) const;
    void drawTemperature(QCPAxisRect &rect) const;

    BeforeAfterData m_data;
};

} // namespace driftbench
