#include "engine/evaluation/campaign_inspection.h"

#include "engine/base/axes.h"
#include "engine/base/statistics.h"
#include "engine/evaluation/sweeps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

static constexpr double kCellC = 1.0;
static constexpr int kCellsOfCurve = 50; // of 0.02 degrees
static constexpr int kCellsOfNoise = 25; // 0.5 degrees, as the noise floor
static constexpr double kSmoothC = 2.5;
static constexpr double kLittleMore = 1.2;
static constexpr double kShareOfSwing = 0.05;
static constexpr double kTimesNoise = 3.0;

static double medianIntervalS(const Eigen::VectorXd &timeS)
{
    if (timeS.size() < 2)
        return 0.0;
    std::vector<double> intervals(static_cast<std::size_t>(timeS.size()) - 1);
    for (std::size_t i = 0; i < intervals.size(); ++i)
        intervals[i] = timeS[static_cast<Eigen::Index>(i) + 1] - timeS[static_cast<Eigen::Index>(i)];
    const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
    std::nth_element(intervals.begin(), middle, intervals.end());
    return *middle;
}

TemperatureCoverage coverageOf(const TrainingSet &set)
{
    TemperatureCoverage coverage;
    double lowest = kInfinity;
    double highest = -kInfinity;
    for (const auto &run : set.runs) {
        if (run->deltaT.size() == 0)
            continue;
        lowest = std::min(lowest, run->deltaT.minCoeff() + set.referenceTemperatureC);
        highest = std::max(highest, run->deltaT.maxCoeff() + set.referenceTemperatureC);
    }
    if (!(lowest <= highest))
        return coverage;
    coverage.lowestC = lowest;
    coverage.highestC = highest;
    coverage.firstC = std::floor(lowest / kCellC) * kCellC;
    const auto cells = static_cast<Eigen::Index>(std::floor((highest - coverage.firstC) / kCellC)) + 1;
    coverage.heatingS = Eigen::VectorXd::Zero(cells);
    coverage.coolingS = Eigen::VectorXd::Zero(cells);
    for (const auto &run : set.runs) {
        const double intervalS = medianIntervalS(run->timeS);
        for (const Sweep &sweep : sweepsOf(*run)) {
            Eigen::VectorXd &seconds = sweep.heating ? coverage.heatingS : coverage.coolingS;
            for (Eigen::Index i = sweep.first; i < sweep.last; ++i) {
                const double above = run->deltaT[i] + set.referenceTemperatureC - coverage.firstC;
                seconds[std::clamp<Eigen::Index>(static_cast<Eigen::Index>(above / kCellC), 0, cells - 1)] +=
                    intervalS;
            }
        }
    }
    const auto heated = coverage.heatingS.array() > 0.0;
    const auto cooled = coverage.coolingS.array() > 0.0;
    const auto reached = (heated || cooled).count();
    coverage.bothShare =
        reached > 0 ? static_cast<double>((heated && cooled).count()) / static_cast<double>(reached) : 0.0;
    return coverage;
}

static Eigen::Vector3d swingOf(const TrainingSet &set)
{
    Eigen::Vector3d lowest = Eigen::Vector3d::Constant(kInfinity);
    Eigen::Vector3d highest = Eigen::Vector3d::Constant(-kInfinity);
    for (const auto &run : set.runs) {
        for (const Sweep &sweep : sweepsOf(*run)) {
            const ThermalCurve cells = curveOf(*run, sweep).coarsened(kCellsOfCurve);
            for (const ThermalCell &cell : cells.cells()) {
                if (cell.count == 0.0)
                    continue;
                lowest = lowest.cwiseMin(cell.meanTdeDps());
                highest = highest.cwiseMax(cell.meanTdeDps());
            }
        }
    }
    return highest - lowest;
}

// Sweep by sweep: in a run that is heated and cooled, hysteresis would count as noise.
static Eigen::Vector3d noiseOf(const TrainingSet &set)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double samples = 0.0;
    for (const auto &run : set.runs) {
        for (const Sweep &sweep : sweepsOf(*run)) {
            const ThermalCurve cells = curveOf(*run, sweep).coarsened(kCellsOfNoise);
            const Eigen::Vector3d variance = cells.pooledVariance();
            if (!variance.allFinite())
                continue;
            sum += cells.totalCount() * variance;
            samples += cells.totalCount();
        }
    }
    return (sum / samples).cwiseSqrt();
}

