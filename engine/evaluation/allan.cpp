#include "engine/evaluation/allan.h"

#include "engine/base/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace driftbench {

namespace {

constexpr Eigen::Index kFewestSamples = 9;
constexpr Eigen::Index kWindowsForBiasInstability = 9;
constexpr double kGapInIntervals = 1.5;

struct Stretch
{
    Eigen::Index first = 0;
    Eigen::Index size = 0;
    double intervalS = 0.0;
};

Stretch longestWithoutGap(const Eigen::VectorXd &timeS)
{
    if (timeS.size() < 2)
        return {0, timeS.size(), 0.0};
    const Eigen::VectorXd steps = timeS.tail(timeS.size() - 1) - timeS.head(timeS.size() - 1);
    const double interval = median(std::vector<double>(steps.begin(), steps.end()));
    Stretch longest;
    Eigen::Index first = 0;
    for (Eigen::Index i = 1; i <= timeS.size(); ++i) {
        if (i < timeS.size() && steps[i - 1] <= kGapInIntervals * interval)
            continue;
        if (i - first > longest.size)
            longest = {first, i - first, 0.0};
        first = i;
    }
    if (longest.size >= 2) {
        const double duration = timeS[longest.first + longest.size - 1] - timeS[longest.first];
        longest.intervalS = duration / static_cast<double>(longest.size - 1);
    }
    return longest;
}

std::vector<Eigen::Index> windowLengths(Eigen::Index samples, int pointsPerDecade)
{
    const Eigen::Index longest = samples / 2;
    std::vector<Eigen::Index> lengths;
    for (int k = 0;; ++k) {
        const auto length =
            static_cast<Eigen::Index>(std::lround(std::pow(10.0, static_cast<double>(k) / pointsPerDecade)));
        if (length > longest)
            return lengths;
        if (lengths.empty() || length > lengths.back())
            lengths.push_back(length);
    }
}

// In units of the sampling interval; the mean is taken off so that no digits are lost on it.
Eigen::VectorXd integrated(const Eigen::Ref<const Eigen::VectorXd> &rateDps)
{
    const double mean = rateDps.mean();
    Eigen::VectorXd theta(rateDps.size() + 1);
    theta[0] = 0.0;
    for (Eigen::Index i = 0; i < rateDps.size(); ++i)
        theta[i + 1] = theta[i] + (rateDps[i] - mean);
    return theta;
}

double deviation(const Eigen::VectorXd &theta, Eigen::Index m)
{
    const Eigen::Index terms = theta.size() - 2 * m;
    const double squares =
        (theta.segment(2 * m, terms) - 2.0 * theta.segment(m, terms) + theta.head(terms)).squaredNorm();
    const auto length = static_cast<double>(m);
    return std::sqrt(squares / (2.0 * static_cast<double>(terms))) / length;
}

void readBiasInstability(AllanCurve &curve, const std::vector<Eigen::Index> &lengths, Eigen::Index samples)
{
    const double scale = std::sqrt(2.0 * std::numbers::ln2 / std::numbers::pi);
    const auto readable = std::count_if(lengths.begin(), lengths.end(), [&](Eigen::Index m) {
        return m * kWindowsForBiasInstability <= samples;
    });
    for (int axis = 0; axis < 3; ++axis) {
        Eigen::Index lowest = 0;
        curve.biasInstabilityDps[axis] =
            curve.deviationDps.col(axis).head(static_cast<Eigen::Index>(readable)).minCoeff(&lowest) / scale;
        curve.biasInstabilityTauS[axis] = curve.tauS[lowest];
    }
}

} // namespace

AllanCurve allanDeviation(const Eigen::VectorXd &timeS, const Eigen::MatrixX3d &rateDps, int pointsPerDecade)
{
    assert(pointsPerDecade >= 1 && timeS.size() == rateDps.rows());
    const Stretch stretch = longestWithoutGap(timeS);
    AllanCurve curve;
    if (stretch.size < kFewestSamples)
        return curve;
    const std::vector<Eigen::Index> lengths = windowLengths(stretch.size, pointsPerDecade);
    const auto points = static_cast<Eigen::Index>(lengths.size());
    curve.tauS.resize(points);
    curve.deviationDps.resize(points, 3);
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::VectorXd theta = integrated(rateDps.col(axis).segment(stretch.first, stretch.size));
        for (Eigen::Index i = 0; i < points; ++i) {
            const Eigen::Index m = lengths[static_cast<std::size_t>(i)];
            curve.tauS[i] = static_cast<double>(m) * stretch.intervalS;
            curve.deviationDps(i, axis) = deviation(theta, m);
        }
    }
    readBiasInstability(curve, lengths, stretch.size);
    return curve;
}

} // namespace driftbench
