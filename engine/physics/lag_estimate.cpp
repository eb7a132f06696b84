#include "engine/physics/lag_estimate.h"

#include "engine/base/text.h"
#include "engine/physics/lag_response.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

namespace {

constexpr Eigen::Index kFewestSamples = 20;
constexpr double kLongestDeadTimeShare = 0.5; // of the recording
constexpr double kLeastExplained = 0.5;       // of what a start that decays on its own leaves
constexpr double kLargestDeviation = 0.25;    // of a time, as a part of the whole lag

struct Data
{
    const std::vector<ProfileStep> &setpoint;
    const Eigen::VectorXd &timeS;
    const Eigen::VectorXd &temperatureC;

    double startS() const { return timeS[0]; }
    double durationS() const { return timeS[timeS.size() - 1] - timeS[0]; }
    double meanIntervalS() const { return durationS() / static_cast<double>(timeS.size() - 1); }
};

// The model with its linear parameters, and what is left of the data.
struct Fit
{
    Lag lag;
    double offsetC = 0.0;
    double startC = 0.0; // what the output was off at the start
    double squaresC2 = std::numeric_limits<double>::infinity();
    Eigen::Index samples = 0;
};

// Every stride-th sample; offset and start by least squares.
Fit fitLinearPart(const Data &data, const Lag &lag, Eigen::Index stride)
{
    LagResponse response(data.setpoint, data.startS(), lag);
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    double squares = 0.0;
    Fit fit{lag};
    for (Eigen::Index i = 0; i < data.timeS.size(); i += stride) {
        response.advanceTo(data.timeS[i]);
        const Eigen::Vector2d basis(1.0, response.startPart());
        const double restC = data.temperatureC[i] - response.outputC();
        normal.selfadjointView<Eigen::Lower>().rankUpdate(basis);
        right += restC * basis;
        squares += restC * restC;
        ++fit.samples;
    }
    const Eigen::Vector2d solved = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    if (!solved.allFinite())
        return fit;
    fit.offsetC = solved[0];
    fit.startC = solved[1];
    fit.squaresC2 = std::max(0.0, squares - solved.dot(right));
    return fit;
}

// Normal equations of all four parameters (theta, tau, offset, start) and the residual's own figures.
struct Linearised
{
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    double squaresC2 = 0.0;
    double neighboursC2 = 0.0; // sum of products of neighbouring residuals
};

Linearised linearise(const Data &data, const Fit &fit, Eigen::Index stride)
{
    LagResponse response(data.setpoint, data.startS(), fit.lag);
    Linearised sums;
    double beforeC = 0.0;
    const double tau = fit.lag.timeConstantS;
    for (Eigen::Index i = 0; i < data.timeS.size(); i += stride) {
        response.advanceTo(data.timeS[i]);
        const double decayed = fit.startC * response.startPart();
        const double startByTau = decayed * (data.timeS[i] - data.startS()) / (tau * tau);
        const Eigen::Vector4d slopes(response.byDeadTime(), response.byTimeConstant() + startByTau, 1.0,
                                     response.startPart());
        const double restC = data.temperatureC[i] - response.outputC() - fit.offsetC - decayed;
        sums.normal.selfadjointView<Eigen::Lower>().rankUpdate(slopes);
        sums.right += restC * slopes;
        sums.squaresC2 += restC * restC;
        sums.neighboursC2 += restC * beforeC;
        beforeC = restC;
    }
    sums.normal = Eigen::Matrix4d(sums.normal.selfadjointView<Eigen::Lower>());
    return sums;
}

struct Bounds
{
    double shortestTimeConstantS;
    double longestTimeConstantS;
    double longestDeadTimeS;

