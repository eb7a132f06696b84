#include "support/view_data.h"

#include <Eigen/QR>

#include <cmath>

namespace driftbench::test {

static constexpr double kNoiseDps = 0.14;
static constexpr double kHoldS = 1800.0;
static constexpr double kStepS = 30.0;
static constexpr double kStepC = 0.5;
static constexpr double kSpanC = 125.0;
static constexpr double kRunS = 2.0 * kHoldS + kStepS * kSpanC / kStepC;

Eigen::Vector3d trueTdeDps(double deltaT)
{
    const double u = deltaT / kSpanC;
    return {3.6 * u + 0.6 * std::sin(5.0 * u), 4.2 * u - 0.9 * std::exp(-8.0 * (u - 0.4) * (u - 0.4)) + 0.25,
            1.4 * u * u - 0.1 * std::cos(9.0 * u)};
}

static double profileDeltaT(double timeS)
{
    const double steps = std::floor((timeS - kHoldS) / kStepS) + 1.0;
    return std::clamp(steps * kStepC, 0.0, kSpanC);
}

std::shared_ptr<const RunFeatures> syntheticRun(std::uint64_t seed, double secondsASample, bool cooling)
{
    Random random(seed);
    const auto count = static_cast<Eigen::Index>(std::lround(kRunS / secondsASample));
    auto run = std::make_shared<RunFeatures>();
    run->name = "run" + std::to_string(seed);
    run->timeS.resize(count);
    run->deltaT.resize(count);
    run->tdeDps.resize(count, 3);
    run->usableForTraining.assign(static_cast<std::size_t>(count), 1);
    const double spread = 1.0 + 0.01 * random.normal();
    double temperature = cooling ? kSpanC : 0.0;
    for (Eigen::Index i = 0; i < count; ++i) {
        run->timeS[i] = secondsASample * static_cast<double>(i);
        const double target = profileDeltaT(cooling ? kRunS - run->timeS[i] : run->timeS[i]);
        temperature += (target - temperature) * std::min(1.0, secondsASample / 8.0);
        run->deltaT[i] = temperature + 0.01 * random.normal();
        const Eigen::Vector3d tde =
            spread * trueTdeDps(temperature + (cooling ? 1.5 : 0.0)) +
            kNoiseDps * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
        run->tdeDps.row(i) = tde.transpose();
        if (i % 997 == 500) {
            run->tdeDps.row(i).array() += 1.5;
            run->usableForTraining[static_cast<std::size_t>(i)] = 0;
        } else {
            run->curve.add(run->deltaT[i], tde);
        }
    }
    return run;
}

std::vector<std::shared_ptr<const RunFeatures>> syntheticRuns(int count, double secondsASample)
{
    std::vector<std::shared_ptr<const RunFeatures>> runs;
    for (int i = 0; i < count; ++i)
        runs.push_back(syntheticRun(static_cast<std::uint64_t>(i + 1), secondsASample, i % 2 == 1));
    return runs;
}

static TrainedModel described(std::string name, AnyModel bare)
{
    TrainedModel model;
    model.name = std::move(name);
    model.model = std::move(bare);
    model.referenceTemperatureC = kReferenceTemperatureC;
    model.lowestTemperatureC = kReferenceTemperatureC;
    model.highestTemperatureC = kReferenceTemperatureC + kSpanC;
    model.simulated = true;
    model.trainedOn = {"run1", "run2"};
    return model;
}

static Eigen::VectorXd trainingGrid()
{
    return Eigen::VectorXd::LinSpaced(251, 0.0, kSpanC);
}

static Eigen::MatrixX3d trueCurve(const Eigen::VectorXd &deltaT)
{
    Eigen::MatrixX3d tde(deltaT.size(), 3);
    for (Eigen::Index i = 0; i < deltaT.size(); ++i)
        tde.row(i) = trueTdeDps(deltaT[i]).transpose();
    return tde;
}

TrainedModel syntheticRbf()
{
    constexpr int kCentres = 8;
    const Eigen::VectorXd deltaT = trainingGrid();
    const Eigen::MatrixXd quantities = temperatureQuantities(FeatureSet::DeltaTSquaredRoot, deltaT);
    RbfNetwork network;
    network.inputs = Standardiser::fit(quantities, Eigen::VectorXd::Ones(deltaT.size()));
    const Eigen::VectorXd places = Eigen::VectorXd::LinSpaced(kCentres, 4.0, kSpanC - 4.0);
    network.centres = network.inputs.transform(temperatureQuantities(FeatureSet::DeltaTSquaredRoot, places));
    network.widths = Eigen::VectorXd::Constant(kCentres, 0.6);
    network.centreCount = {kCentres, kCentres, kCentres};
    const Eigen::MatrixXd z = network.inputs.transform(quantities);
    Eigen::MatrixXd design(deltaT.size(), kCentres + 4);
    design.col(0).setOnes();
    design.middleCols(1, 3) = z;
    for (int k = 0; k < kCentres; ++k)
        design.col(4 + k) =
            (-(z.rowwise() - network.centres.row(k)).rowwise().squaredNorm() / (2.0 * 0.36)).array().exp();
    const Eigen::MatrixXd weights = design.colPivHouseholderQr().solve(trueCurve(deltaT));
    network.biasDps = weights.row(0).transpose();
    network.linearDps = weights.middleRows(1, 3);
    network.weightsDps = weights.bottomRows(kCentres);
    return described("rbf", network);
}

TrainedModel syntheticLine()
{
    const Eigen::VectorXd deltaT = trainingGrid();
    Eigen::MatrixXd design(deltaT.size(), 2);
    design << Eigen::VectorXd::Ones(deltaT.size()), deltaT;
    const Eigen::MatrixXd solution = design.colPivHouseholderQr().solve(trueCurve(deltaT));
    LinearModel line;
    line.biasDps = solution.row(0).transpose();
    line.slopeDpsPerC = solution.row(1).transpose();
    return described("linear", line);
}

UncertaintyBand syntheticBand()
{
    UncertaintyBand band;
    band.runs = 5;
    band.temperatureC = Eigen::VectorXd::LinSpaced(64, kReferenceTemperatureC + 1.0, 84.0);
    band.curveHalfWidthDps.resize(64, 3);
    for (Eigen::Index i = 0; i < 64; ++i)
        band.curveHalfWidthDps.row(i).setConstant(0.05 + 0.001 * static_cast<double>(i));
    band.curveHalfWidthDps.row(30).setConstant(NAN);
    band.sampleHalfWidthDps = band.curveHalfWidthDps.array() + 0.27;
    return band;
}

RbfSelection syntheticSelection()
{
    RbfSelection selection;
    selection.chosen = {8, 11, 6};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int k = 0; k <= 48; ++k) {
            const double fit = std::pow(10.0, static_cast<double>(axis) - 0.35 * k) + 0.002;
            selection.trainingLoss[axis].push_back(fit - 0.00001 * k);
            selection.heldOutLoss[axis].push_back(fit + 0.002 + 0.00002 * k);
        }
    }
    return selection;
}

AllanCurve syntheticAllan(double driftDpsAtHour)
{
    constexpr int kPoints = 40;
    AllanCurve curve;
    curve.tauS.resize(kPoints);
    curve.deviationDps.resize(kPoints, 3);
    for (int i = 0; i < kPoints; ++i) {
        const double tau = 0.1 * std::pow(10.0, i / 9.0);
        curve.tauS[i] = tau;
        for (int axis = 0; axis < 3; ++axis) {
            const double drift = driftDpsAtHour * (1.0 + axis) * tau / 3600.0;
            curve.deviationDps(i, axis) = std::sqrt(0.0002 / tau + drift * drift);
        }
    }
    return curve;
}

Eigen::MatrixX3d residualOf(const RunFeatures &run, const TrainedModel &model)
{
    const Eigen::VectorXd temperatureC = run.deltaT.array() + model.referenceTemperatureC;
    return run.tdeDps - predictAtTemperature(model, temperatureC).tdeDps;
}

} // namespace driftbench::test
