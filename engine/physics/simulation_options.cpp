#include "engine/physics/simulation_options.h"

#include "engine/base/text.h"

#include <cmath>
#include <string_view>

namespace driftbench {

namespace {

constexpr double kHighestSampleRateHz = 100000.0;
constexpr double kMostSamples = 1e12;
constexpr int kMostEvents = 10000;

// Whole numbers in full: 100000, not 1e+05.
std::string inFull(double value)
{
    constexpr double kLongest = 1e12;
    return value == std::floor(value) && std::abs(value) <= kLongest ? fixed(value, 0) : shortest(value);
}

// A quantity with the bounds that it must keep, both included.
struct Bound
{
    std::string_view what;
    double value;
    std::string_view unit;
    double lowest;
    double highest;
};

constexpr double kLarge = 1e6;

Status check(const Bound &bound)
{
    if (bound.value >= bound.lowest && bound.value <= bound.highest)
        return {};
    const std::string unit(bound.unit);
    return Error{Errc::InvalidOption, "The " + std::string(bound.what) + " is " + inFull(bound.value) + unit +
                                          "; give " + inFull(bound.lowest) + " to " + inFull(bound.highest) +
                                          unit + "."};
}

Status checkPositive(std::string_view what, double value, std::string_view unit, double highest)
{
    if (value > 0.0 && value <= highest)
        return {};
    return Error{Errc::InvalidOption, "The " + std::string(what) + " is " + inFull(value) +
                                          std::string(unit) + "; give more than 0 and at most " +
                                          inFull(highest) + std::string(unit) + "."};
}

Status checkSampleCount(const SimulationOptions &options)
{
    const double samples = options.profile.durationS() * options.gyro.sampleRateHz;
    if (samples >= 1.0 && samples <= kMostSamples)
        return {};
    return Error{Errc::InvalidOption, "The profile of " + inFull(options.profile.durationS()) + " s has " +
                                          inFull(samples) + " samples at " +
                                          inFull(options.gyro.sampleRateHz) +
                                          " Hz; choose a sampling rate that gives 1 to a million million."};
}

Status checkReferenceRate(const GyroOptions &gyro)
{
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const std::string what = "reference rate on " + std::string(kAxisNames[axis]);
        if (const Status ok =
                check({what, gyro.referenceRateDps[axis], " dps", -gyro.rangeDps, gyro.rangeDps});
            !ok)
            return ok;
    }
    return {};
}

// Combs that touch have no rate.
Status checkTruth(const SimulationOptions &options)
{
    for (const double temperatureC : {options.profile.lowestC(), options.profile.highestC()}) {
        for (const DriftFunction &axis : options.truth.rateDps) {
            if (!std::isfinite(axis(temperatureC)))
                return Error{Errc::InvalidOption, "The drift curve " + options.truth.name +
                                                      " is not defined at " + inFull(temperatureC) +
                                                      " °C, which the profile reaches; choose a profile "
                                                      "or a drift curve that suits."};
        }
    }
    return {};
}

} // namespace

Status checkOptions(const SimulationOptions &options)
{
    const auto &[lagS, deadTimeS, thermometerNoiseC, thermometerCountsPerC] = options.chamber;
    const GyroOptions &gyro = options.gyro;
    const FaultOptions &faults = options.faults;
    if (const Status ok = checkPositive("sampling rate", gyro.sampleRateHz, " Hz", kHighestSampleRateHz); !ok)
        return ok;
    if (const Status ok = checkPositive("range of the gyro", gyro.rangeDps, " dps", kLarge); !ok)
        return ok;
    if (const Status ok = checkPositive("play of the hysteresis", gyro.hysteresisPlayC, " °C", kLarge); !ok)
        return ok;
    for (const Bound &bound : {
             Bound{"lag of the chamber", lagS, " s", 0.0, kLarge},
             Bound{"dead time of the chamber", deadTimeS, " s", 0.0, kLarge},
             Bound{"noise of the thermometer", thermometerNoiseC, " °C", 0.0, 100.0},
             Bound{"resolution of the thermometer", thermometerCountsPerC, " counts/°C", 0.0, kLarge},
             Bound{"noise of the rate", gyro.noiseDps, " dps", 0.0, kLarge},
             Bound{"bias instability", gyro.biasInstabilityDps, " dps", 0.0, kLarge},
             Bound{"rate random walk", gyro.rateRandomWalkDpsPerRootS, " dps/√s", 0.0, kLarge},
             Bound{"spread between runs", gyro.spread, "", 0.0, 1.0},
             Bound{"turn-on bias", gyro.turnOnBiasDps, " dps", 0.0, kLarge},
             Bound{"lag of the package", gyro.packageLagS, " s", 0.0, kLarge},
             Bound{"hysteresis", gyro.hysteresisDps, " dps", -kLarge, kLarge},
             Bound{"sensitivity", gyro.sensitivityMdps, " mdps", 0.0, kLarge},
             Bound{"number of bias steps", static_cast<double>(faults.biasSteps), "", 0.0, kMostEvents},
             Bound{"size of a bias step", faults.biasStepDps, " dps", 0.0, kLarge},
             Bound{"number of motion bursts", static_cast<double>(faults.motionBursts), "", 0.0, kMostEvents},
             Bound{"peak of a motion", faults.motionDps, " dps", 0.0, kLarge},
             Bound{"length of a motion", faults.motionS, " s", 0.0, kLarge},
             Bound{"number of gaps", static_cast<double>(faults.gaps), "", 0.0, kMostEvents},
             Bound{"length of a gap", faults.gapS, " s", 0.0, kLarge},
             Bound{"fraction of outliers", faults.outlierFraction, "", 0.0, 1.0},
             Bound{"size of an outlier", faults.outlierDps, " dps", 0.0, kLarge},
             Bound{"fraction of non-finite samples", faults.nonFiniteFraction, "", 0.0, 1.0},
         }) {
        if (Status ok = check(bound); !ok)
            return ok;
    }
    if (const Status ok = checkReferenceRate(gyro); !ok)
        return ok;
    if (const Status ok = checkTruth(options); !ok)
        return ok;
    return checkSampleCount(options);
}

} // namespace driftbench
