// Trains the RBF network on thermal curves: no sample is touched again once the curves are made.
//
// Preset `best`: the runs are aligned (run_alignment.h), merged, and described by Gaussians of seven widths
// from the whole span down to a 64th of it; centres are taken one by one by greedy orthogonal least squares
// (Chen, Cowan & Grant 1991) with a ridge of one sample's worth; how many each axis uses is chosen on runs
// left out. Preset `paper`: Gaussians of one width and a constant only (Eq. 29), the width and the number
// chosen likewise. Same input and options, same network, bit for bit, on any number of threads.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/features/run_features.h"
#include "engine/models/rbf_network.h"

#include <array>
#include <memory>
#include <vector>

namespace driftbench {

enum class RbfPreset
{
    Best,
    Paper
};

struct RbfOptions
{
    RbfPreset preset = RbfPreset::Best;
    int largestNumberOfCentres = 48;
    double ridge = 1.0; // in samples
    int levels = 7;     // widths span * 2^-l, l = 0 .. levels - 1 (preset best)
    int threads = 0;
    // Fixed number of centres for every axis; negative: chosen on runs left out.
    int centres = -1;
    // Which of dT, dT^2, dT^(1/2) the network sees. dT is always one (else Errc::InvalidOption): the others
    // can't tell every temperature from every other.
    std::array<bool, 3> inputs{true, true, true};
};

// How well each number of centres did, for plots and reports. Index: number of centres, 0 first.
struct RbfSelection
{
    // Mean over folds of the loss on cells left out and of the loss on the training cells, in units of the
    // noise variance of the axis: 0 is a perfect curve plus what the noise of a cell's mean adds. Per axis.
    std::array<std::vector<double>, 3> heldOutLoss;
    std::array<std::vector<double>, 3> trainingLoss;
    // The lowest and the highest of the folds' held-out losses.
    std::array<std::vector<double>, 3> heldOutLowest;
    std::array<std::vector<double>, 3> heldOutHighest;
    std::array<int, 3> chosen{};
    bool leftOutRuns = true; // false: temperature blocks of a single run
};

struct RbfFit
{
    RbfNetwork network;
    RbfSelection selection;
    // Of the path of orthogonal least squares with all centres: where they stand and how wide, in degrees.
    std::vector<double> centreDeltaT;
    std::vector<double> widthDeltaT;
    // Offset of each run against the common curve, dps, R x 3 (sum 0); NaN rows never occur.
    Eigen::MatrixX3d runOffsetDps;
    std::vector<std::string> warnings;
};

// Paths already computed, by the runs that they were computed on: leave-one-run-out inside leave-one-run-out
// meets the same pairs again. Safe to share between threads; belongs to one campaign and one set of options.
class RbfPathCache;
std::shared_ptr<RbfPathCache> makeRbfPathCache();

Result<RbfFit> fitRbfNetwork(const TrainingSet &set, const RbfOptions &options = {},
                             const ProgressHook &hook = {},
                             const std::shared_ptr<RbfPathCache> &cache = nullptr);

} // namespace driftbench
