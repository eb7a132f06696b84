#include "engine/physics/gyro_simulator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

namespace {

// Each purpose has its own generator. The numbers are part of what a seed means: add, never renumber.
enum class Purpose : std::uint64_t
{
    Spread = 1,
    RateNoise = 2,
    ThermometerNoise = 3,
    BiasSteps = 4,
    Motion = 5,
    Gaps = 6,
    Outliers = 7,
    NonFinite = 8,
    Flicker = 9,
    RateRandomWalk = 10,
};

Random forkFor(const Random &run, Purpose purpose)
{
    return run.fork(static_cast<std::uint64_t>(purpose));
}

// A sample at the very end of the profile would be one of the next second.
std::int64_t countSamples(const SimulationOptions &options)
{
    constexpr double kRoundingSlack = 1e-6;
    const double samples = options.profile.durationS() * options.gyro.sampleRateHz;
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(samples - kRoundingSlack)));
}

FaultEvents drawEvents(const SimulationOptions &options, const Random &run)
{
    const double durationS = options.profile.durationS();
    return {drawBiasSteps(options.faults, durationS, forkFor(run, Purpose::BiasSteps)),
            drawMotionBursts(options.faults, durationS, forkFor(run, Purpose::Motion)),
            drawGaps(options.faults, durationS, forkFor(run, Purpose::Gaps))};
}

DriftTable runTruth(const SimulationOptions &options, const Random &run)
{
    return {withRunSpread(options.truth, options.gyro.spread, options.gyro.turnOnBiasDps,
                          forkFor(run, Purpose::Spread)),
            options.profile.lowestC(), options.profile.highestC()};
}

// To the nearest whole number, ties to even. Adding and taking away 1.5 * 2^52 leaves no bits for a fraction;
// for the sizes met here it is what std::nearbyint does, without its call per sample.
double rounded(double value)
{
    constexpr double kNoFraction = 0x1.8p52;
    return (value + kNoFraction) - kNoFraction;
}

} // namespace

GyroSimulator::GyroSimulator(const SimulationOptions &options, const Random &random)
    : m_options(options)
    , m_sampleCount(countSamples(options))
    , m_air(options.chamber.lagS, 1.0 / options.gyro.sampleRateHz, options.profile.startC())
    , m_die(options.gyro.packageLagS, 1.0 / options.gyro.sampleRateHz, options.profile.startC())
    , m_play(options.gyro.hysteresisPlayC, options.profile.startC())
    , m_drift(runTruth(options, random))
    , m_faults(drawEvents(options, random))
    , m_hasEvents(!m_faults.events().empty())
    , m_flicker(options.gyro.biasInstabilityDps, options.gyro.sampleRateHz, forkFor(random, Purpose::Flicker))
    , m_walk(options.gyro.rateRandomWalkDpsPerRootS, options.gyro.sampleRateHz,
             forkFor(random, Purpose::RateRandomWalk))
    , m_countsPerDps(options.gyro.sensitivityMdps > 0.0 ? 1000.0 / options.gyro.sensitivityMdps : 0.0)
    , m_noise(forkFor(random, Purpose::RateNoise))
    , m_thermometer(forkFor(random, Purpose::ThermometerNoise))
    , m_outliers(forkFor(random, Purpose::Outliers))
    , m_nonFinite(forkFor(random, Purpose::NonFinite))
{
}

Result<GyroSimulator> GyroSimulator::create(const SimulationOptions &options, int run)
{
    if (const Status ok = checkOptions(options); !ok)
        return ok.error();
    if (run < 0)
        return Error{Errc::InvalidOption,
                     "The run number is " + std::to_string(run) + "; runs are counted from 0."};
    return GyroSimulator(options, Random(options.seed).fork(static_cast<std::uint64_t>(run)));
}

// Everything of one sample, whether or not it is lost afterwards: the state and the random numbers go on.
void GyroSimulator::step()
{
    const double timeS = static_cast<double>(m_index++) / m_options.gyro.sampleRateHz;
    const auto &steps = m_options.profile.steps();
    const double reachingS = timeS - m_options.chamber.deadTimeS;
    while (m_profileStep + 1 < steps.size() && steps[m_profileStep + 1].startS <= reachingS)
        ++m_profileStep;
    const double airC = m_air.advance(steps[m_profileStep].setpointC);
    m_die.advance(airC);
    if (m_hasEvents)
        m_faults.advance(timeS);
    m_lost = m_faults.sampleLost();
    advanceSlowNoise();

    const ChamberOptions &chamber = m_options.chamber;
    const GyroOptions &gyro = m_options.gyro;
    m_sample.timeS = timeS;
    m_sample.temperatureC = airC + chamber.thermometerNoiseC * m_thermometer.next();
    const auto drift = m_drift.at(m_die.value());
    const double commonDps = commonRateDps();
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const double trueDps = gyro.referenceRateDps[axis] + drift.rateDps(axis) + m_faults.rateDps()[axis] +
                               m_slowNoiseDps[axis] + commonDps;
        m_sample.rateDps[axis] = trueDps + gyro.noiseDps * m_noise.next();
    }
    if (m_options.faults.nonFiniteFraction > 0.0 &&
        m_nonFinite.uniform() < m_options.faults.nonFiniteFraction)
        m_sample.rateDps.setConstant(std::numeric_limits<double>::quiet_NaN());
}

