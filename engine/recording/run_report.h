// What there is to say about a run before any model: for `inspect` and the Inspect page. Text and JSON are
// the caller's.
#pragma once

#include "engine/base/axes.h"
#include "engine/recording/run.h"

#include <array>
#include <vector>

namespace driftbench {

struct AxisReport
{
    double meanDps = 0.0;
    double lowestDps = 0.0;
    double highestDps = 0.0;
    double noiseWithinCellDps = 0.0;  // pooled within cells of 0.5 degrees: what no curve of T removes
    double noiseDifferencesDps = 0.0; // robust, from first differences over sqrt 2: the white part
};

// How much time the run spent in a cell of 1 degree.
struct CoverageCell
{
    double centreC = 0.0;
    double heatingS = 0.0;
    double coolingS = 0.0;
};

struct MaskCount
{
    MaskReason reason;
    Eigen::Index samples = 0;
    double percent = 0.0;
};

struct RunReport
{
    Eigen::Index samples = 0;
    Eigen::Index usableForJudging = 0;
    Eigen::Index usableForTraining = 0;
    double startS = 0.0;
    double durationS = 0.0; // first to last sample
    // Of the usable samples:
    double intervalS = 0.0;       // median
    double intervalJitterS = 0.0; // robust sigma of the intervals
    double sampleRateHz = 0.0;
    double lowestTemperatureC = 0.0;
    double highestTemperatureC = 0.0;
    double largestHeatingCPerMin = 0.0; // over 60 s; 0 if the run never heats
    double largestCoolingCPerMin = 0.0; // as a positive figure
    std::array<AxisReport, kAxisCount> axes;
    std::vector<CoverageCell> coverage; // from the lowest cell to the highest
    double heatedAndCooledPart = 0.0;   // 0..1 of the occupied cells
    std::vector<MaskCount> masked;      // only reasons that occur
};

// A run without usable samples has the counts alone.
RunReport summarise(const Run &run);

} // namespace driftbench
