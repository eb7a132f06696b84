// Model error against the true curve on runs held out, and coverage of the 95 % band, over many simulated
// campaigns: five runs of the paper's profile (5 x 111 000 samples x 3 axes), noise 0.14 dps, spread 0.2 %.
// Prints the mean over seeds and, in brackets, the worst seed, in percent of the noise variance, axes x/y/z.
//
//   driftbench-accuracy [first seed] [number of seeds]
#include "engine/evaluation/comparison.h"
#include "engine/features/run_features.h"
#include "engine/physics/gyro_simulator.h"
#include "engine/recording/campaign.h"
#include "engine/recording/quality.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <vector>

using namespace driftbench;

namespace {

constexpr int kRuns = 5;
constexpr int kFreshRuns = 40; // true curves of further runs, on which the band is judged

struct Figures
{
    std::vector<Eigen::Vector3d> excess; // one a seed, part of the noise variance

    void print(const char *name) const
    {
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        Eigen::Vector3d worst = Eigen::Vector3d::Zero();
        for (const auto &seed : excess) {
            mean += seed / static_cast<double>(excess.size());
            worst = worst.cwiseMax(seed);
        }
        mean *= 100.0;
        worst *= 100.0;
        std::printf("  %-16s %7.2f /%7.2f /%7.2f   (%7.2f /%7.2f /%7.2f)\n", name, mean[0], mean[1], mean[2],
                    worst[0], worst[1], worst[2]);
    }
};

struct SimulatedCampaign
{
    TrainingSet set;
    std::vector<DriftTable> truths;      // of each run, over temperature
    std::vector<DriftTable> freshTruths; // of runs that nobody trains on
};

SimulationOptions optionsFor(const char *truth, std::uint64_t seed)
{
    SimulationOptions options{*TemperatureProfile::named("paper"), *namedDriftCurves(truth)};
    options.seed = seed;
    return options;
}

SimulatedCampaign simulate(const SimulationOptions &options)
{
    Campaign campaign;
    std::vector<DriftTable> truths;
    for (int run = 0; run < kRuns; ++run) {
        truths.push_back(GyroSimulator::create(options, run)->truth());
        auto prepared = prepareRun(*simulateRun(options, run), {.name = "run" + std::to_string(run + 1)});
        if (!prepared) {
            std::fprintf(stderr, "%s\n", prepared.error().message.c_str());
            std::exit(1);
        }
        campaign.runs.push_back(*std::move(prepared));
    }
    const double reference = chooseReferenceTemperature(campaign, std::nullopt);
    std::vector<DriftTable> fresh;
    for (int run = kRuns; run < kRuns + kFreshRuns; ++run)
        fresh.push_back(GyroSimulator::create(options, run)->truth());
    return {makeTrainingSet(campaign, reference), std::move(truths), std::move(fresh)};
}

// Mean square of prediction - true curve of the held-out run over its samples, per axis, in noise variances.
Eigen::Vector3d excessOf(const AnyModel &model, const Fold &fold, double referenceC, const DriftTable &truth,
                         double noiseVariance)
{
    constexpr Eigen::Index kStride = 10; // neighbours in time have the same temperature
    const Eigen::Index count = fold.heldOut->deltaT.size() / kStride;
    const Eigen::VectorXd deltaT = fold.heldOut->deltaT(Eigen::seqN(0, count, kStride));
    Eigen::MatrixX3d error = predictAtDeltaT(model, deltaT);
    for (Eigen::Index i = 0; i < count; ++i)
        error.row(i) -= truth.rateDps(referenceC + deltaT[i]).transpose();
    return error.cwiseAbs2().colwise().mean().transpose() / noiseVariance;
}

// Part of temperatures at which the fresh run's true curve lies inside the band, per axis.
Eigen::Vector3d coverageOf(const TrainedModel &model, const DriftTable &truth)
{
    const UncertaintyBand &band = *model.band;
    const Eigen::MatrixX3d predicted = predictAtTemperature(model, band.temperatureC).tdeDps;
    Eigen::Vector3d inside = Eigen::Vector3d::Zero();
    double bins = 0.0;
    for (Eigen::Index i = 0; i < band.temperatureC.size(); ++i) {
        if (std::isnan(band.curveHalfWidthDps(i, 0)))
            continue;
        ++bins;
        const Eigen::Vector3d distance = predicted.row(i).transpose() - truth.rateDps(band.temperatureC[i]);
        for (int axis = 0; axis < 3; ++axis)
            inside[axis] += std::abs(distance[axis]) <= band.curveHalfWidthDps(i, axis) ? 1.0 : 0.0;
    }
    return inside / bins;
}

// The mean of the training runs' true curves: no model of temperature can be expected to do better.
Eigen::Vector3d oracleExcess(const SimulatedCampaign &campaign, std::size_t heldOut, double noiseVariance)
{
    const auto &run = *campaign.set.runs[heldOut];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0.0;
    for (Eigen::Index i = 0; i < run.deltaT.size(); i += 10) {
        const double temperatureC = campaign.set.referenceTemperatureC + run.deltaT[i];
        Eigen::Vector3d others = Eigen::Vector3d::Zero();
        for (std::size_t other = 0; other < campaign.truths.size(); ++other) {
            if (other != heldOut)
                others += campaign.truths[other].rateDps(temperatureC) / (kRuns - 1);
        }
        sum += (others - campaign.truths[heldOut].rateDps(temperatureC)).cwiseAbs2();
        ++count;
    }
    return sum / count / noiseVariance;
}

void runTruth(const char *truth, std::uint64_t firstSeed, int seeds)
{
    std::map<std::string, Figures> figures;
    Figures oracle;
    Eigen::Vector3d coverage = Eigen::Vector3d::Zero();
    const std::vector<std::string> &names = knownModelNames();
    for (int i = 0; i < seeds; ++i) {
        const SimulationOptions options = optionsFor(truth, firstSeed + static_cast<std::uint64_t>(i));
        const double variance = options.gyro.noiseDps * options.gyro.noiseDps;
        const SimulatedCampaign campaign = simulate(options);
        const auto comparison = compareModels(campaign.set, {.simulated = true}, {.models = names});
        Eigen::Vector3d best = Eigen::Vector3d::Zero();
        for (std::size_t run = 0; run < kRuns; ++run)
            best += oracleExcess(campaign, run, variance) / kRuns;
        oracle.excess.push_back(best);
        for (std::size_t m = 0; m < names.size(); ++m) {
            Eigen::Vector3d mean = Eigen::Vector3d::Zero();
            for (std::size_t run = 0; run < comparison->folds.size(); ++run) {
                const Fold &fold = comparison->folds[run];
                mean += excessOf(fold.models[m].model, fold, campaign.set.referenceTemperatureC,
                                 campaign.truths[run], variance) /
                        kRuns;
            }
            figures[names[m]].excess.push_back(mean);
        }
        const auto rbf = std::find_if(comparison->models.begin(), comparison->models.end(),
                                      [](const TrainedModel &model) { return model.name == "rbf"; });
        for (const DriftTable &fresh : campaign.freshTruths)
            coverage += coverageOf(*rbf, fresh) / (seeds * kFreshRuns);
    }
    std::printf("%s: error on held-out runs, %% of the noise variance, x/y/z, mean (worst seed)\n", truth);
    oracle.print("oracle");
    for (const std::string &name : names)
        figures[name].print(name.c_str());
    std::printf("  95 %% band of rbf covers %.1f / %.1f / %.1f %% of a fresh run's curve\n\n",
                100.0 * coverage[0], 100.0 * coverage[1], 100.0 * coverage[2]);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char **argv)
{
    const std::uint64_t firstSeed = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 101;
    const int seeds = argc > 2 ? std::atoi(argv[2]) : 8;
    std::printf("seeds %llu to %llu\n", static_cast<unsigned long long>(firstSeed),
                static_cast<unsigned long long>(firstSeed) + static_cast<unsigned long long>(seeds) - 1);
    for (const char *truth : {"curved", "steep"})
        runTruth(truth, firstSeed, seeds);
    return 0;
}
