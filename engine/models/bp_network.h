// Conventional 2 of the paper (MSD5): a back-propagation network 2-10-1 per axis on dT and dT^2,
//   tde = b2 + w2 . tanh(W1 z + b1)        z: standardised [dT, dT^2]
// trained by Levenberg-Marquardt from several seeded starts on 1 degree cells weighted by their counts.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/features/run_features.h"
#include "engine/models/model_concept.h"
#include "engine/models/standardiser.h"

#include <array>
#include <cstdint>
#include <vector>

namespace driftbench {

struct BpNetwork
{
    static constexpr FeatureSet kFeatures = FeatureSet::DeltaTSquared;

    // One axis. H hidden units.
    struct Axis
    {
        Eigen::MatrixXd hiddenWeights; // H x 2
        Eigen::VectorXd hiddenBias;    // H
        Eigen::VectorXd outputWeights; // H, in units of outputScaleDps
        double outputBias = 0.0;       // in units of outputScaleDps
        double outputMeanDps = 0.0;    // tde = outputMeanDps + outputScaleDps * network
        double outputScaleDps = 1.0;
    };

    Standardiser inputs;
    std::array<Axis, 3> axes;

    Eigen::MatrixX3d predict(const Eigen::MatrixXd &quantities) const; // N x 2
};

struct BpOptions
{
    int hiddenUnits = 10;
    int starts = 5;
    int iterations = 100;
    std::uint64_t seed = 1;
    int threads = 0;
};

enum class Termination
{
    Converged,
    IterationLimit,
    Stopped
};

struct BpSummary
{
    struct Start
    {
        double lossDps2 = 0.0; // weighted mean square of what is left over the cells
        int iterations = 0;
        Termination termination = Termination::IterationLimit;
    };
    std::array<std::vector<Start>, 3> starts; // per axis
};

struct BpFit
{
    BpNetwork network;
    BpSummary summary;
};

// Starts run side by side (options.threads); the result does not depend on how many. The hook is called from
// their threads, one call at a time. Errors: Errc::NothingUsable without samples, Errc::Cancelled by the
// hook, Errc::InvalidOption.
Result<BpFit> fitBpNetwork(const TrainingSet &set, const BpOptions &options = {},
                           const ProgressHook &hook = {});

} // namespace driftbench
