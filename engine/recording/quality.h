// Makes a run of a recording: finds what is wrong with it, masks what must not be used, and refuses, with the
// reason, what cannot be calibrated. Of a long recording the rows that are checked are means (block_means.h).
//
// Every check that fires leaves a Finding with its figures. A refusal is a Finding as well as an error, so
// that a recording that can't be used can still be inspected.
//
// Checks, in this order: values that are no numbers; time going backwards, duplicates, gaps; ranges excluded
// by the user; start-up; saturation; temperature faults and stairs; motion; bias steps; outliers of the noise
// (docs/method.md, section 4); enough samples, span and duration; drift that is not there.
#pragma once

#include "engine/base/result.h"
#include "engine/recording/run.h"

#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct TimeRange
{
    double startS = 0.0;
    double endS = 0.0; // included
};

// When the gyro counts as moved. Slower than smallestDps no hand, vehicle or table turns it, and faster than
// steepestDriftDpsPerC no bias follows a jump of temperature. Shaking has no mean, so small shocks (a door, a
// knock) do no harm and are left to the outlier mask.
struct MotionOptions
{
    double smallestDps = 0.2;
    double smallestShakeDps = 1.0;
    double noiseFactor = 8.0; // times the quiet noise
    double steepestDriftDpsPerC = 1.0;
    double longestS = 600.0; // a step of the rate that comes back within this was a turn, else a bias step
    double settleS = 5.0;    // moved stretches closer together than this are one
    double paddingS = 1.0;   // masked before and after a moved stretch
};

struct QualityOptions
{
    std::string name{};                // of the run; empty: the file name without its ending
    std::vector<TimeRange> excluded{}; // taken out by the user
    bool maskBadRows = false;          // rows with bad values or times are masked instead of refused
    bool allowSmallSpan = false;       // go on with a temperature span under smallestSpanC
    bool allowShort = false;           // go on with less than shortestS
    Eigen::Index fewestSamples = 10;
    double shortestS = 60.0;
    double smallestSpanC = 10.0;
    double advisedSpanC = 25.0;
    double gapFactor = 5.0;          // a gap is longer than this many median intervals
    double coarseTemperatureC = 0.9; // temperature in steps of at least this is interpolated
    MotionOptions motion{};
};

struct CheckedRun
{
    Run run;
    std::optional<Error> refusal; // the first reason why this run can't be calibrated
};

// The recording may come back changed in one way: a temperature in stairs is interpolated (with a Finding).
CheckedRun checkRun(Recording recording, const QualityOptions &options = {});

// Errors: NonFiniteValue, TimeBackwards, TooFewSamples, TooShort, ConstantTemperature, SpanTooSmall,
// NothingUsable.
Result<Run> prepareRun(Recording recording, const QualityOptions &options = {});

} // namespace driftbench
