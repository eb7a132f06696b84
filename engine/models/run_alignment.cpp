#include "engine/models/run_alignment.h"

#include "engine/base/statistics.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

namespace driftbench {

namespace {

constexpr double kCellWidthC = 1.0;

struct RunInCell
{
    std::size_t run;
    double count;
    Eigen::Vector3d meanTdeDps;
};

using SharedCells = std::map<std::int64_t, std::vector<RunInCell>>;

SharedCells cellsOf(const TrainingSet &set)
{
    SharedCells cells;
    for (std::size_t run = 0; run < set.runs.size(); ++run) {
        const ThermalCurve &curve = set.runs[run]->curve;
        const ThermalCurve coarse =
            curve.coarsened(std::max(1, static_cast<int>(std::lround(kCellWidthC / curve.cellWidthC()))));
        for (std::size_t i = 0; i < coarse.cells().size(); ++i) {
            const ThermalCell &cell = coarse.cells()[i];
            if (cell.count > 0.0)
                cells[coarse.firstKey() + static_cast<std::int64_t>(i)].push_back(
                    {run, cell.count, cell.meanTdeDps()});
        }
    }
    return cells;
}

double medianCount(const SharedCells &cells)
{
    std::vector<double> counts;
    for (const auto &[key, runs] : cells) {
        for (const RunInCell &entry : runs)
            counts.push_back(entry.count);
    }
    return median(std::move(counts));
}

} // namespace

RunAlignment alignRuns(const TrainingSet &set)
{
    const auto runs = static_cast<Eigen::Index>(set.runs.size());
    RunAlignment alignment;
    alignment.offsetDps = Eigen::MatrixX3d::Zero(runs, 3);
    if (runs < 2)
        return alignment;

    const SharedCells cells = cellsOf(set);
    const double typical = medianCount(cells);
    Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(runs, runs);
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(runs, 3);
    for (const auto &[key, entries] : cells) {
        Eigen::VectorXd weight = Eigen::VectorXd::Zero(runs);
        Eigen::MatrixX3d mean = Eigen::MatrixX3d::Zero(runs, 3);
        for (const RunInCell &entry : entries) {
            const auto row = static_cast<Eigen::Index>(entry.run);
            weight[row] = entry.count / (1.0 + entry.count / typical);
            mean.row(row) = entry.meanTdeDps.transpose();
        }
        const Eigen::RowVector3d common = weight.transpose() * mean / weight.sum();
        laplacian.diagonal() += weight;
        laplacian -= weight * weight.transpose() / weight.sum();
        right += weight.asDiagonal() * (mean.rowwise() - common);
    }

    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(laplacian);
    const double floor = 1e-9 * std::max(solver.eigenvalues().maxCoeff(), 1e-300);
    alignment.groups = static_cast<int>((solver.eigenvalues().array() <= floor).count());
    for (Eigen::Index i = 0; i < runs; ++i) {
        if (solver.eigenvalues()[i] > floor) {
            const Eigen::VectorXd v = solver.eigenvectors().col(i);
            alignment.offsetDps += v * (v.transpose() * right) / solver.eigenvalues()[i];
        }
    }
    return alignment;
}

} // namespace driftbench
