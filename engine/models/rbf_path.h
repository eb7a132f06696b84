// The path of greedy orthogonal least squares that all RBF networks of a training set are prefixes of.
//
// Aligned runs are merged and collapsed to a grid of about 500 rows (weight n, target mean TDE). Forced
// columns come first (1 and, in preset `best`, the three standardised TCQs); then Gaussians, one by one, each
// time the candidate with the largest  sum_a c_a^2 / (|p|^2 + lambda)  where p is the candidate made
// orthogonal to what is in, c_a = p . y_a, and targets are in units of each axis' noise (Chen, Cowan & Grant
// 1991, regularised as in Chen, Chng & Alkadhimi 1996). The network with K centres is the first K picks.
#pragma once

#include "engine/features/run_features.h"
#include "engine/models/rbf_network.h"
#include "engine/models/rbf_trainer.h"
#include "engine/models/standardiser.h"

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace driftbench {

// The rows that are fitted: one a cell.
struct ThermalRows
{
    Eigen::MatrixX3d quantities; // N x 3, cell means of the TCQs, not standardised
    Eigen::MatrixX3d tdeDps;     // N x 3, cell means
    Eigen::VectorXd count;       // N

    Eigen::Index size() const { return count.size(); }
    auto deltaT() const { return quantities.col(0); } // ascending
};

// Occupied cells of the curve in cells of `factor` times its width.
ThermalRows thermalRows(const ThermalCurve &curve, int factor);

// Cell width of the training grid as a multiple of the curve's own: span / 512, rounded up.
int trainingGridFactor(const ThermalCurve &curve);

struct RbfPathOptions
{
    bool linearTerms = true; // force the three TCQs in, besides the constant
    double standardisedWidth =
        0; // > 0: one width for all Gaussians (preset paper); 0: levels of widths in degrees
    int levels = 7;
    int largestNumberOfCentres = 48;
    double ridge = 1.0; // lambda, in samples
    // A quantity that is not used keeps its column with a scale so large that it is zero. Linear terms are of
    // dT and of those that follow it without one left out between.
    std::array<bool, 3> inputs{true, true, true};
};

struct RbfPath
{
    Standardiser inputs;
    int forcedColumns = 0;
    Eigen::MatrixX3d centres;         // K x 3, standardised, in the order of picking
    Eigen::VectorXd widths;           // K, standardised
    std::vector<double> centreDeltaT; // K, degrees
    std::vector<double> widthDeltaT;  // K, degrees
    Eigen::MatrixXd triangle;         // (F + K)^2 upper triangular: basis = orthonormal * triangle
    Eigen::MatrixX3d
        coefficientsDps;           // (F + K) x 3 of the orthonormal columns, Gaussians' shrunk by the ridge
    Eigen::Vector3d noiseVariance; // dps^2, of the axis
    ThermalRows rows;              // what was fitted
    Eigen::MatrixX3d runOffsetDps; // R x 3
    int groups = 1;                // of runs that share temperatures

    int size() const { return static_cast<int>(widths.size()); }
};

RbfPath makeRbfPath(const TrainingSet &set, const RbfPathOptions &options);
RbfPath makeRbfPath(const ThermalCurve &merged, const Eigen::Vector3d &noiseVariance,
                    const RbfPathOptions &options);

// Variance within cells over all runs, dps^2 per axis; > 0 also for noiseless data (then tiny against the
// swing).
Eigen::Vector3d pooledNoiseVariance(const TrainingSet &set);

// Loss of every prefix on cells (which may be others than the path was fitted on): weighted mean square of
// (cell mean - prediction) / sigma, row: number of centres, column: axis. dT is held at the edges of the
// path's range. removeOffset: the mean residual of the cells does not count.
Eigen::MatrixX3d prefixLosses(const RbfPath &path, const ThermalRows &rows, bool removeOffset);

// The network that uses the first centres[a] picks on axis a.
RbfNetwork networkOf(const RbfPath &path, const std::array<int, 3> &centres);

} // namespace driftbench
