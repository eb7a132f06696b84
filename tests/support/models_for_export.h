// Trained models with random parameters, for tests of what is made from a model.
#pragma once

#include "engine/base/random.h"
#include "engine/models/trained_model.h"

#include <QTest>

namespace driftbench::test {

inline TrainedModel framed(Random &random, std::string name, AnyModel model)
{
    TrainedModel trained;
    trained.name = std::move(name);
    trained.model = std::move(model);
    trained.lowestTemperatureC = random.uniform(-45.0, 10.0);
    trained.highestTemperatureC = trained.lowestTemperatureC + random.uniform(20.0, 120.0);
    trained.sensor = {"I3G4250D", "3408138"};
    trained.trainedOn = {"run1", "run2"};
    trained.verdicts = {Verdict::Yes, Verdict::Yes, Verdict::Yes};
    trained.reasons = {"gain 0.99", "gain 0.98", "gain 0.97"};
    return trained;
}

inline TrainedModel randomCubic(Random &random)
{
    PolynomialModel cubic;
    cubic.centreDeltaT = random.uniform(-10.0, 60.0);
    for (int power = 0; power < 4; ++power) {
        for (int axis = 0; axis < 3; ++axis)
            cubic.coefficients(power, axis) = random.normal() * std::pow(0.02, power);
    }
    TrainedModel trained = framed(random, "cubic", cubic);
    trained.referenceTemperatureC = trained.lowestTemperatureC;
    return trained;
}

// rootDps: weight of the signed root of dT, in dps for the mean square of the root in the trained range.
inline TrainedModel randomRbf(Random &random, double rootDps = 0.05)
{
    TrainedModel trained = framed(random, "rbf", ConstantModel{});
    const double span = trained.highestTemperatureC - trained.lowestTemperatureC;
    // At the lower end as in a campaign that starts cold, or anywhere.
    trained.referenceTemperatureC =
        trained.lowestTemperatureC + (random.below(2) == 0 ? 0.0 : random.uniform(0.0, span));
    const Eigen::VectorXd deltaT =
        Eigen::VectorXd::LinSpaced(200, trained.lowestTemperatureC - trained.referenceTemperatureC,
                                   trained.highestTemperatureC - trained.referenceTemperatureC);
    const Eigen::MatrixXd rows = temperatureQuantities(FeatureSet::DeltaTSquaredRoot, deltaT);
    RbfNetwork network;
    network.inputs = Standardiser::fit(rows, Eigen::VectorXd::Ones(rows.rows()));
    const Eigen::MatrixXd standardised = network.inputs.transform(rows);
    const Eigen::Index size = 3 + static_cast<Eigen::Index>(random.below(12));
    network.centres.resize(size, 3);
    network.widths.resize(size);
    network.weightsDps.resize(size, 3);
    for (Eigen::Index j = 0; j < size; ++j) {
        network.centres.row(j) = standardised.row(static_cast<Eigen::Index>(random.below(200)));
        network.widths[j] = random.uniform(0.15, 1.0);
        for (int axis = 0; axis < 3; ++axis)
            network.weightsDps(j, axis) = 0.3 * random.normal();
    }
    for (int axis = 0; axis < 3; ++axis) {
        network.biasDps[axis] = random.normal();
        network.linearDps(0, axis) = 0.5 * random.normal();
        network.linearDps(1, axis) = 0.2 * random.normal();
        network.linearDps(2, axis) = rootDps * random.normal();
    }
    trained.model = network;
    return trained;
}

inline TrainedModel randomModel(Random &random)
{
    return random.below(3) == 0 ? randomCubic(random) : randomRbf(random);
}

// The seed of a property test, printed so that a failure can be repeated.
inline Random announced(std::uint64_t seed)
{
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    return Random(seed);
}

} // namespace driftbench::test
