// Recipes that tests of judging bring along, so that they need none of the trainers.
#pragma once

#include "engine/features/temperature_quantities.h"
#include "engine/models/model_recipe.h"

#include <Eigen/Dense>
#include <algorithm>

namespace driftbench::test {

inline ModelRecipe constantRecipe()
{
    return {"constant", 0, [](const TrainingSet &set, const ProgressHook &) -> Result<FittedModel> {
                return FittedModel{fitConstant(set), {}, {}, {}};
            }};
}

inline ModelRecipe linearRecipe()
{
    return {"linear", 1, [](const TrainingSet &set, const ProgressHook &) -> Result<FittedModel> {
                return FittedModel{fitLinear(set), {}, {}, {}};
            }};
}

// Occupied cells of all runs as rows of a weighted least-squares problem.
struct CellRows
{
    Eigen::VectorXd deltaT;
    Eigen::VectorXd rootWeight;
    Eigen::MatrixX3d tdeDps;
};

inline CellRows cellRows(const TrainingSet &set)
{
    std::vector<const ThermalCell *> cells;
    for (const auto &run : set.runs) {
        for (const ThermalCell &cell : run->curve.cells()) {
            if (cell.count > 0.0)
                cells.push_back(&cell);
        }
    }
    const auto size = static_cast<Eigen::Index>(cells.size());
    CellRows rows{Eigen::VectorXd(size), Eigen::VectorXd(size), Eigen::MatrixX3d(size, 3)};
    for (Eigen::Index i = 0; i < size; ++i) {
        const ThermalCell &cell = *cells[static_cast<std::size_t>(i)];
        rows.deltaT[i] = cell.meanDeltaT();
        rows.rootWeight[i] = std::sqrt(cell.count);
        rows.tdeDps.row(i) = cell.meanTdeDps().transpose();
    }
    return rows;
}

inline Eigen::MatrixX3d solveRows(const Eigen::MatrixXd &basis, const CellRows &rows)
{
    const Eigen::MatrixXd weighted = rows.rootWeight.asDiagonal() * basis;
    const Eigen::MatrixX3d targets = rows.rootWeight.asDiagonal() * rows.tdeDps;
    return (weighted.transpose() * weighted).ldlt().solve(weighted.transpose() * targets);
}

// Plain least squares of third degree.
inline PolynomialModel fitPlainCubic(const TrainingSet &set)
{
    const CellRows rows = cellRows(set);
    PolynomialModel model;
    model.centreDeltaT = rows.deltaT.mean();
    const double scale = std::max(1.0, (rows.deltaT.array() - model.centreDeltaT).abs().maxCoeff());
    const Eigen::ArrayXd d = (rows.deltaT.array() - model.centreDeltaT) / scale;
    Eigen::MatrixXd basis(d.size(), 4);
    for (int power = 0; power < 4; ++power)
        basis.col(power) = d.pow(power);
    model.coefficients = solveRows(basis, rows);
    for (int power = 0; power < 4; ++power)
        model.coefficients.row(power) /= std::pow(scale, power);
    return model;
}

inline ModelRecipe cubicRecipe()
{
    return {"cubic", 2, [](const TrainingSet &set, const ProgressHook &) -> Result<FittedModel> {
                return FittedModel{fitPlainCubic(set), {}, {}, {}};
            }};
}

// A dozen Gaussians of one width side by side: follows any smooth curve.
inline RbfNetwork fitGaussianRow(const TrainingSet &set)
{
    constexpr int kCentres = 12;
    const CellRows rows = cellRows(set);
    const double low = rows.deltaT.minCoeff();
    const double spacing = (rows.deltaT.maxCoeff() - low) / (kCentres - 1);
    RbfNetwork network;
    // Only dT counts for the distance.
    network.inputs = {Eigen::RowVector3d::Zero(), Eigen::RowVector3d(1.0, 1e12, 1e12)};
    network.centres = Eigen::MatrixX3d::Zero(kCentres, 3);
    network.widths = Eigen::VectorXd::Constant(kCentres, spacing);
    Eigen::MatrixXd basis(rows.deltaT.size(), kCentres);
    for (int j = 0; j < kCentres; ++j) {
        network.centres(j, 0) = low + j * spacing;
        basis.col(j) =
            (-0.5 * ((rows.deltaT.array() - network.centres(j, 0)) / spacing).square()).exp().matrix();
    }
    network.weightsDps = solveRows(basis, rows);
    network.centreCount = {kCentres, kCentres, kCentres};
    return network;
}

inline ModelRecipe gaussianRecipe(const std::string &name = "rbf")
{
    return {name, 5, [](const TrainingSet &set, const ProgressHook &) -> Result<FittedModel> {
                return FittedModel{fitGaussianRow(set), {}, {}, {}};
            }};
}

} // namespace driftbench::test
