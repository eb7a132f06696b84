// One model judged on one run that it has not seen.
#pragma once

#include "engine/evaluation/noise_floor.h"
#include "engine/features/run_features.h"
#include "engine/models/trained_model.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

// Absolute: the turn-on bias counts, as in PX4. Anchored: each run's bias at its start is removed, as
// ArduPilot does with the calibration temperature: the mean residual of the first minute (of the first 30
// samples, if a minute has fewer).
enum class Judging
{
    Absolute,
    Anchored
};
std::string_view judgingName(Judging judging); // "absolute", "anchored"
std::optional<Judging> judgingFromName(std::string_view name);

// A run with what every model's score on it needs.
struct JudgedRun
{
    std::shared_ptr<const RunFeatures> heldOut;
    std::shared_ptr<const RunFeatures> anchor; // whose first startSamples anchor
    Judging judging = Judging::Absolute;
    Eigen::Index startSamples = 0; // rows; 0 where judging is absolute
    std::vector<TimeWindow> windows;
    Eigen::Vector3d floor = Eigen::Vector3d::Zero(); // noise floor, dps^2
    Eigen::Vector3d msdBefore = Eigen::Vector3d::Zero();

    Eigen::Vector3d anchorNoise() const; // floor / samples of the start, or zero
};

// anchor: the run that heldOut is, or is a part of.
JudgedRun prepareForJudging(std::shared_ptr<const RunFeatures> heldOut,
                            std::shared_ptr<const RunFeatures> anchor, Judging judging);

// The dT that a model was trained over; outside the edge is held.
struct DeltaTRange
{
    double lowest = 0.0;
    double highest = 0.0;
};
DeltaTRange trainedRange(const TrainingSet &set);
Eigen::MatrixX3d predictHeld(const AnyModel &model, const Eigen::VectorXd &deltaT, DeltaTRange range);

// Per axis.
struct ModelScore
{
    Eigen::Vector3d msd = Eigen::Vector3d::Zero(); // dps^2
    Eigen::Vector3d rms10sDps = Eigen::Vector3d::Zero();
    Eigen::Vector3d biasInstabilityDps = Eigen::Vector3d::Zero();
};

ModelScore scoreModel(const JudgedRun &run, const AnyModel &model, DeltaTRange range);

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

// name: what the rows call the held-out run.
std::vector<ComparisonRow> rowsOf(const std::string &name, const JudgedRun &run, const std::string &model,
                                  const ModelScore &score, const std::vector<std::string> &trainedOn);

// A trained model on a run whose features were made with the model's reference temperature: three rows.
std::vector<ComparisonRow> evaluateModel(const TrainedModel &model, std::shared_ptr<const RunFeatures> run,
                                         Judging judging);

} // namespace driftbench
