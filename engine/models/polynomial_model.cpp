#include "engine/models/polynomial_model.h"

#include "engine/models/least_squares.h"
#include "engine/models/per_run_cache.h"
#include "engine/models/running_median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace driftbench {

namespace {

constexpr int kDegree = 3;
constexpr int kPx4Bins = 2000;
constexpr double kArduPilotWindowS = 2.0;
constexpr double kArduPilotCentreC = 35.0;

struct Series
{
    Eigen::VectorXd timeS;
    Eigen::VectorXd deltaT;
    Eigen::MatrixX3d tdeDps;
};

Series trainingSamples(const RunFeatures &run)
{
    const Eigen::Index kept = std::count(run.usableForTraining.begin(), run.usableForTraining.end(), 1);
    Series series{Eigen::VectorXd(kept), Eigen::VectorXd(kept), Eigen::MatrixX3d(kept, 3)};
    Eigen::Index row = 0;
    for (Eigen::Index i = 0; i < run.deltaT.size(); ++i) {
        if (run.usableForTraining[static_cast<std::size_t>(i)] == 0)
            continue;
        series.timeS[row] = run.timeS[i];
        series.deltaT[row] = run.deltaT[i];
        series.tdeDps.row(row) = run.tdeDps.row(i);
        ++row;
    }
    return series;
}

Series medianFiltered(const RunFeatures &run)
{
    Series series = trainingSamples(run);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        series.tdeDps.col(axis) = runningMedian(series.tdeDps.col(axis));
    return series;
}

struct Range
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    double middle() const { return 0.5 * (low + high); }
};

Range rangeOf(const std::vector<const Series *> &runs)
{
    Range range;
    for (const Series *run : runs) {
        if (run->deltaT.size() == 0)
            continue;
        range.low = std::min(range.low, run->deltaT.minCoeff());
        range.high = std::max(range.high, run->deltaT.maxCoeff());
    }
    return range;
}

struct Bin
{
    double count = 0.0;
    double sumDeltaT = 0.0;
    Eigen::Vector3d sumTdeDps = Eigen::Vector3d::Zero();
};

std::vector<Bin> binned(const std::vector<const Series *> &runs, const Range &range)
{
    std::vector<Bin> bins(kPx4Bins);
    const double width = range.high > range.low ? (range.high - range.low) / kPx4Bins : 1.0;
    for (const Series *run : runs) {
        for (Eigen::Index i = 0; i < run->deltaT.size(); ++i) {
            const int index = static_cast<int>((run->deltaT[i] - range.low) / width);
            Bin &bin = bins[static_cast<std::size_t>(std::min(index, kPx4Bins - 1))];
            bin.count += 1.0;
            bin.sumDeltaT += run->deltaT[i];
            bin.sumTdeDps += run->tdeDps.row(i).transpose();
        }
    }
    std::erase_if(bins, [](const Bin &bin) { return bin.count == 0.0; });
    return bins;
}

// What ArduPilot's fit needs of a run: the triangle of [1 d d^2 d^3 | x y z] over its means.
Eigen::MatrixXd arduPilotTriangle(const RunFeatures &run, double centreDeltaT)
{
    const Series series = trainingSamples(run);
    const Eigen::Index count = series.timeS.size();
    if (count == 0)
        return Eigen::MatrixXd(0, kDegree + 1 + 3);
    const double seconds = series.timeS[count - 1] - series.timeS[0];
    const double perSecond = seconds > 0.0 ? std::floor(static_cast<double>(count) / seconds) : 0.0;
    const double wanted = std::max(perSecond * kArduPilotWindowS, 1.0);
    // A run shorter than the window is one mean; the peer stops there.
    const auto window = static_cast<Eigen::Index>(std::min(wanted, static_cast<double>(count)));

    Eigen::MatrixXd sums(count + 1, 4);
    sums.row(0).setZero();
    for (Eigen::Index i = 0; i < count; ++i) {
        sums(i + 1, 0) = sums(i, 0) + (series.deltaT[i] - centreDeltaT);
        sums.row(i + 1).tail<3>() = sums.row(i).tail<3>() + series.tdeDps.row(i);
    }
    const Eigen::Index means = count - window + 1;
    const Eigen::MatrixXd mean = (sums.bottomRows(means) - sums.topRows(means)) / static_cast<double>(window);
    Eigen::MatrixXd rows(means, kDegree + 1 + 3);
    rows << powersOf(mean.col(0), kDegree), mean.rightCols<3>();
    return triangleOf(rows);
}

} // namespace

class PeerSeriesCache
{
public:
    const Series &medianFilteredOf(const std::shared_ptr<const RunFeatures> &run)
    {
        return m_filtered.get(run, medianFiltered);
    }

    const Eigen::MatrixXd &triangleOf(const std::shared_ptr<const RunFeatures> &run, double centreDeltaT)
    {
        return m_triangles.get(
            run, [centreDeltaT](const RunFeatures &r) { return arduPilotTriangle(r, centreDeltaT); });
    }

private:
    PerRunCache<Series> m_filtered;
    PerRunCache<Eigen::MatrixXd> m_triangles;
};

std::shared_ptr<PeerSeriesCache> makePeerSeriesCache()
{
    return std::make_shared<PeerSeriesCache>();
}

Eigen::MatrixX3d PolynomialModel::predict(const Eigen::MatrixXd &quantities) const
{
    const Eigen::VectorXd d = quantities.col(0).array() - centreDeltaT;
    Eigen::MatrixX3d tde = coefficients.row(kDegree).replicate(d.size(), 1);
    for (int k = kDegree - 1; k >= 0; --k) {
        tde.array().colwise() *= d.array();
        tde.rowwise() += coefficients.row(k);
    }
    return tde;
}

PolynomialModel fitCubicAsPx4(const TrainingSet &set, const std::shared_ptr<PeerSeriesCache> &cache)
{
    const auto shared = cache ? cache : makePeerSeriesCache();
    std::vector<const Series *> runs;
    for (const auto &run : set.runs)
        runs.push_back(&shared->medianFilteredOf(run));
    const Range range = rangeOf(runs);
    if (!(range.low <= range.high))
        return {};
    const std::vector<Bin> bins = binned(runs, range);

    PolynomialModel model;
    model.centreDeltaT = range.middle();
    Eigen::VectorXd d(static_cast<Eigen::Index>(bins.size()));
    Eigen::MatrixX3d tde(d.size(), 3);
    for (Eigen::Index i = 0; i < d.size(); ++i) {
        const Bin &bin = bins[static_cast<std::size_t>(i)];
        d[i] = bin.sumDeltaT / bin.count - model.centreDeltaT;
        tde.row(i) = bin.sumTdeDps.transpose() / bin.count;
    }
    model.coefficients = solveLeastSquares(powersOf(d, kDegree), tde);
    return model;
}

PolynomialModel fitCubicAsArduPilot(const TrainingSet &set, const std::shared_ptr<PeerSeriesCache> &cache)
{
    const auto shared = cache ? cache : makePeerSeriesCache();
    PolynomialModel model;
    model.centreDeltaT = kArduPilotCentreC - set.referenceTemperatureC;
    Eigen::MatrixXd rows(0, kDegree + 1 + 3);
    for (const auto &run : set.runs) {
        const Eigen::MatrixXd &triangle = shared->triangleOf(run, model.centreDeltaT);
        rows.conservativeResize(rows.rows() + triangle.rows(), Eigen::NoChange);
        rows.bottomRows(triangle.rows()) = triangle;
    }
    model.coefficients = solveJoined(rows, kDegree + 1);
    return model;
}

} // namespace driftbench
