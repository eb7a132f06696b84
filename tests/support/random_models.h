// Models of every kind with random parameters, for tests of what must hold for any model.
#pragma once

#include "engine/base/random.h"
#include "engine/models/trained_model.h"

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace driftbench::test {

inline Eigen::MatrixXd randomMatrix(Random &random, Eigen::Index rows, Eigen::Index columns)
{
    // Magnitudes over many decades, so that writing with too few digits shows.
    return Eigen::MatrixXd::NullaryExpr(
        rows, columns, [&] { return random.normal() * std::pow(10.0, random.uniform(-6.0, 2.0)); });
}

inline Standardiser randomStandardiser(Random &random, Eigen::Index columns)
{
    return {randomMatrix(random, 1, columns), randomMatrix(random, 1, columns).cwiseAbs().array() + 1.0};
}

inline BpNetwork randomBpNetwork(Random &random)
{
    BpNetwork network;
    network.inputs = randomStandardiser(random, 2);
    const auto hidden = static_cast<Eigen::Index>(1 + random.below(12));
    for (auto &axis : network.axes) {
        axis = {randomMatrix(random, hidden, 2),
                randomMatrix(random, hidden, 1),
                randomMatrix(random, hidden, 1),
                random.normal(),
                random.normal(),
                0.1 + random.uniform()};
    }
    return network;
}

inline RbfNetwork randomRbfNetwork(Random &random)
{
    RbfNetwork network;
    network.inputs = randomStandardiser(random, 3);
    const auto size = static_cast<Eigen::Index>(random.below(20));
    network.centres = randomMatrix(random, size, 3);
    network.widths = randomMatrix(random, size, 1).cwiseAbs().array() + 0.01;
    network.weightsDps = randomMatrix(random, size, 3);
    network.linearDps = randomMatrix(random, 3, 3);
    network.biasDps = randomMatrix(random, 3, 1);
    for (int &count : network.centreCount)
        count = static_cast<int>(random.below(static_cast<std::uint64_t>(size) + 1));
    return network;
}

inline TrainedModel randomTrained(Random &random, const std::string &name, AnyModel model)
{
    TrainedModel trained;
    trained.name = name;
    trained.model = std::move(model);
    trained.referenceTemperatureC = random.normal() * 20.0;
    trained.lowestTemperatureC = -40.0 + random.uniform();
    trained.highestTemperatureC = 85.0 + random.uniform();
    trained.sensor = {"I3G4250D", "SIM-\"0001\" \xC3\xA9"};
    trained.simulated = random.below(2) == 0;
    trained.trainedOn = {"run1", "run 2"};
    trained.seed = random.bits();
    trained.judging = "anchored";
    trained.summary = {{"centres_x", 8.0}, {"held_out_rms_y_dps", random.normal()}};
    trained.verdicts = {Verdict::Yes, std::nullopt, Verdict::NoDrift};
    trained.reasons = {"line 1\nline 2", "",
                       "\xE2\x88\x92"
                       "3.99"};
    if (random.below(2) == 0) {
        UncertaintyBand band{5, randomMatrix(random, 7, 1), randomMatrix(random, 7, 3).cwiseAbs(),
                             randomMatrix(random, 7, 3).cwiseAbs()};
        band.curveHalfWidthDps(2, 1) = std::numeric_limits<double>::quiet_NaN();
        trained.band = band;
    }
    return trained;
}

// One of each kind, "per axis" last.
inline std::vector<TrainedModel> randomModelsOfEveryKind(Random &random)
{
    PolynomialModel cubic;
    cubic.centreDeltaT = random.normal();
    cubic.coefficients = randomMatrix(random, 4, 3);
    std::vector<TrainedModel> models;
    models.push_back(randomTrained(random, "constant", ConstantModel{randomMatrix(random, 3, 1)}));
    models.push_back(
        randomTrained(random, "linear", LinearModel{randomMatrix(random, 3, 1), randomMatrix(random, 3, 1)}));
    models.push_back(randomTrained(random, "cubic", cubic));
    models.push_back(randomTrained(random, "bpnn", randomBpNetwork(random)));
    models.push_back(randomTrained(random, "rbf", randomRbfNetwork(random)));
    PerAxisModel perAxis;
    for (auto &axis : perAxis.axes)
        axis = std::make_shared<const TrainedModel>(models[random.below(models.size())]);
    models.push_back(randomTrained(random, "auto", perAxis));
    return models;
}

} // namespace driftbench::test
