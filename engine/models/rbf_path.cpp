#include "engine/models/rbf_path.h"

#include "engine/models/orthogonal_selection.h"
#include "engine/models/rbf_candidates.h"
#include "engine/models/run_alignment.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

// Finite in a model file, and its square still is.
constexpr double kScaleOfUnused = 1e120;

constexpr double kGridRows = 512.0;
constexpr double kEnoughDegreesOfFreedom = 100.0;

// 1, the first standardised TCQs, and after them the Gaussians of the path, at standardised rows.
Eigen::MatrixXd basisAt(const Eigen::MatrixXd &z, int forcedColumns, const Eigen::MatrixX3d &centres,
                        const Eigen::VectorXd &widths)
{
    Eigen::MatrixXd basis(z.rows(), forcedColumns + widths.size());
    basis.col(0).setOnes();
    basis.middleCols(1, forcedColumns - 1) = z.leftCols(forcedColumns - 1);
    for (Eigen::Index j = 0; j < widths.size(); ++j) {
        const double precision = -0.5 / (widths[j] * widths[j]);
        basis.col(forcedColumns + j) =
            (((z.col(0).array() - centres(j, 0)).square() + (z.col(1).array() - centres(j, 1)).square() +
              (z.col(2).array() - centres(j, 2)).square()) *
             precision)
                .exp();
    }
    return basis;
}

struct WithinCells
{
    Eigen::Vector3d squares = Eigen::Vector3d::Zero(); // about the means of the cells
    double degreesOfFreedom = 0.0;
};

// Over all runs, in cells of `factor` times their curves' width.
WithinCells withinCells(const TrainingSet &set, int factor)
{
    WithinCells sums;
    for (const auto &run : set.runs) {
        const ThermalCurve curve = factor == 1 ? run->curve : run->curve.coarsened(factor);
        for (const ThermalCell &cell : curve.cells()) {
            if (cell.count < 2.0)
                continue;
            sums.squares += (cell.sumTdeSquared - cell.sumTdeDps.cwiseAbs2() / cell.count).cwiseMax(0.0);
            sums.degreesOfFreedom += cell.count - 1.0;
        }
    }
    return sums;
}

Eigen::Vector3d swingVariance(const TrainingSet &set)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    double count = 0.0;
    for (const auto &run : set.runs) {
        for (const ThermalCell &cell : run->curve.cells()) {
            sum += cell.sumTdeDps;
            squares += cell.sumTdeSquared;
            count += cell.count;
        }
    }
    return (squares / count - (sum / count).cwiseAbs2()).cwiseMax(0.0);
}

void keepPick(RbfPath &path, const RbfCandidates &candidates, Eigen::Index pick)
{
    const Eigen::Index k = path.size();
    path.centres.conservativeResize(k + 1, 3);
    path.widths.conservativeResize(k + 1);
    path.centres.row(k) = candidates.centres.row(pick);
    path.widths[k] = candidates.widths[pick];
    path.centreDeltaT.push_back(candidates.centreDeltaT[static_cast<std::size_t>(pick)]);
    path.widthDeltaT.push_back(candidates.widthDeltaT[static_cast<std::size_t>(pick)]);
}

} // namespace

ThermalRows thermalRows(const ThermalCurve &curve, int factor)
{
    const ThermalCurve grid = curve.coarsened(factor);
    const auto occupied = std::count_if(grid.cells().begin(), grid.cells().end(),
                                        [](const auto &cell) { return cell.count > 0.0; });
    ThermalRows rows;
    rows.quantities.resize(occupied, 3);
    rows.tdeDps.resize(occupied, 3);
    rows.count.resize(occupied);
    Eigen::Index row = 0;
    for (const ThermalCell &cell : grid.cells()) {
        if (cell.count == 0.0)
            continue;
        rows.quantities.row(row) = (cell.sumQuantities / cell.count).transpose();
        rows.tdeDps.row(row) = cell.meanTdeDps().transpose();
        rows.count[row++] = cell.count;
    }
    return rows;
}

int trainingGridFactor(const ThermalCurve &curve)
{
    const double span = curve.highestDeltaT() - curve.lowestDeltaT();
    return std::max(1, static_cast<int>(std::ceil(span / kGridRows / curve.cellWidthC())));
}

Eigen::Vector3d pooledNoiseVariance(const TrainingSet &set)
{
    // A slow log has hardly two samples in a narrow cell; then wider cells tell, at the price of some slope.
    WithinCells within;
    for (const int factor : {1, 5, 25, 50}) {
        within = withinCells(set, factor);
        if (within.degreesOfFreedom >= kEnoughDegreesOfFreedom)
            break;
    }
    // Noiseless data still need a scale: a millionth of what the axis swings.
    const Eigen::Vector3d variance = within.squares / std::max(within.degreesOfFreedom, 1.0);
    return variance.cwiseMax(1e-12 * swingVariance(set)).cwiseMax(1e-24);
}

RbfPath makeRbfPath(const TrainingSet &set, const RbfPathOptions &options)
{
    const RunAlignment alignment = alignRuns(set);
    ThermalCurve merged(set.runs.front()->curve.cellWidthC());
    for (std::size_t run = 0; run < set.runs.size(); ++run) {
        ThermalCurve aligned = set.runs[run]->curve;
        aligned.shift(alignment.offsetDps.row(static_cast<Eigen::Index>(run)).transpose());
        merged.merge(aligned);
    }
    RbfPath path = makeRbfPath(merged, pooledNoiseVariance(set), options);
    path.runOffsetDps = alignment.offsetDps;
    path.groups = alignment.groups;
    return path;
}