    Lag clamped(const Lag &lag) const
    {
        return {std::clamp(lag.deadTimeS, 0.0, longestDeadTimeS),
                std::clamp(lag.timeConstantS, shortestTimeConstantS, longestTimeConstantS)};
    }
};

Bounds boundsOf(const Data &data)
{
    constexpr double kShortestShare = 1e-3; // of a sampling interval: indistinguishable from 0
    return {kShortestShare * data.meanIntervalS(), data.durationS(),
            kLongestDeadTimeShare * data.durationS()};
}

// Levenberg-Marquardt; the linear parameters are solved anew for each trial.
Fit refine(const Data &data, Fit fit, const Bounds &bounds, Eigen::Index stride)
{
    constexpr int kMostTrials = 60;
    constexpr double kEnough = 1e-10; // relative
    double damping = 1e-3;
    Linearised sums = linearise(data, fit, stride);
    for (int trial = 0; trial < kMostTrials && damping < 1e12; ++trial) {
        Eigen::Matrix4d damped = sums.normal;
        damped.diagonal() *= 1.0 + damping;
        const Eigen::Vector4d step = damped.ldlt().solve(sums.right);
        if (!step.allFinite())
            break;
        const Lag moved = bounds.clamped({fit.lag.deadTimeS + step[0], fit.lag.timeConstantS + step[1]});
        const Fit next = fitLinearPart(data, moved, stride);
        if (!(next.squaresC2 < fit.squaresC2)) {
            damping *= 10.0;
            continue;
        }
        const bool settled = fit.squaresC2 - next.squaresC2 < kEnough * fit.squaresC2;
        fit = next;
        if (settled)
            break;
        damping = std::max(1e-9, 0.1 * damping);
        sums = linearise(data, fit, stride);
    }
    return fit;
}

// With the best time constant of a grid.
Fit bestAt(const Data &data, double deadTimeS, const Bounds &bounds, Eigen::Index stride)
{
    constexpr int kTimeConstants = 24;
    const double ratio = bounds.longestTimeConstantS / bounds.shortestTimeConstantS;
    Fit best;
    for (int j = 0; j < kTimeConstants; ++j) {
        const double share = static_cast<double>(j) / (kTimeConstants - 1);
        const Lag lag{deadTimeS, bounds.shortestTimeConstantS * std::pow(ratio, share)};
        const Fit fit = fitLinearPart(data, lag, stride);
        if (fit.squaresC2 < best.squaresC2)
            best = fit;
    }
    return best;
}

// The best dead times of a grid that is finer towards 0.
std::vector<Fit> bestNodes(const Data &data, const Bounds &bounds, Eigen::Index stride)
{
    constexpr int kDeadTimes = 40;
    constexpr std::size_t kKept = 3;
    std::vector<Fit> best;
    for (int i = 0; i < kDeadTimes; ++i) {
        const double along = static_cast<double>(i) / kDeadTimes;
        best.push_back(bestAt(data, bounds.longestDeadTimeS * along * along * along, bounds, stride));
    }
    std::sort(best.begin(), best.end(), [](const Fit &a, const Fit &b) { return a.squaresC2 < b.squaresC2; });
    best.resize(kKept);
    return best;
}

// What is left, per sample, if the set-point had never moved.
double meanSquareWithoutSetpointC2(const Data &data, const Bounds &bounds, Eigen::Index stride)
{
    const std::vector<ProfileStep> resting{data.setpoint.front()};
    const Fit fit = bestAt({resting, data.timeS, data.temperatureC}, 0.0, bounds, stride);
    return fit.squaresC2 / static_cast<double>(fit.samples);
}

Status checkData(const Data &data)
{
    const Eigen::Index samples = data.timeS.size();
    if (samples < kFewestSamples)
        return Error{Errc::TooFewSamples, "The recording has " + std::to_string(samples) +
                                              " samples of temperature and set-point; a lag needs at least " +
                                              std::to_string(kFewestSamples) + "."};
    for (Eigen::Index i = 0; i < samples; ++i) {
        if (!std::isfinite(data.timeS[i]) || !std::isfinite(data.temperatureC[i]))
            return Error{Errc::NonFiniteValue, "Sample " + std::to_string(i + 1) +
                                                   " has no finite time or temperature; leave it out."};
        if (i > 0 && data.timeS[i] <= data.timeS[i - 1])
            return Error{Errc::TimeBackwards, "Time does not go on from sample " + std::to_string(i) + " (" +
                                                  shortest(data.timeS[i - 1]) + " s) to the next (" +
                                                  shortest(data.timeS[i]) + " s); put the log in order."};
    }
    const double endS = data.timeS[samples - 1];
    for (std::size_t i = 1; i < data.setpoint.size(); ++i) {
        if (data.setpoint[i].startS > data.startS() && data.setpoint[i].startS < endS)
            return {};
    }
    return Error{Errc::ConstantTemperature,
                 "The set-point does not change while the recording lasts, so "
                 "nothing shows how the chamber follows; record a step or a ramp."};
}

// What the fit may not be if its figures are to mean anything.
Status checkFit(const Data &data, const Fit &fit, const LagEstimate &estimate, const Bounds &bounds,
                Eigen::Index stride)
{
    constexpr double kAtTheBound = 0.99;
    const double withoutC2 = meanSquareWithoutSetpointC2(data, bounds, stride);
    if (!(estimate.residualRmsC * estimate.residualRmsC <= (1.0 - kLeastExplained) * withoutC2))
        return Error{Errc::NothingUsable,
                     "The temperature does not follow the set-point (" + fixed(estimate.residualRmsC, 2) +
                         " °C rms are left); check that both belong together and start at the same time."};
    if (fit.lag.timeConstantS > kAtTheBound * bounds.longestTimeConstantS ||
        fit.lag.deadTimeS > kAtTheBound * bounds.longestDeadTimeS)
        return Error{Errc::TooShort, "The recording of " + fixed(data.durationS(), 0) +
                                         " s is too short for the lag that it shows; record for longer after "
                                         "the set-point has changed."};
    const double wholeS = std::max(estimate.deadTimeS + estimate.timeConstantS, data.meanIntervalS());
    const double largestS = kLargestDeviation * wholeS;
    if (!(estimate.deadTimeSdS <= largestS && estimate.timeConstantSdS <= largestS))
        return Error{Errc::NothingUsable,
                     "Too little happens in the recording to tell a dead time from a time constant; record a "
                     "step, or a ramp with the hold before and after it."};
    return {};
}

LagEstimate summarise(const Data &data, const Fit &fit)
{
    constexpr double kMostCorrelation = 0.9999;
    const Linearised sums = linearise(data, fit, 1);
    const double freedom = static_cast<double>(fit.samples - 4);
    const double correlation =
        sums.squaresC2 > 0.0 ? std::clamp(sums.neighboursC2 / sums.squaresC2, 0.0, kMostCorrelation) : 0.0;
    const double variance = sums.squaresC2 / freedom * (1.0 + correlation) / (1.0 - correlation);
    // Scaled, so that only a real degeneracy looks like one.
    const Eigen::Vector4d scale = sums.normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::Matrix4d scaled = scale.asDiagonal() * sums.normal * scale.asDiagonal();
    const Eigen::Matrix4d inverse = scaled.fullPivLu().inverse();
    const auto deviation = [&](int i) { return scale[i] * std::sqrt(variance * inverse(i, i)); };
    return {fit.lag.deadTimeS, deviation(0), fit.lag.timeConstantS,
            deviation(1),      fit.offsetC,  std::sqrt(sums.squaresC2 / static_cast<double>(fit.samples)),
            fit.samples};
}

} // namespace

