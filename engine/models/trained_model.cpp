#include "engine/models/trained_model.h"

#include <algorithm>

namespace driftbench {

namespace {

constexpr std::array<std::pair<Verdict, std::string_view>, 4> kVerdictNames{
    {{Verdict::Yes, "yes"},
     {Verdict::WithCare, "with care"},
     {Verdict::NotRepeatable, "not repeatable"},
     {Verdict::NoDrift, "no drift"}}};

} // namespace

std::string_view verdictName(Verdict verdict)
{
    for (const auto &[value, name] : kVerdictNames) {
        if (value == verdict)
            return name;
    }
    return "";
}

std::optional<Verdict> verdictFromName(std::string_view name)
{
    for (const auto &[value, known] : kVerdictNames) {
        if (known == name)
            return value;
    }
    return std::nullopt;
}

Eigen::MatrixX3d PerAxisModel::predict(const Eigen::MatrixXd &quantities) const
{
    Eigen::MatrixX3d tde(quantities.rows(), 3);
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        const auto column = static_cast<Eigen::Index>(axis);
        tde.col(column) = predictAtDeltaT(axes[axis]->model, quantities.col(0)).col(column);
    }
    return tde;
}

FeatureSet featuresOf(const AnyModel &model)
{
    return std::visit([](const auto &m) { return std::decay_t<decltype(m)>::kFeatures; }, model);
}

Eigen::MatrixX3d predictAtDeltaT(const AnyModel &model, const Eigen::VectorXd &deltaT)
{
    return std::visit(
        [&](const auto &m) {
            return m.predict(temperatureQuantities(std::decay_t<decltype(m)>::kFeatures, deltaT));
        },
        model);
}

Prediction predictAtTemperature(const TrainedModel &model, const Eigen::VectorXd &temperatureC)
{
    const double low = model.lowestTemperatureC;
    const double high = model.highestTemperatureC;
    Prediction prediction;
    prediction.outsideTrainedRange =
        (temperatureC.array() < low).count() + (temperatureC.array() > high).count();
    const Eigen::VectorXd held = temperatureC.cwiseMax(low).cwiseMin(high);
    prediction.tdeDps = predictAtDeltaT(model.model, (held.array() - model.referenceTemperatureC).matrix());
    return prediction;
}

} // namespace driftbench
