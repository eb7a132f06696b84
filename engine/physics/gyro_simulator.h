// A simulated gyro on a temperature chamber, sample by sample, in blocks or as a whole recording.
//
//   air(t)  = set-point of the profile behind the chamber's dead time and its lag (first order)
//   die(t)  = air(t) behind the package's lag (first order)
//   rate(t) = reference + g_run(die) + hysteresis(die) + bias steps + motion + flicker + walk + noise,
//             saturated and quantised
//   logged temperature = air(t) + thermometer noise, quantised
//
// A set-point acts from one sample before its own on, a step being felt at the sample on which it
// falls: a lag that is estimated from the samples is short by up to one sampling interval.
//
// g_run is the drift curve of this run per axis (drift_curves.h). The hysteresis is a play operator of the
// die temperature: +-hysteresisDps / 2 on the heating and the cooling branch, 0 at the start. Time in
// seconds, temperature in degrees Celsius, rate in dps; samples lie at i / sampleRateHz from 0 to the
// profile's end. The noise is white: with a standard deviation of sigma its Allan deviation is N / sqrt(tau),
// N = sigma / sqrt(rate).
//
// All random numbers come from generators forked per run and purpose from one seed: the same options give the
// same samples however they are fetched, and an option never shifts the random numbers of another. The
// samples around a gap are those that would be there without it.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/random.h"
#include "engine/base/result.h"
#include "engine/physics/drift_curves.h"
#include "engine/physics/first_order_lag.h"
#include "engine/physics/flicker_noise.h"
#include "engine/physics/play_operator.h"
#include "engine/physics/rate_random_walk.h"
#include "engine/physics/simulated_faults.h"
#include "engine/physics/simulation_options.h"
#include "engine/recording/recording.h"
#include "engine/recording/sample_block.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>

namespace driftbench {

struct GyroSample
{
    double timeS = 0.0;
    double temperatureC = 0.0;
    Eigen::Vector3d rateDps = Eigen::Vector3d::Zero();
};

class GyroSimulator
{
public:
    // Errc::InvalidOption as checkOptions says, or for a negative run number.
    static Result<GyroSimulator> create(const SimulationOptions &options, int run);

    // The next sample; nothing after the last one.
    std::optional<GyroSample> next();

    // The next samples into the block's first rows; fewer than it has rows only at the end of the run.
    Eigen::Index fill(SampleBlock &block);

    // Samples of the run if none is lost in a gap.
    std::int64_t sampleCount() const { return m_sampleCount; }
    double fractionDone() const { return static_cast<double>(m_index) / static_cast<double>(m_sampleCount); }

    // What was really there: the curve that this run plays, and its events.
    const DriftTable &truth() const { return m_drift; }
    const FaultEvents &events() const { return m_faults.events(); }

private:
    GyroSimulator(const SimulationOptions &options, const Random &random);

    void step();
    void advanceSlowNoise();
    double commonRateDps();
    void putOut(Eigen::Ref<Eigen::VectorXd> temperatureC, Eigen::Ref<Eigen::MatrixX3d> rateDps) const;

    SimulationOptions m_options;
    std::int64_t m_sampleCount;
    std::int64_t m_index = 0;
    std::size_t m_profileStep = 0;
    FirstOrderLag m_air;
    FirstOrderLag m_die;
    PlayOperator m_play;
    DriftTable m_drift;
    FaultPlayer m_faults;
    bool m_hasEvents;
    FlickerNoise m_flicker;
    RateRandomWalk m_walk;
    Eigen::Vector3d m_slowNoiseDps = Eigen::Vector3d::Zero(); // of both
    double m_countsPerDps;
    NormalStream m_noise;
    NormalStream m_thermometer;
    Random m_outliers;
    Random m_nonFinite;
    bool m_lost = false;
    GyroSample m_sample;
};

// A whole run. info says that it is simulated and of which sensor. Errc::Cancelled if the hook says Stop.
Result<Recording> simulateRun(const SimulationOptions &options, int run, const ProgressHook &hook = {});

// The curves that all runs scatter about, over the range of the profile.
DriftTable campaignTruth(const SimulationOptions &options);

} // namespace driftbench
