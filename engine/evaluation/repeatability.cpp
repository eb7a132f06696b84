#include "engine/evaluation/repeatability.h"

#include "engine/base/statistics.h"
#include "engine/evaluation/sweeps.h"

#include <cmath>
#include <map>
#include <vector>

namespace driftbench {

namespace {

constexpr int kCellFactor = 50; // of the thermal curve's 0.02 degrees: 1 degree
constexpr int kFloorFactor = 25;
constexpr double kFewestSamples = 3.0;
std::vector<ThermalCurve> repeats(const TrainingSet &set)
{
    std::vector<ThermalCurve> curves;
    for (const auto &run : set.runs) {
        if (set.runs.size() > 1) {
            curves.push_back(run->curve.coarsened(kCellFactor));
            continue;
        }
        for (const Sweep &sweep : sweepsOf(*run))
            curves.push_back(curveOf(*run, sweep).coarsened(kCellFactor));
    }
    return curves;
}

// The means that the repeats have in one cell.
struct CellMeans
{
    double count = 0.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d sumSquared = Eigen::Vector3d::Zero();

    Eigen::Vector3d mean() const { return sum / count; }
    Eigen::Vector3d scatter() const { return (sumSquared - sum.cwiseAbs2() / count).cwiseMax(0.0); }
};

std::map<std::int64_t, CellMeans> byCell(const std::vector<ThermalCurve> &curves)
{
    std::map<std::int64_t, CellMeans> cells;
    for (const ThermalCurve &curve : curves) {
        for (std::size_t i = 0; i < curve.cells().size(); ++i) {
            const ThermalCell &cell = curve.cells()[i];
            if (cell.count < kFewestSamples)
                continue;
            CellMeans &means = cells[curve.firstKey() + static_cast<std::int64_t>(i)];
            means.count += 1.0;
            means.sum += cell.meanTdeDps();
            means.sumSquared += cell.meanTdeDps().cwiseAbs2();
        }
    }
    return cells;
}

void splitVariance(Repeatability &result, const std::map<std::int64_t, CellMeans> &cells)
{
    Eigen::Vector3d scatter = Eigen::Vector3d::Zero();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    double degreesOfFreedom = 0.0;
    double inverseCounts = 0.0;
    const auto size = static_cast<double>(cells.size());
    for (const auto &[key, cell] : cells) {
        scatter += cell.scatter();
        degreesOfFreedom += cell.count - 1.0;
        inverseCounts += 1.0 / cell.count;
        mean += cell.mean() / size;
    }
    Eigen::Vector3d spread = Eigen::Vector3d::Zero();
    for (const auto &[key, cell] : cells)
        spread += (cell.mean() - mean).cwiseAbs2() / size;
    if (degreesOfFreedom == 0.0) {
        result.curveRmsDps = spread.cwiseSqrt();
        result.repeatRmsDps.setConstant(kNaN);
        result.gainModelFree.setConstant(kNaN);
        return;
    }
    const Eigen::Vector3d repeat = scatter / degreesOfFreedom;
    const Eigen::Vector3d curve = (spread - repeat * (inverseCounts / size)).cwiseMax(0.0);
    const double newRun = static_cast<double>(result.runs) / (result.runs - 1.0);
    result.curveRmsDps = curve.cwiseSqrt();
    result.repeatRmsDps = repeat.cwiseSqrt();
    for (int axis = 0; axis < 3; ++axis) {
        const double whole = curve[axis] + newRun * repeat[axis];
        result.gainModelFree[axis] = whole > 0.0 ? curve[axis] / whole : 0.0;
    }
}

// One-way analysis of variance: what the means of the cells vary by beyond the noise of so many samples.
Eigen::Vector3d varianceOverTemperature(const RunFeatures &run)
{
    const ThermalCurve cells = run.curve.coarsened(kCellFactor);
    double total = 0.0;
    double occupied = 0.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d between = Eigen::Vector3d::Zero();
    for (const ThermalCell &cell : cells.cells()) {
        if (cell.count == 0.0)
            continue;
        total += cell.count;
        occupied += 1.0;
        sum += cell.sumTdeDps;
        between += cell.sumTdeDps.cwiseAbs2() / cell.count;
    }
    if (total == 0.0)
        return Eigen::Vector3d::Zero();
    between -= sum.cwiseAbs2() / total;
    return (between - (occupied - 1.0) * run.curve.coarsened(kFloorFactor).pooledVariance()) / total;
}

} // namespace

Repeatability analyseRepeatability(const TrainingSet &set)
{
    const std::vector<ThermalCurve> curves = repeats(set);
    Repeatability result;
    result.runs = static_cast<int>(curves.size());
    result.sweeps = set.runs.size() == 1;
    splitVariance(result, byCell(curves));
    result.inRunVariance.setZero();
    for (const auto &run : set.runs)
        result.inRunVariance += varianceOverTemperature(*run) / static_cast<double>(set.runs.size());
    return result;
}

} // namespace driftbench
