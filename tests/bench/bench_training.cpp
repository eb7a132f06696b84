// Training and judging on the paper's campaign: 5 runs x 111 000 samples x 3 axes.
#include "engine/evaluation/comparison.h"
#include "engine/features/run_features.h"
#include "engine/physics/gyro_simulator.h"
#include "engine/recording/campaign.h"
#include "engine/recording/quality.h"

#include <benchmark/benchmark.h>

using namespace driftbench;

namespace {

const std::vector<Recording> &recordings()
{
    static const std::vector<Recording> all = [] {
        const SimulationOptions options{*TemperatureProfile::named("paper"), *namedDriftCurves("curved")};
        std::vector<Recording> made;
        for (int run = 0; run < 5; ++run)
            made.push_back(*simulateRun(options, run));
        return made;
    }();
    return all;
}

TrainingSet prepared()
{
    Campaign campaign;
    for (std::size_t run = 0; run < recordings().size(); ++run)
        campaign.runs.push_back(*prepareRun(recordings()[run], {.name = "run" + std::to_string(run + 1)}));
    return makeTrainingSet(campaign, chooseReferenceTemperature(campaign, std::nullopt));
}

void qualityAndFeatures(benchmark::State &state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(prepared());
}

void compareNamed(benchmark::State &state, const std::vector<std::string> &models)
{
    const TrainingSet set = prepared();
    for (auto _ : state)
        benchmark::DoNotOptimize(compareModels(set, {}, {.models = models}));
}

void rbfNested(benchmark::State &state)
{
    const TrainingSet set = prepared();
    for (auto _ : state) {
        const auto cache = makeRbfPathCache();
        benchmark::DoNotOptimize(fitRbfNetwork(set, {}, {}, cache));
        for (std::size_t run = 0; run < set.runs.size(); ++run)
            benchmark::DoNotOptimize(fitRbfNetwork(set.without(run), {}, {}, cache));
    }
}

BENCHMARK(qualityAndFeatures)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(rbfNested)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(compareNamed, all_models, defaultModelNames())
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(compareNamed, constant_only, std::vector<std::string>{"constant"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
