#include "engine/evaluation/uncertainty_band.h"

#include "engine/base/statistics.h"
#include "engine/evaluation/scoring.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace driftbench {

namespace {

constexpr Eigen::Index kBins = 64;
constexpr double kSmoothingC = 5.0;
constexpr double kConfidence = 0.95;
constexpr double kNormalQuantile = 1.959963984540054; // 0.975 of the normal distribution
constexpr int kFewestRuns = 3;
// One run's residuals in the bins.
struct Residuals
{
    Eigen::VectorXd count = Eigen::VectorXd::Zero(kBins);
    Eigen::MatrixX3d meanDps = Eigen::MatrixX3d::Zero(kBins, 3); // 0 where count is 0
};

class Bins
{
public:
    explicit Bins(DeltaTRange range)
        : m_lowest(range.lowest), m_width(std::max(range.highest - range.lowest, 1e-9) / kBins)
    {
    }

    Eigen::Index of(double deltaT) const
    {
        const auto bin = static_cast<Eigen::Index>(std::floor((deltaT - m_lowest) / m_width));
        return std::clamp<Eigen::Index>(bin, 0, kBins - 1);
    }
    double centre(Eigen::Index bin) const { return m_lowest + (static_cast<double>(bin) + 0.5) * m_width; }
    // How many bins beside one are within the smoothing.
    Eigen::Index reach() const
    {
        return std::min<Eigen::Index>(kBins, static_cast<Eigen::Index>(std::floor(kSmoothingC / m_width)));
    }

private:
    double m_lowest;
    double m_width;
};

Residuals residualsOf(const ThermalCurve &curve, const AnyModel &model, DeltaTRange trained, const Bins &bins)
{
    std::vector<const ThermalCell *> occupied;
    for (const ThermalCell &cell : curve.cells()) {
        if (cell.count > 0.0)
            occupied.push_back(&cell);
    }
    Eigen::VectorXd deltaT(static_cast<Eigen::Index>(occupied.size()));
    for (Eigen::Index i = 0; i < deltaT.size(); ++i)
        deltaT[i] = occupied[static_cast<std::size_t>(i)]->meanDeltaT();
    const Eigen::MatrixX3d predicted = predictHeld(model, deltaT, trained);
    Residuals residuals;
    for (Eigen::Index i = 0; i < deltaT.size(); ++i) {
        const ThermalCell &cell = *occupied[static_cast<std::size_t>(i)];
        const Eigen::Index bin = bins.of(deltaT[i]);
        residuals.count[bin] += cell.count;
        residuals.meanDps.row(bin) += cell.sumTdeDps.transpose() - cell.count * predicted.row(i);
    }
    for (Eigen::Index bin = 0; bin < kBins; ++bin) {
        if (residuals.count[bin] > 0.0)
            residuals.meanDps.row(bin) /= residuals.count[bin];
    }
    return residuals;
}

// Long dwells do not count for more than about twice the rest.
Eigen::VectorXd saturatedWeights(const Eigen::VectorXd &count)
{
    std::vector<double> occupied;
    std::copy_if(count.begin(), count.end(), std::back_inserter(occupied), [](double n) { return n > 0.0; });
    const double typical = median(std::move(occupied));
    return count.array() / (1.0 + count.array() / typical);
}

// Weighted mean over the bins within reach; rows without any weight stay 0.
Eigen::MatrixX3d smoothed(const Eigen::MatrixX3d &rows, const Eigen::VectorXd &weights, Eigen::Index reach)
{
    Eigen::MatrixX3d result = Eigen::MatrixX3d::Zero(rows.rows(), 3);
    for (Eigen::Index bin = 0; bin < rows.rows(); ++bin) {
        const Eigen::Index first = std::max<Eigen::Index>(0, bin - reach);
        const Eigen::Index size = std::min(rows.rows() - 1, bin + reach) - first + 1;
        const double total = weights.segment(first, size).sum();
        if (total > 0.0)
            result.row(bin) = weights.segment(first, size).transpose() * rows.middleRows(first, size) / total;
    }
    return result;
}

// s^2 of a bin and the runs that reach it.
struct Spread
{
    Eigen::MatrixX3d variance = Eigen::MatrixX3d::Zero(kBins, 3);
    Eigen::VectorXd runs = Eigen::VectorXd::Zero(kBins);
};

Spread spreadOf(const TrainingSet &set, const std::vector<AnyModel> &heldOutModels, const Bins &bins)
{
    Spread spread;
    for (std::size_t i = 0; i < set.runs.size(); ++i) {
        const Residuals residuals =
            residualsOf(set.runs[i]->curve, heldOutModels[i], trainedRange(set.without(i)), bins);
        const Eigen::MatrixX3d error =
            smoothed(residuals.meanDps, saturatedWeights(residuals.count), bins.reach());
        for (Eigen::Index bin = 0; bin < kBins; ++bin) {
            if (residuals.count[bin] == 0.0)
                continue;
            spread.runs[bin] += 1.0;
            spread.variance.row(bin) += error.row(bin).cwiseAbs2();
        }
    }
    Eigen::VectorXd usable = Eigen::VectorXd::Zero(kBins);
    for (Eigen::Index bin = 0; bin < kBins; ++bin) {
        const double k = spread.runs[bin];
        if (k < kFewestRuns)
            continue;
        spread.variance.row(bin) *= (k - 1.0) / (k * k);
        usable[bin] = 1.0;
    }
    spread.variance = smoothed(spread.variance, usable, bins.reach());
    return spread;
}

// Of a new sample, at the 0.5 degree cells of the noise floor.
Eigen::RowVector3d noiseVariance(const TrainingSet &set)
{
    constexpr int kCellsOfFloor = 25;
    Eigen::RowVector3d variance = Eigen::RowVector3d::Zero();
    for (const auto &run : set.runs)
        variance += run->curve.coarsened(kCellsOfFloor).pooledVariance().transpose();
    return variance / static_cast<double>(set.runs.size());
}

// t_{k-1, 0.975} at index k; 0 where k is too small.
std::vector<double> studentByRuns(std::size_t mostRuns)
{
    std::vector<double> quantiles(mostRuns + 1, 0.0);
    for (std::size_t k = kFewestRuns; k <= mostRuns; ++k)
        quantiles[k] = studentTwoSided(kConfidence, static_cast<double>(k) - 1.0);
    return quantiles;
}

} // namespace

