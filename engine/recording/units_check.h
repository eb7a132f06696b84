// Guesses from noise and swing whether rates are in the unit they are said to be in. Private to this folder.
#pragma once

#include "engine/recording/run.h"

#include <array>

namespace driftbench {

// Sizes of a run's rates, from its samples usable for judging.
struct RateScale
{
    std::array<double, 3> noiseDps{}; // robust, from first differences
    std::array<double, 3> swingDps{}; // 1 % to 99 % quantile
    double noiseDensityDps = 0.0;     // noise over the root of half the sample rate, median of the axes
};

RateScale rateScale(const Run &run);

enum class UnitsGuess
{
    Same,
    NoiseDiffers, // by about 57.3, while the swing does not
    Differ        // both by about 57.3
};

UnitsGuess compareUnits(const RateScale &a, const RateScale &b);

// Empty, or a sentence why the noise can't be that of a MEMS gyro in dps.
std::string implausibleNoise(const Run &run, const RateScale &scale);

} // namespace driftbench
