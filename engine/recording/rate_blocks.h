// The usable samples in blocks of about two seconds: what motion and bias steps are looked for in. Private to
// this folder.
#pragma once

#include "engine/recording/quality_checks.h"

namespace driftbench::quality {

struct RateBlock
{
    std::size_t first = 0;                       // in the usable columns
    std::size_t end = 0;                         // one past the last
    double timeS = 0.0;                          // of its middle sample
    double temperatureC = 0.0;                   // mean
    std::array<double, kAxisCount> medianDps{};  // per axis
    std::array<double, kAxisCount> scatterDps{}; // standard deviation from the mean absolute deviation
};

// Blocks of at least eight samples and two seconds, which don't reach across gaps; cut short before one.
std::vector<RateBlock> rateBlocks(const UsableColumns &columns, double intervalS, double gapFactor);

// The noise of a gyro at rest, per axis: the 20 % quantile of the blocks' scatter, so that a log which is
// half motion still tells.
std::array<double, kAxisCount> quietNoiseDps(const std::vector<RateBlock> &blocks);

// Where the rate of one axis changes from one level to another.
struct RateStep
{
    std::size_t firstBlock = 0; // the change happens within these blocks
    std::size_t lastBlock = 0;
    double heightDps = 0.0;
};

// Steps between blocks per axis, in the order of time. A step is a difference between the means of w blocks
// after and w blocks before (w = 1, 2, 4, 8, the block between left out), freed from its own running median
// (slow drift), that exceeds noiseFactor times the robust scatter of these differences plus
// steepestDriftDpsPerC times the same difference of the temperature.
std::array<std::vector<RateStep>, kAxisCount> rateSteps(const std::vector<RateBlock> &blocks,
                                                        const MotionOptions &options);

} // namespace driftbench::quality
