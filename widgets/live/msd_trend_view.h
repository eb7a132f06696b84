// The running MSD of the three axes over the time of a run, before and after the model, on a logarithmic
// axis.
#pragma once

#include "widgets/plot/plot_view.h"

#include <Eigen/Core>
#include <QVector>

#include <array>

namespace driftbench {

class MsdTrendView : public PlotView
{
    Q_OBJECT

public:
    explicit MsdTrendView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    void clear();
    // One point of each; after may be NaN (no model). Thinned by half when there are many.
    void append(double timeS, const Eigen::Vector3d &beforeDps2, const Eigen::Vector3d &afterDps2);
    void showTrend(); // what was appended, drawn anew

    QSize figureSize() const override { return {280, 280}; }

protected:
    void build() override;

private:
    QVector<double> m_timeS;
    std::array<QVector<double>, 3> m_before, m_after;
    qint64 m_every = 1; // of the points that come, one in so many is kept
    qint64 m_come = 0;
};

} // namespace driftbench
