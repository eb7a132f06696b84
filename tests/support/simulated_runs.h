// Simulated runs and the options that make them, for the tests of the simulator.
#pragma once

#include "engine/physics/gyro_simulator.h"

#include <QtGlobal>

#include <cstring>

namespace driftbench::test {

inline SimulationOptions optionsFor(std::string_view profile, std::string_view truth)
{
    return {*TemperatureProfile::named(profile), *namedDriftCurves(truth)};
}

// The chain without anything random or rounded.
inline SimulationOptions idealOptions(const TemperatureProfile &profile, const DriftCurves &truth)
{
    SimulationOptions options{profile, truth};
    options.chamber = {.lagS = 0.0, .thermometerNoiseC = 0.0, .thermometerCountsPerC = 0.0};
    options.gyro.noiseDps = 0.0;
    options.gyro.spread = 0.0;
    options.gyro.sensitivityMdps = 0.0;
    options.gyro.rangeDps = 1e5;
    return options;
}

inline DriftCurves sameOnEveryAxis(double (*rateDps)(double temperatureC))
{
    DriftCurves curves;
    for (DriftFunction &axis : curves.rateDps)
        axis = rateDps;
    return curves;
}

// A gyro whose rate is its die temperature.
inline DriftCurves thermometerCurves()
{
    return sameOnEveryAxis([](double temperatureC) { return temperatureC; });
}

inline Recording run(const SimulationOptions &options, int number = 0)
{
    auto recording = simulateRun(options, number);
    if (!recording)
        qFatal("%s", recording.error().message.c_str());
    return std::move(recording).value();
}

inline GyroSimulator simulator(const SimulationOptions &options, int number = 0)
{
    auto made = GyroSimulator::create(options, number);
    if (!made)
        qFatal("%s", made.error().message.c_str());
    return std::move(made).value();
}

template <class Matrix>
bool sameBits(const Matrix &a, const Matrix &b)
{
    return a.rows() == b.rows() && a.cols() == b.cols() &&
           std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

inline bool sameBits(const Recording &a, const Recording &b)
{
    return sameBits(a.timeS, b.timeS) && sameBits(a.temperatureC, b.temperatureC) &&
           sameBits(a.rateDps, b.rateDps);
}

inline SimulationOptions withEverything()
{
    SimulationOptions options = optionsFor("quick", "steep");
    options.gyro.referenceRateDps = {25.0, 5.0, 53.0};
    options.gyro.turnOnBiasDps = 0.1;
    options.gyro.packageLagS = 5.0;
    options.gyro.hysteresisDps = 0.2;
    options.gyro.biasInstabilityDps = 0.01;
    options.gyro.rateRandomWalkDpsPerRootS = 0.001;
    options.chamber.deadTimeS = 3.0;
    options.faults = {
        .biasSteps = 3, .motionBursts = 2, .gaps = 3, .outlierFraction = 0.01, .nonFiniteFraction = 0.005};
    options.seed = 99;
    return options;
}

inline bool within(double value, double low, double high)
{
    if (value < low || value > high)
        qWarning("%g is not in %g .. %g", value, low, high);
    return value >= low && value <= high;
}

} // namespace driftbench::test
