#include "engine/recording/units_check.h"

#include "engine/base/axes.h"
#include "engine/base/statistics.h"
#include "engine/base/text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace driftbench {

namespace {

constexpr double kUnitTolerance = 1.15;
constexpr double kQuietestDensityDps = 0.0008;
constexpr double kLoudestDensityDps = 0.7;

double quantile(std::vector<double> &values, double part)
{
    const auto at = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

// Median over the axes of |log(a / b)|; 0 where it can't be told.
double logRatio(const std::array<double, 3> &a, const std::array<double, 3> &b)
{
    std::vector<double> ratios;
    for (std::size_t axis = 0; axis < a.size(); ++axis) {
        if (a[axis] > 0.0 && b[axis] > 0.0)
            ratios.push_back(std::abs(std::log(a[axis] / b[axis])));
    }
    return ratios.empty() ? 0.0 : median(std::move(ratios));
}

bool isUnitRatio(double logOfRatio)
{
    return std::abs(logOfRatio - std::log(kDegreesPerRadian)) < std::log(kUnitTolerance);
}

} // namespace

RateScale rateScale(const Run &run)
{
    RateScale scale;
    const Recording &recording = *run.recording;
    std::vector<double> intervals;
    std::array<std::vector<double>, 3> rates;
    double lastS = 0.0;
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        if (!run.mask.usableForJudging(i))
            continue;
        if (!rates[0].empty())
            intervals.push_back(recording.timeS[i] - lastS);
        lastS = recording.timeS[i];
        for (int axis = 0; axis < kAxisCount; ++axis)
            rates[static_cast<std::size_t>(axis)].push_back(recording.rateDps(i, axis));
    }
    if (intervals.empty())
        return scale;
    for (std::size_t axis = 0; axis < rates.size(); ++axis) {
        std::vector<double> differences;
        differences.reserve(rates[axis].size());
        for (std::size_t i = 1; i < rates[axis].size(); ++i)
            differences.push_back(rates[axis][i] - rates[axis][i - 1]);
        scale.noiseDps[axis] = robustSigma(std::move(differences)) / std::numbers::sqrt2;
        const double high = quantile(rates[axis], 0.99);
        scale.swingDps[axis] = high - quantile(rates[axis], 0.01);
    }
    const double nyquistHz = 0.5 / median(std::move(intervals));
    scale.noiseDensityDps = median({scale.noiseDps.begin(), scale.noiseDps.end()}) / std::sqrt(nyquistHz);
    return scale;
}

UnitsGuess compareUnits(const RateScale &a, const RateScale &b)
{
    if (!isUnitRatio(logRatio(a.noiseDps, b.noiseDps)))
        return UnitsGuess::Same;
    return isUnitRatio(logRatio(a.swingDps, b.swingDps)) ? UnitsGuess::Differ : UnitsGuess::NoiseDiffers;
}

std::string implausibleNoise(const Run &run, const RateScale &scale)
{
    const double density = scale.noiseDensityDps;
    if (density == 0.0 || (density >= kQuietestDensityDps && density <= kLoudestDensityDps))
        return {};
    const bool quiet = density < kQuietestDensityDps;
    return "The noise of " + run.name + " is " + fixed(density * 1000.0, 3) + " mdps/√Hz, " +
           (quiet ? "too little for a MEMS gyro in dps: are its rates in rad/s?"
                  : "too much for a MEMS gyro in dps: were its rates converted twice?");
}

} // namespace driftbench