UncertaintyBand uncertaintyBand(const TrainingSet &set, const std::vector<AnyModel> &heldOutModels)
{
    assert(heldOutModels.size() == set.runs.size() && set.runs.size() >= 2);
    const Bins bins(trainedRange(set));
    const Eigen::RowVector3d ofNoise = kNormalQuantile * kNormalQuantile * noiseVariance(set);
    UncertaintyBand band;
    band.temperatureC.resize(kBins);
    for (Eigen::Index bin = 0; bin < kBins; ++bin)
        band.temperatureC[bin] = bins.centre(bin) + set.referenceTemperatureC;
    band.curveHalfWidthDps = Eigen::MatrixX3d::Constant(kBins, 3, kNaN);
    const Spread spread = spreadOf(set, heldOutModels, bins);
    band.runs = static_cast<int>(spread.runs.maxCoeff());
    if (band.runs < kFewestRuns) {
        band.sampleHalfWidthDps = ofNoise.cwiseSqrt().replicate(kBins, 1);
        return band;
    }
    band.sampleHalfWidthDps = band.curveHalfWidthDps;
    const std::vector<double> student = studentByRuns(set.runs.size());
    for (Eigen::Index bin = 0; bin < kBins; ++bin) {
        const double k = spread.runs[bin];
        if (k < kFewestRuns)
            continue;
        const double t = student[static_cast<std::size_t>(k)];
        const Eigen::RowVector3d squared = t * t * (1.0 + 1.0 / k) * spread.variance.row(bin);
        band.curveHalfWidthDps.row(bin) = squared.cwiseSqrt();
        band.sampleHalfWidthDps.row(bin) = (squared + ofNoise).cwiseSqrt();
    }
    return band;
}

} // namespace driftbench
