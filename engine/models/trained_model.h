// A model with all that is needed to use it: over which temperatures it was trained, on which sensor, from
// which runs, how well it did on runs that it had not seen.
#pragma once

#include "engine/base/result.h"
#include "engine/models/bp_network.h"
#include "engine/models/constant_model.h"
#include "engine/models/linear_model.h"
#include "engine/models/polynomial_model.h"
#include "engine/models/rbf_network.h"
#include "engine/recording/recording.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace driftbench {

struct TrainedModel;

// One model per axis: what `auto` chose.
struct PerAxisModel
{
    static constexpr FeatureSet kFeatures = FeatureSet::DeltaTSquaredRoot;

    std::array<std::shared_ptr<const TrainedModel>, 3> axes; // never null, never itself a PerAxisModel

    Eigen::MatrixX3d predict(const Eigen::MatrixXd &quantities) const; // N x 3: all three TCQs
};

using AnyModel =
    std::variant<ConstantModel, LinearModel, PolynomialModel, BpNetwork, RbfNetwork, PerAxisModel>;

// The 95 % band of the curve (engine/evaluation/uncertainty_band.h computes it).
struct UncertaintyBand
{
    int runs = 0; // below 3 there is no 95 % band of a new run's curve: half widths are then of noise only
    Eigen::VectorXd temperatureC;        // B bin centres
    Eigen::MatrixX3d curveHalfWidthDps;  // B x 3: of a new run's curve; NaN where no run was
    Eigen::MatrixX3d sampleHalfWidthDps; // B x 3: of a new sample
};

enum class Verdict
{
    Yes,
    WithCare,
    NotRepeatable,
    NoDrift
};
std::string_view verdictName(Verdict verdict); // "yes", "with care", "not repeatable", "no drift"
std::optional<Verdict> verdictFromName(std::string_view name);

struct TrainedModel
{
    std::string name; // "constant", "linear", "cubic", "cubic-ardupilot", "bpnn", "rbf-paper", "rbf", "auto"
    AnyModel model;

    double referenceTemperatureC = 0.0;
    double lowestTemperatureC = 0.0; // trained range: outside it the edge value is held, and flagged
    double highestTemperatureC = 0.0;
    SensorIdentity sensor;
    bool simulated = false;             // trained on simulated data
    std::vector<std::string> trainedOn; // names of runs
    std::uint64_t seed = 0;
    std::string judging = "absolute";      // how the verdicts were reached
    std::map<std::string, double> summary; // figures of the training: "centres_x", "held_out_rms_y_dps", ...
    std::array<std::optional<Verdict>, 3> verdicts; // unset: never judged
    std::array<std::string, 3> reasons;             // in words, with the figures
    std::optional<UncertaintyBand> band;
};

struct Prediction
{
    Eigen::MatrixX3d tdeDps;              // N x 3
    Eigen::Index outsideTrainedRange = 0; // samples whose temperature was held at the edge
};

FeatureSet featuresOf(const AnyModel &model);

// Of the bare model, no clamping.
Eigen::MatrixX3d predictAtDeltaT(const AnyModel &model, const Eigen::VectorXd &deltaT);

// With the temperature held at the edge of the trained range.
Prediction predictAtTemperature(const TrainedModel &model, const Eigen::VectorXd &temperatureC);

} // namespace driftbench
