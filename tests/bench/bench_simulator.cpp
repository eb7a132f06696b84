// Samples per second of the gyro simulator in batch on one core; a sample is time, temperature and three
// rates.
#include "engine/physics/gyro_simulator.h"
#include "engine/physics/sensor_presets.h"

#include <benchmark/benchmark.h>
#include <cmath>

using namespace driftbench;

namespace {

void simulateBatch(benchmark::State &state, const SimulationOptions &options)
{
    constexpr Eigen::Index kBlockRows = 4096;
    SampleBlock block = SampleBlock::withRows(kBlockRows);
    std::int64_t samples = 0;
    int run = 0;
    for (auto _ : state) {
        auto simulator = GyroSimulator::create(options, run++);
        while (const Eigen::Index rows = simulator->fill(block)) {
            benchmark::DoNotOptimize(block.rateDps.data());
            samples += rows;
        }
    }
    state.SetItemsProcessed(samples);
}

// The paper's profile over and over, so that what is done once a run does not count.
SimulationOptions longRun(SimulationOptions options, double sampleRateHz)
{
    constexpr double kSamples = 1e7;
    const std::vector<ProfileSegment> segments{HoldSegment{1800.0}, RampSegment{85.0, 0.5, 30.0},
                                               HoldSegment{1800.0}, RampSegment{-40.0, 0.5, 30.0}};
    const int repeats = static_cast<int>(std::ceil(kSamples / sampleRateHz / (2.0 * 9300.0)));
    options.profile = *TemperatureProfile::build("bench", -40.0, segments, repeats);
    options.gyro.sampleRateHz = sampleRateHz;
    return options;
}

SimulationOptions named(double sampleRateHz)
{
    return longRun({*TemperatureProfile::named("paper"), *namedDriftCurves("curved")}, sampleRateHz);
}

SimulationOptions preset(double sampleRateHz)
{
    return longRun(*presetSimulation("I3G4250D", {25.0, 5.0, 53.0}), sampleRateHz);
}

BENCHMARK_CAPTURE(simulateBatch, curved_10Hz, named(10.0))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simulateBatch, preset_10Hz, preset(10.0))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simulateBatch, preset_1kHz, preset(1000.0))->Unit(benchmark::kMillisecond);

} // namespace
