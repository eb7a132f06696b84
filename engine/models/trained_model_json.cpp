#include "engine/models/trained_model_json.h"

#include "engine/base/axes.h"

#include <algorithm>

namespace driftbench {

namespace {

// What the columns that a model looks at are, for whoever evaluates it elsewhere.
Json featuresToJson(FeatureSet set)
{
    constexpr std::array<const char *, 3> kFormulas{"T - reference_temperature_C", "dT * dT",
                                                    "sign(dT) * sqrt(abs(dT))"};
    Json formulas = Json::array();
    for (std::size_t i = 0; i < static_cast<std::size_t>(set); ++i)
        formulas.push_back(kFormulas[i]);
    return {{"set", featureSetName(set)}, {"formulas", std::move(formulas)}};
}

Json verdictsToJson(const TrainedModel &model)
{
    Json verdicts = Json::array();
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
        verdicts.push_back(
            {{"axis", kAxisNames[axis]},
             {"verdict", model.verdicts[axis] ? Json(verdictName(*model.verdicts[axis])) : Json()},
             {"reason", model.reasons[axis]}});
    }
    return verdicts;
}

Json bandToJson(const std::optional<UncertaintyBand> &band)
{
    if (!band)
        return nullptr;
    return {{"runs", band->runs},
            {"temperature_C", toJson(band->temperatureC)},
            {"curve_half_width_dps", toJson(Eigen::MatrixXd(band->curveHalfWidthDps))},
            {"sample_half_width_dps", toJson(Eigen::MatrixXd(band->sampleHalfWidthDps))}};
}

UncertaintyBand bandFrom(const FieldReader &reader)
{
    constexpr int kMostRuns = 1000000;
    UncertaintyBand band;
    band.runs = reader.count("runs", kMostRuns);
    band.temperatureC = reader.vector("temperature_C");
    const Eigen::Index bins = band.temperatureC.size();
    band.curveHalfWidthDps = reader.matrix("curve_half_width_dps", bins, 3, FieldReader::Gaps::AsNaN);
    band.sampleHalfWidthDps = reader.matrix("sample_half_width_dps", bins, 3, FieldReader::Gaps::AsNaN);
    return band;
}

void readVerdict(std::size_t axis, const FieldReader &reader, TrainedModel &model)
{
    reader.expectText("axis", std::string(kAxisNames[axis]));
    model.reasons[axis] = reader.text("reason");
    if (reader.isNull("verdict"))
        return;
    model.verdicts[axis] = verdictFromName(reader.text("verdict"));
    if (!model.verdicts[axis])
        reader.fail("verdict", "is none that is known");
}

PerAxisModel perAxisFrom(const FieldReader &parameters)
{
    PerAxisModel model;
    parameters.objects("axes", model.axes.size(), [&model](std::size_t axis, const FieldReader &reader) {
        if (reader.text("kind") == "per axis") {
            reader.fail("kind", "is again \"per axis\"");
            return;
        }
        model.axes[axis] = std::make_shared<const TrainedModel>(trainedModelFrom(reader));
    });
    return model;
}

AnyModel modelFrom(const FieldReader &reader)
{
    const std::string kind = reader.text("kind");
    const std::array<AnyModel, 6> kinds{ConstantModel(), LinearModel(), PolynomialModel(),
                                        BpNetwork(),     RbfNetwork(),  PerAxisModel()};
    const auto known = std::find_if(kinds.begin(), kinds.end(),
                                    [&kind](const AnyModel &each) { return modelKind(each) == kind; });
    if (known == kinds.end()) {
        reader.fail("kind", "is \"" + kind + "\", which this version does not know");
        return ConstantModel();
    }
    reader.child("features").expectText("set", std::string(featureSetName(featuresOf(*known))));
    const FieldReader parameters = reader.child("parameters");
    return kind == "per axis" ? AnyModel(perAxisFrom(parameters)) : modelFromParameters(kind, parameters);
}

void readRange(const FieldReader &reader, TrainedModel &model)
{
    model.lowestTemperatureC = reader.number("lowest_temperature_C");
    model.highestTemperatureC = reader.number("highest_temperature_C");
    if (model.lowestTemperatureC > model.highestTemperatureC)
        reader.fail("lowest_temperature_C", "is above the highest");
}

} // namespace

Json toJson(const TrainedModel &model)
{
    return {{"name", model.name},
            {"kind", modelKind(model.model)},
            {"units", {{"rate", "dps"}, {"temperature", "degC"}}},
            {"features", featuresToJson(featuresOf(model.model))},
            {"reference_temperature_C", model.referenceTemperatureC},
            {"trained_range",
             {{"lowest_temperature_C", model.lowestTemperatureC},
              {"highest_temperature_C", model.highestTemperatureC}}},
            {"sensor", {{"model", model.sensor.model}, {"serial", model.sensor.serial}}},
            {"simulated", model.simulated},
            {"trained_on", model.trainedOn},
            {"seed", model.seed},
            {"judging", model.judging},
            {"verdicts", verdictsToJson(model)},
            {"summary", model.summary},
            {"band", bandToJson(model.band)},
            {"parameters", parametersToJson(model.model)}};
}

TrainedModel trainedModelFrom(const FieldReader &reader)
{
    TrainedModel model;
    model.name = reader.text("name");
    const FieldReader units = reader.child("units");
    units.expectText("rate", "dps");
    units.expectText("temperature", "degC");
    model.model = modelFrom(reader);
    model.referenceTemperatureC = reader.number("reference_temperature_C");
    readRange(reader.child("trained_range"), model);
    const FieldReader sensor = reader.child("sensor");
    model.sensor = {sensor.text("model"), sensor.text("serial")};
    model.simulated = reader.flag("simulated");
    model.trainedOn = reader.texts("trained_on");
    model.seed = reader.unsignedWhole("seed");
    model.judging = reader.text("judging");
    reader.objects("verdicts", model.verdicts.size(),
                   [&model](std::size_t axis, const FieldReader &each) { readVerdict(axis, each, model); });
    model.summary = reader.namedNumbers("summary");
    if (!reader.isNull("band"))
        model.band = bandFrom(reader.child("band"));
    return model;
}

} // namespace driftbench