namespace {

// What the curve leaves of the samples of a cell of the thermal curve: sums of squares.
struct LeftCell
{
    double deltaT = 0.0;
    double count = 0.0;
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
};

} // namespace

static std::vector<LeftCell> leftByCell(const TrainingSet &set, const AnyModel &curve)
{
    std::vector<LeftCell> cells;
    if (set.runs.empty())
        return cells;
    ThermalCurve all(set.runs.front()->curve.cellWidthC());
    for (const auto &run : set.runs)
        all.merge(run->curve);
    std::vector<double> deltaT;
    for (const ThermalCell &cell : all.cells()) {
        if (cell.count > 0.0)
            deltaT.push_back(cell.meanDeltaT());
    }
    const Eigen::MatrixX3d curveDps = predictAtDeltaT(
        curve, Eigen::Map<const Eigen::VectorXd>(deltaT.data(), static_cast<Eigen::Index>(deltaT.size())));
    Eigen::Index row = 0;
    for (const ThermalCell &cell : all.cells()) {
        if (cell.count == 0.0)
            continue;
        const Eigen::Array3d g = curveDps.row(row++).transpose().array();
        const Eigen::Array3d squares =
            cell.sumTdeSquared.array() - 2.0 * g * cell.sumTdeDps.array() + cell.count * g.square();
        cells.push_back({cell.meanDeltaT(), cell.count, squares.max(0.0).matrix()});
    }
    return cells;
}

static ResidualSpread spreadOf(const std::vector<LeftCell> &cells)
{
    ResidualSpread spread;
    if (cells.empty())
        return spread;
    const double first = cells.front().deltaT;
    const auto points = static_cast<Eigen::Index>((cells.back().deltaT - first) / kCellC) + 1;
    spread.deltaT.resize(points);
    spread.rmsDps.resize(points, 3);
    std::size_t low = 0;
    for (Eigen::Index i = 0; i < points; ++i) {
        const double middle = first + kCellC * static_cast<double>(i);
        while (low < cells.size() && cells[low].deltaT < middle - kSmoothC)
            ++low;
        double count = 0.0;
        Eigen::Vector3d squares = Eigen::Vector3d::Zero();
        for (std::size_t k = low; k < cells.size() && cells[k].deltaT <= middle + kSmoothC; ++k) {
            count += cells[k].count;
            squares += cells[k].squares;
        }
        spread.deltaT[i] = middle;
        spread.rmsDps.row(i) = (squares / count).cwiseSqrt().transpose();
    }
    return spread;
}

static CurveKind kindOf(const AxisInspection &axis)
{
    if (axis.leftDps <= kLittleMore * axis.noiseDps)
        return CurveKind::Curve;
    if (axis.leftDps < kShareOfSwing * axis.swingDps || axis.leftDps < kTimesNoise * axis.noiseDps)
        return CurveKind::Nearly;
    return CurveKind::Not;
}

CampaignInspection inspectCampaign(const TrainingSet &set, const AnyModel &curve)
{
    CampaignInspection inspection;
    inspection.hysteresis = analyseHysteresis(set);
    inspection.coverage = coverageOf(set);
    const std::vector<LeftCell> left = leftByCell(set, curve);
    inspection.spread = spreadOf(left);
    double count = 0.0;
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    for (const LeftCell &cell : left) {
        count += cell.count;
        squares += cell.squares;
    }
    const Eigen::Vector3d leftDps = (squares / count).cwiseSqrt();
    const Eigen::Vector3d swing = swingOf(set);
    const Eigen::Vector3d noise = noiseOf(set);
    for (int a = 0; a < kAxisCount; ++a) {
        double lowest = kInfinity;
        double highest = -kInfinity;
        for (const Passage &passage : inspection.hysteresis.passages) {
            lowest = std::min(lowest, passage.tdeDps[a]);
            highest = std::max(highest, passage.tdeDps[a]);
        }
        AxisInspection &axis = inspection.axes[static_cast<std::size_t>(a)];
        axis.swingDps = swing[a];
        axis.noiseDps = noise[a];
        axis.leftDps = leftDps[a];
        axis.spreadDps = lowest <= highest ? highest - lowest : std::numeric_limits<double>::quiet_NaN();
        axis.kind = kindOf(axis);
    }
    return inspection;
}

} // namespace driftbench
