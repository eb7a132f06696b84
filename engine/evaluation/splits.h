// Who is trained and who is judged: runs, never random samples, since neighbours in time leak.
#pragma once

#include "engine/base/result.h"
#include "engine/features/run_features.h"

#include <memory>
#include <string>
#include <vector>

namespace driftbench {

// What is held out and what is trained without it.
struct Split
{
    std::string name;                           // of the held-out run, or "run, block k" of a single run
    std::shared_ptr<const RunFeatures> heldOut; // what is judged
    // The run that the held-out samples are part of: its start anchors them (another object than heldOut
    // only for blocks).
    std::shared_ptr<const RunFeatures> anchor;
    std::size_t training = 0; // index into Splits::trainings
};

struct Splits
{
    std::vector<TrainingSet> trainings;
    std::vector<std::vector<std::string>> trainedOn; // names of each training's runs
    std::vector<Split> splits;
    std::size_t everything = 0; // the training on all that is not explicitly held out
    bool leftOutRuns = false;   // each run but none explicitly: leave one run out
    bool blocks = false;        // a single run in blocks of temperature
};

inline constexpr int kBlockFolds = 5;

// max(span / 64, four cells of the training grid, 4 * 0.26 degrees).
double temperatureBlockC(double spanC);

// Part of a run: the samples for which keep(i) is true. The name stays.
RunFeatures partOf(const RunFeatures &run, const std::vector<std::uint8_t> &keep);

// holdOut names runs: they are judged by what is trained on all others. Empty: each run is left out in turn;
// a single run is cut into blocks of temperature that go to 5 folds in turn.
// Errc: NothingUsable (no run), InvalidOption (unknown run, every run held out).
Result<Splits> makeSplits(const TrainingSet &set, const std::vector<std::string> &holdOut);

} // namespace driftbench
