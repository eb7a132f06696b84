// All models judged on runs that they were not trained on.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/evaluation/allan.h"
#include "engine/evaluation/hysteresis.h"
#include "engine/features/run_features.h"
#include "engine/models/model_recipe.h"
#include "engine/models/trained_model.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

// Absolute: the turn-on bias counts, as in PX4. Anchored: each run's bias at its start is removed, as
// ArduPilot does with the calibration temperature.
enum class Judging
{
    Absolute,
    Anchored
};
std::string_view judgingName(Judging judging);

struct ComparisonOptions
{
    std::vector<std::string> models = defaultModelNames();
    std::vector<std::string> holdOut; // names of runs; empty: leave one run out
    Judging judging = Judging::Absolute;
    std::uint64_t seed = 1;
    int threads = 0;
};

// One model on one axis of one held-out run.
struct ComparisonRow
{
    std::string run;
    int axis = 0;
    std::string model;
    double msdBefore = 0.0; // dps^2, mean square of rate - reference (paper Eq. 31)
    double msdAfter = 0.0;
    double q = 0.0;                  // msdAfter / msdBefore (Eqs. 32, 34)
    double noiseFloor = 0.0;         // dps^2
    double excessOverFloor = 0.0;    // (msdAfter - noiseFloor) / noiseFloor
    double rms10sDps = 0.0;          // of what is left, after averaging over 10 s
    double rmsDps = 0.0;             // sqrt(msdAfter)
    double biasInstabilityDps = 0.0; // lowest point of the Allan deviation of what is left, scaled
    Eigen::Index samples = 0;
    std::vector<std::string> trainedOn;
};

// What was trained without certain samples, and on what it is judged.
struct Fold
{
    std::string name;                           // of the held-out run, or "run, block k" of a single run
    std::shared_ptr<const RunFeatures> heldOut; // what it is judged on
    std::vector<std::string> trainedOn;
    TrainingSet training;
    std::vector<FittedModel> models; // in the order of ComparisonOptions::models
};

struct AxisVerdict
{
    Verdict verdict = Verdict::NotRepeatable;
    std::string model; // recommended: which wins on held-out runs, the simpler within a standard error
    double gain = 0.0; // G of the recommended or, where the constant wins, of the best other model
    double gainModelFree = 0.0; // G*
    std::string reason;         // in words, with the figures
};

struct Comparison
{
    ComparisonOptions options;
    std::vector<ComparisonRow> rows; // by run, then axis, then model
    std::vector<Fold> folds;
    std::vector<TrainedModel> models; // trained on all runs that were not explicitly held out; "auto" last
    std::optional<RbfSelection> rbfSelection; // of "rbf" on all of them
    std::array<AxisVerdict, 3> verdicts;
    Hysteresis hysteresis;
    std::vector<std::string> warnings;
};

// What of the campaign goes into the models besides its features.
struct CampaignFacts
{
    SensorIdentity sensor;
    bool simulated = false;
};

Result<Comparison> compareModels(const TrainingSet &set, const CampaignFacts &facts,
                                 const ComparisonOptions &options = {}, const ProgressHook &hook = {});

} // namespace driftbench