void GyroSimulator::advanceSlowNoise()
{
    const GyroOptions &gyro = m_options.gyro;
    if (gyro.biasInstabilityDps > 0.0) {
        m_flicker.advance();
        m_slowNoiseDps = m_flicker.rateDps();
    }
    if (gyro.rateRandomWalkDpsPerRootS > 0.0) {
        m_walk.advance();
        m_slowNoiseDps = m_flicker.rateDps() + m_walk.rateDps();
    }
}

// The sum that all axes share: hysteresis and outliers.
double GyroSimulator::commonRateDps()
{
    const GyroOptions &gyro = m_options.gyro;
    const FaultOptions &faults = m_options.faults;
    double rateDps = 0.0;
    if (gyro.hysteresisDps != 0.0) {
        m_play.advance(m_die.value());
        rateDps += 0.5 * gyro.hysteresisDps * m_play.deflection(m_die.value());
    }
    if (faults.outlierFraction > 0.0 && m_outliers.uniform() < faults.outlierFraction)
        rateDps += m_outliers.below(2) == 0 ? faults.outlierDps : -faults.outlierDps;
    return rateDps;
}

// As thermometer and gyro put it out. Column by column, which the compiler turns into vector instructions.
void GyroSimulator::putOut(Eigen::Ref<Eigen::VectorXd> temperatureC,
                           Eigen::Ref<Eigen::MatrixX3d> rateDps) const
{
    const ChamberOptions &chamber = m_options.chamber;
    const GyroOptions &gyro = m_options.gyro;
    if (chamber.thermometerCountsPerC > 0.0) {
        for (double &value : temperatureC)
            value = rounded(value * chamber.thermometerCountsPerC) / chamber.thermometerCountsPerC;
    }
    for (int axis = 0; axis < kAxisCount; ++axis) {
        auto column = rateDps.col(axis);
        for (double &value : column)
            value = std::clamp(value, -gyro.rangeDps, gyro.rangeDps);
        if (gyro.sensitivityMdps == 0.0)
            continue;
        // Counts times mdps, then / 1000: the double next to the decimal fraction, so that it prints short.
        for (double &value : column)
            value = rounded(value * m_countsPerDps) * gyro.sensitivityMdps / 1000.0;
    }
}

std::optional<GyroSample> GyroSimulator::next()
{
    while (m_index < m_sampleCount) {
        step();
        if (m_lost)
            continue;
        Eigen::Matrix<double, 1, 1> temperatureC{m_sample.temperatureC};
        Eigen::Matrix<double, 1, kAxisCount> rateDps = m_sample.rateDps.transpose();
        putOut(temperatureC, rateDps);
        return GyroSample{m_sample.timeS, temperatureC[0], rateDps.transpose()};
    }
    return std::nullopt;
}

Eigen::Index GyroSimulator::fill(SampleBlock &block)
{
    Eigen::Index row = 0;
    while (row < block.timeS.size() && m_index < m_sampleCount) {
        step();
        if (m_lost)
            continue;
        block.timeS[row] = m_sample.timeS;
        block.temperatureC[row] = m_sample.temperatureC;
        for (int axis = 0; axis < kAxisCount; ++axis)
            block.rateDps(row, axis) = m_sample.rateDps[axis];
        ++row;
    }
    putOut(block.temperatureC.head(row), block.rateDps.topRows(row));
    return row;
}

Result<Recording> simulateRun(const SimulationOptions &options, int run, const ProgressHook &hook)
{
    constexpr Eigen::Index kBlockRows = 65536;
    auto simulator = GyroSimulator::create(options, run);
    if (!simulator)
        return simulator.error();
    Recording recording;
    recording.info.source = "simulated run " + std::to_string(run + 1);
    recording.info.format = "simulator";
    recording.info.sensor = options.sensor;
    recording.info.simulated = true;
    const auto rows = static_cast<Eigen::Index>(simulator->sampleCount());
    recording.timeS.resize(rows);
    recording.temperatureC.resize(rows);
    recording.rateDps.resize(rows, kAxisCount);
    SampleBlock block = SampleBlock::withRows(std::min(kBlockRows, rows));
    Eigen::Index filled = 0;
    while (const Eigen::Index count = simulator->fill(block)) {
        recording.timeS.segment(filled, count) = block.timeS.head(count);
        recording.temperatureC.segment(filled, count) = block.temperatureC.head(count);
        recording.rateDps.middleRows(filled, count) = block.rateDps.topRows(count);
        filled += count;
        if (report(hook, "simulating", simulator->fractionDone()) == Flow::Stop)
            return Error{Errc::Cancelled, "The simulation was cancelled; nothing is left of it."};
    }
    recording.timeS.conservativeResize(filled);
    recording.temperatureC.conservativeResize(filled);
    recording.rateDps.conservativeResize(filled, Eigen::NoChange);
    return recording;
}

DriftTable campaignTruth(const SimulationOptions &options)
{
    return {options.truth, options.profile.lowestC(), options.profile.highestC()};
}

} // namespace driftbench
