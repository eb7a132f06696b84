// The float32 batch of a compensation table beside a plain copy of the same samples: the target is a ratio
// below 2. A sample is four floats (temperature and three rates); the copy moves all four.
#include "engine/compensation/table_apply.h"

#include <benchmark/benchmark.h>
#include <cstring>

using namespace driftbench;

namespace {

CompensationTable curvedTable()
{
    CompensationTable table;
    table.firstMilliC = -40000;
    table.lastMilliC = 85000;
    table.compensated = {true, true, true};
    table.tdeDps.resize(513, 3);
    for (Eigen::Index i = 0; i < table.size(); ++i) {
        const double t = table.temperatureC(i) / 60.0;
        table.tdeDps.row(i) << t * t, t - t * t * t, 0.3 * t;
    }
    return table;
}

// A chamber's slow sweep, with noise of the thermometer.
Eigen::VectorXf sweep(Eigen::Index samples)
{
    return Eigen::VectorXf::LinSpaced(samples, -42.0F, 87.0F) + 0.03F * Eigen::VectorXf::Random(samples);
}

void tableApplyFloat(benchmark::State &state)
{
    const Eigen::Index samples = state.range(0);
    const TableApply<float> apply(curvedTable());
    const Eigen::VectorXf temperatureC = sweep(samples);
    const Eigen::MatrixX3f rateDps = Eigen::MatrixX3f::Random(samples, 3);
    Eigen::MatrixX3f compensatedDps = Eigen::MatrixX3f::Zero(samples, 3);
    for (auto _ : state) {
        apply.apply(temperatureC, rateDps, compensatedDps);
        benchmark::DoNotOptimize(compensatedDps.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * samples);
}

void plainCopyFloat(benchmark::State &state)
{
    const Eigen::Index samples = state.range(0);
    const Eigen::VectorXf from = Eigen::VectorXf::Random(4 * samples);
    Eigen::VectorXf to = Eigen::VectorXf::Zero(4 * samples);
    for (auto _ : state) {
        std::memcpy(to.data(), from.data(), sizeof(float) * static_cast<std::size_t>(from.size()));
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * samples);
}

} // namespace

BENCHMARK(plainCopyFloat)->Arg(1 << 16)->Arg(1 << 20)->Arg(1 << 23);
BENCHMARK(tableApplyFloat)->Arg(1 << 16)->Arg(1 << 20)->Arg(1 << 23);
