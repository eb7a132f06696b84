#include "engine/models/trained_model_json.h"

#include <cmath>

namespace driftbench {

namespace {

constexpr int kMostUnits = 10000; // hidden units or centres

Json standardiserToJson(const Standardiser &standardiser)
{
    return {{"mean", toJson(Eigen::VectorXd(standardiser.mean.transpose()))},
            {"scale", toJson(Eigen::VectorXd(standardiser.scale.transpose()))}};
}

Standardiser standardiserFrom(const FieldReader &reader, FeatureSet features)
{
    const auto columns = static_cast<Eigen::Index>(features);
    Standardiser standardiser{reader.vector("mean", columns).transpose(),
                              reader.vector("scale", columns).transpose()};
    if (!(standardiser.scale.array() > 0.0).all())
        reader.fail("scale", "is not above 0 everywhere");
    return standardiser;
}

Json parametersOf(const ConstantModel &model)
{
    return {{"bias_dps", toJson(Eigen::VectorXd(model.biasDps))}};
}

ConstantModel constantFrom(const FieldReader &reader)
{
    return {reader.vector("bias_dps", 3)};
}

Json parametersOf(const LinearModel &model)
{
    return {{"bias_dps", toJson(Eigen::VectorXd(model.biasDps))},
            {"slope_dps_per_C", toJson(Eigen::VectorXd(model.slopeDpsPerC))}};
}

LinearModel linearFrom(const FieldReader &reader)
{
    return {reader.vector("bias_dps", 3), reader.vector("slope_dps_per_C", 3)};
}

Json parametersOf(const PolynomialModel &model)
{
    return {{"centre_dT_C", model.centreDeltaT},
            {"coefficients_dps", toJson(Eigen::MatrixXd(model.coefficients))}};
}

PolynomialModel polynomialFrom(const FieldReader &reader)
{
    return {reader.number("centre_dT_C"), reader.matrix("coefficients_dps", 4, 3)};
}

Json parametersOf(const BpNetwork &network)
{
    Json axes = Json::array();
    for (const BpNetwork::Axis &axis : network.axes) {
        axes.push_back({{"hidden_weights", toJson(axis.hiddenWeights)},
                        {"hidden_bias", toJson(axis.hiddenBias)},
                        {"output_weights", toJson(axis.outputWeights)},
                        {"output_bias", axis.outputBias},
                        {"output_mean_dps", axis.outputMeanDps},
                        {"output_scale_dps", axis.outputScaleDps}});
    }
    return {{"normalisation", standardiserToJson(network.inputs)}, {"axes", std::move(axes)}};
}

BpNetwork bpFrom(const FieldReader &reader)
{
    BpNetwork network;
    network.inputs = standardiserFrom(reader.child("normalisation"), BpNetwork::kFeatures);
    reader.objects("axes", network.axes.size(), [&network](std::size_t index, const FieldReader &fields) {
        BpNetwork::Axis &axis = network.axes[index];
        axis.hiddenBias = fields.vector("hidden_bias");
        const Eigen::Index hidden = axis.hiddenBias.size();
        if (hidden == 0 || hidden > kMostUnits)
            fields.fail("hidden_bias", "has no size that a network can have");
        axis.hiddenWeights = fields.matrix("hidden_weights", hidden, 2);
        axis.outputWeights = fields.vector("output_weights", hidden);
        axis.outputBias = fields.number("output_bias");
        axis.outputMeanDps = fields.number("output_mean_dps");
        axis.outputScaleDps = fields.positive("output_scale_dps");
    });
    return network;
}

Json parametersOf(const RbfNetwork &network)
{
    return {{"normalisation", standardiserToJson(network.inputs)},
            {"centres", toJson(Eigen::MatrixXd(network.centres))},
            {"widths", toJson(network.widths)},
            {"weights_dps", toJson(Eigen::MatrixXd(network.weightsDps))},
            {"linear_dps", toJson(Eigen::MatrixXd(network.linearDps))},
            {"bias_dps", toJson(Eigen::VectorXd(network.biasDps))},
            {"centre_count", network.centreCount}};
}

RbfNetwork rbfFrom(const FieldReader &reader)
{
    RbfNetwork network;
    network.inputs = standardiserFrom(reader.child("normalisation"), RbfNetwork::kFeatures);
    network.widths = reader.vector("widths");
    const Eigen::Index size = network.size();
    if (size > kMostUnits || !(network.widths.array() > 0.0).all())
        reader.fail("widths", "is not a list of at most " + std::to_string(kMostUnits) + " numbers above 0");
    network.centres = reader.matrix("centres", size, 3);
    network.weightsDps = reader.matrix("weights_dps", size, 3);
    network.linearDps = reader.matrix("linear_dps", 3, 3);
    network.biasDps = reader.vector("bias_dps", 3);
    const Eigen::VectorXd counts = reader.vector("centre_count", 3);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (counts[axis] < 0.0 || counts[axis] > static_cast<double>(size) ||
            counts[axis] != std::floor(counts[axis])) {
            reader.fail("centre_count", "is not a whole number from 0 to the number of centres");
            return network;
        }
        network.centreCount[static_cast<std::size_t>(axis)] = static_cast<int>(counts[axis]);
    }
    return network;
}

Json parametersOf(const PerAxisModel &model)
{
    Json axes = Json::array();
    for (const auto &axis : model.axes)
        axes.push_back(toJson(*axis));
    return {{"axes", std::move(axes)}};
}

struct KindName
{
    std::string operator()(const ConstantModel &) const { return "constant"; }
    std::string operator()(const LinearModel &) const { return "linear"; }
    std::string operator()(const PolynomialModel &) const { return "polynomial"; }
    std::string operator()(const BpNetwork &) const { return "bp network"; }
    std::string operator()(const RbfNetwork &) const { return "rbf network"; }
    std::string operator()(const PerAxisModel &) const { return "per axis"; }
};

} // namespace

std::string modelKind(const AnyModel &model)
{
    return std::visit(KindName(), model);
}

Json parametersToJson(const AnyModel &model)
{
    return std::visit([](const auto &m) { return parametersOf(m); }, model);
}

AnyModel modelFromParameters(const std::string &kind, const FieldReader &parameters)
{
    if (kind == "constant")
        return constantFrom(parameters);
    if (kind == "linear")
        return linearFrom(parameters);
    if (kind == "polynomial")
        return polynomialFrom(parameters);
    if (kind == "bp network")
        return bpFrom(parameters);
    return rbfFrom(parameters);
}

} // namespace driftbench