RbfPath makeRbfPath(const ThermalCurve &merged, const Eigen::Vector3d &noiseVariance,
                    const RbfPathOptions &options)
{
    RbfPath path;
    path.noiseVariance = noiseVariance;
    path.rows = thermalRows(merged, trainingGridFactor(merged));
    path.inputs = Standardiser::fit(path.rows.quantities, path.rows.count);
    for (std::size_t column = 0; column < options.inputs.size(); ++column) {
        if (!options.inputs[column])
            path.inputs.scale[static_cast<Eigen::Index>(column)] = kScaleOfUnused;
    }
    const Eigen::MatrixXd z = path.inputs.transform(path.rows.quantities);
    const RbfCandidates candidates = rbfCandidates(path.rows, path.inputs, options);

    const Eigen::VectorXd weight = path.rows.count.cwiseSqrt();
    const Eigen::RowVector3d sigma = noiseVariance.cwiseSqrt().transpose();
    const Eigen::MatrixXd gaussians = basisAt(z, 1, candidates.centres, candidates.widths);
    const int most = 1 + (options.linearTerms ? 3 : 0) + options.largestNumberOfCentres;
    OrthogonalSelection selection(weight.asDiagonal() * gaussians.rightCols(candidates.widths.size()),
                                  weight.asDiagonal() *
                                      (path.rows.tdeDps.array().rowwise() / sigma.array()).matrix(),
                                  most, options.ridge);

    selection.take(weight, true);
    path.forcedColumns = 1;
    if (options.linearTerms) {
        // With hardly any rows the later TCQs depend on the earlier ones.
        for (int column = 0; column < 3 && selection.columns() < path.rows.size(); ++column) {
            if (!options.inputs[static_cast<std::size_t>(column)])
                break;
            if (!selection.take(weight.cwiseProduct(z.col(column)), true))
                break;
            ++path.forcedColumns;
        }
    }
    while (path.size() < options.largestNumberOfCentres && selection.columns() < path.rows.size()) {
        const Eigen::Index pick = selection.best();
        if (pick < 0)
            break;
        const Eigen::VectorXd column = selection.candidates().col(pick);
        if (selection.take(column, false))
            keepPick(path, candidates, pick);
        else
            selection.strike(pick);
    }
    path.triangle = selection.triangle();
    path.coefficientsDps = selection.coefficients() * sigma.asDiagonal();
    return path;
}

Eigen::MatrixX3d prefixLosses(const RbfPath &path, const ThermalRows &rows, bool removeOffset)
{
    const double low = path.rows.deltaT()[0];
    const double high = path.rows.deltaT()[path.rows.size() - 1];
    Eigen::MatrixXd quantities = rows.quantities;
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
        if (rows.deltaT()[i] < low || rows.deltaT()[i] > high)
            quantities.row(i) = temperatureQuantities(std::clamp(rows.deltaT()[i], low, high)).transpose();
    }
    const Eigen::MatrixXd basis =
        basisAt(path.inputs.transform(quantities), path.forcedColumns, path.centres, path.widths);
    // Columns as orthonormal combinations: then each further centre only adds its own term to the prediction.
    const Eigen::MatrixXd orthonormal =
        path.triangle.triangularView<Eigen::Upper>().solve<Eigen::OnTheRight>(basis);

    const Eigen::VectorXd weight = rows.count / rows.count.sum();
    Eigen::MatrixX3d residual = rows.tdeDps - orthonormal.leftCols(path.forcedColumns) *
                                                  path.coefficientsDps.topRows(path.forcedColumns);
    Eigen::MatrixX3d losses(path.size() + 1, 3);
    for (int k = 0; k <= path.size(); ++k) {
        if (k > 0) {
            const Eigen::Index column = path.forcedColumns + k - 1;
            residual.noalias() -= orthonormal.col(column) * path.coefficientsDps.row(column);
        }
        const Eigen::RowVector3d offset = weight.transpose() * residual;
        const Eigen::RowVector3d square = weight.transpose() * residual.cwiseAbs2();
        losses.row(k) = (removeOffset ? Eigen::RowVector3d(square - offset.cwiseAbs2()) : square).array() /
                        path.noiseVariance.transpose().array();
    }
    return losses;
}

RbfNetwork networkOf(const RbfPath &path, const std::array<int, 3> &centres)
{
    const int most = std::min(path.size(), *std::max_element(centres.begin(), centres.end()));
    RbfNetwork network;
    network.inputs = path.inputs;
    network.centres = path.centres.topRows(most);
    network.widths = path.widths.head(most);
    network.weightsDps = Eigen::MatrixX3d::Zero(most, 3);
    for (int axis = 0; axis < 3; ++axis) {
        const int used = std::min(centres[static_cast<std::size_t>(axis)], most);
        const Eigen::Index columns = path.forcedColumns + used;
        const Eigen::VectorXd weights = path.triangle.topLeftCorner(columns, columns)
                                            .triangularView<Eigen::Upper>()
                                            .solve(path.coefficientsDps.col(axis).head(columns));
        network.biasDps[axis] = weights[0];
        network.linearDps.col(axis).head(path.forcedColumns - 1) = weights.segment(1, path.forcedColumns - 1);
        network.weightsDps.col(axis).head(used) = weights.tail(used);
        network.centreCount[static_cast<std::size_t>(axis)] = used;
    }
    return network;
}

} // namespace driftbench
