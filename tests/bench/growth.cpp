// 100 million simulated samples streamed into a thermal curve: time and peak memory at each tenfold.
//
//   driftbench-growth [samples]
#include "engine/features/thermal_curve.h"
#include "engine/physics/gyro_simulator.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <sys/resource.h>

using namespace driftbench;

int main(int argc, char **argv)
{
    const long long most = argc > 1 ? std::atoll(argv[1]) : 100'000'000;
    const SimulationOptions options{*TemperatureProfile::named("paper"), *namedDriftCurves("curved")};
    std::printf("%12s %10s %14s %12s\n", "samples", "seconds", "samples/s", "peak MB");
    for (long long wanted = most / 100; wanted <= most; wanted *= 10) {
        const auto start = std::chrono::steady_clock::now();
        ThermalCurve curve;
        SampleBlock block = SampleBlock::withRows(65536);
        long long done = 0;
        for (int run = 0; done < wanted; ++run) {
            auto simulator = GyroSimulator::create(options, run);
            for (Eigen::Index rows = simulator->fill(block); rows > 0 && done < wanted;
                 rows = simulator->fill(block)) {
                const Eigen::VectorXd deltaT = block.temperatureC.head(rows).array() + 40.0;
                curve.add(deltaT, block.rateDps.topRows(rows));
                done += rows;
            }
        }
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        std::printf("%12lld %10.2f %14.3g %12.0f\n", done, seconds, static_cast<double>(done) / seconds,
                    static_cast<double>(usage.ru_maxrss) / 1024.0);
    }
    return 0;
}
