// Where samples come from while they are taken: a bridge, a gyro on an I2C bus, a file that is played back.
//
// run() delivers blocks in order of time until the stop token is set, the sink says Stop, the source ends (a
// file) or an error ends it; it is called on a thread of its own. Time is that of the host in seconds since
// the first sample, mapped from the device's clock (clock_map.h). Samples that were lost are never filled in:
// the sink is told of the gap between the blocks before and after it.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/recording/recording.h"
#include "engine/recording/sample_block.h"

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>

namespace driftbench {

enum class GapCause
{
    ReportsLost,   // between the device and here
    DeviceOverrun, // inside the device
    Unplugged,     // the device was away and came back
    Interrupted,   // the program that recorded ended, and another went on
};

std::string_view gapCauseText(GapCause cause);

struct SampleGap
{
    double startS = 0.0;          // the last sample before it
    double endS = 0.0;            // the first sample after it
    std::int64_t lostSamples = 0; // as counted, or as many as the sampling rate gives; -1: not known
    GapCause cause = GapCause::ReportsLost;
};

class SampleSink
{
public:
    virtual ~SampleSink() = default;

    // count rows of the block hold samples; the block is the source's and is reused.
    virtual Flow samples(const SampleBlock &block, Eigen::Index count) = 0;
    virtual void gap(const SampleGap &gap) = 0;
    virtual void event(const std::string &sentence) = 0; // for the log: "unplugged", "saturated on x", ...
};

struct SourceInfo
{
    std::string name; // "native bridge SIM-0001", "run1.csv"
    SensorIdentity sensor;
    double sampleRateHz = 0.0; // 0: not known
    double rangeDps = 0.0;     // 0: not known
    bool simulated = false;
    bool compensated = false; // the rates come compensated
};

struct SourceStats
{
    std::int64_t samples = 0;
    std::int64_t lostSamples = 0;
    std::int64_t gaps = 0;
    std::int64_t saturatedSamples = 0;
    double clockDriftPpm = 0.0; // of the device's clock against the host's
};

class SampleSource
{
public:
    virtual ~SampleSource() = default;

    virtual const SourceInfo &info() const = 0;
    // The errors of the device; what came before one has been delivered.
    virtual Result<SourceStats> run(SampleSink &sink, std::stop_token stop) = 0;
};

} // namespace driftbench