std::vector<ProfileStep> setpointSteps(const Eigen::VectorXd &timeS, const Eigen::VectorXd &setpointC)
{
    std::vector<ProfileStep> steps;
    for (Eigen::Index i = 0; i < timeS.size(); ++i) {
        if (steps.empty() || steps.back().setpointC != setpointC[i])
            steps.push_back({timeS[i], setpointC[i]});
    }
    return steps;
}

Result<LagEstimate> estimateLag(const std::vector<ProfileStep> &setpoint, const Eigen::VectorXd &timeS,
                                const Eigen::VectorXd &temperatureC)
{
    constexpr Eigen::Index kSamplesForGrid = 3000;
    const Data data{setpoint, timeS, temperatureC};
    if (const Status ok = checkData(data); !ok)
        return ok.error();
    const Bounds bounds = boundsOf(data);
    const Eigen::Index stride = (timeS.size() + kSamplesForGrid - 1) / kSamplesForGrid;
    Fit best;
    for (const Fit &node : bestNodes(data, bounds, stride)) {
        const Fit refined = refine(data, node, bounds, stride);
        if (refined.squaresC2 < best.squaresC2)
            best = refined;
    }
    best = refine(data, fitLinearPart(data, best.lag, 1), bounds, 1);
    const LagEstimate estimate = summarise(data, best);
    if (const Status ok = checkFit(data, best, estimate, bounds, stride); !ok)
        return ok.error();
    return estimate;
}

} // namespace driftbench
