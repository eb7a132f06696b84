// All that the figures of a fit show, as one value.
#pragma once

#include "engine/evaluation/comparison.h"
#include "engine/exports/comparison_files.h"
#include "engine/features/run_features.h"
#include "engine/models/rbf_trainer.h"
#include "engine/models/trained_model.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct ReportRun
{
    std::shared_ptr<const RunFeatures> features;
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    Eigen::VectorXd excludedDeltaT; // samples that no model is judged on
    Eigen::MatrixX3d excludedTdeDps;
};

struct ReportData
{
    bool simulated = false;
    std::string sensor;
    std::string judging; // "absolute" or "anchored"
    double referenceTemperatureC = 0.0;
    std::vector<ReportRun> runs;
    std::map<std::string, TrainedModel> models; // by name, trained on all runs
    // By run, then by model: trained without that run.
    std::map<std::string, std::map<std::string, TrainedModel>> heldOut;
    std::optional<RbfSelection> rbfSelection;
    std::array<AxisVerdict, 3> verdicts;
    std::vector<ComparisonRow> rows;
    std::vector<RunFacts> facts; // of the runs: where they come from, what was left out
    Hysteresis hysteresis;
    std::uint64_t seed = 0;
    std::vector<std::string> holdOut;        // empty: each run was left out in turn
    std::optional<double> limitDps;          // of what may be left, rms; nothing: none was set
    std::map<std::string, double> trainingS; // by model, where that is known
    std::vector<std::string> warnings;       // what the report had to leave out, and why
};

// The model that the figures show as the result: "rbf" where it was trained, else the first of the others
// that depends on temperature; null without any.
const TrainedModel *mainModel(const std::map<std::string, TrainedModel> &models);

} // namespace driftbench
