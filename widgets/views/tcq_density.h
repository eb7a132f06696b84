// How many samples lie where in the plane of ΔT and TDE, by the direction of the temperature. Drawn instead
// of dots where these would cover each other: what is frequent is dark, and every sample counts.
#pragma once

#include "engine/features/run_features.h"
#include "widgets/views/model_curve.h"

#include <Eigen/Core>
#include <QColor>
#include <QString>

#include <array>
#include <memory>
#include <vector>

class QCPAxisRect;

namespace driftbench {

struct DensityGrid
{
    double lowestDeltaT = 0.0, highestDeltaT = 0.0; // edges of the first and the last column
    double lowestDps = 0.0, highestDps = 0.0;       // edges of the first and the last row
    Eigen::MatrixXi samples;                        // rows (dps) x columns (ΔT); empty: none

    bool empty() const { return samples.size() == 0; }
};

struct DirectedDensity
{
    DensityGrid heating, cooling;
};

struct TcqDensity
{
    std::array<DirectedDensity, 3> tde;      // by axis
    std::array<DirectedDensity, 3> residual; // what the curve leaves; empty without a curve
};

// From so many samples on a panel of dots is a blot.
inline constexpr Eigen::Index kDensityFrom = 20000;

// Of the samples usable for training. Where ΔT or value is not finite a sample is left out.
TcqDensity tcqDensity(const std::vector<std::shared_ptr<const RunFeatures>> &runs, const ModelCurve *curve);

// quantity: 0, 1, 2 for ΔT, ΔT² and the root. The fullest cell has the colour itself, others less by the
// logarithm of their samples.
void addDensity(QCPAxisRect &rect, const DensityGrid &grid, int quantity, const QColor &color,
                const QString &name);

} // namespace driftbench
