#include "engine/evaluation/tcq_explained.h"

#include "engine/features/temperature_quantities.h"
#include "engine/models/least_squares.h"

#include <cassert>
#include <cmath>

namespace driftbench {

namespace {

constexpr Eigen::Index kFewestPoints = 8; // twice the terms of the largest set

Eigen::MatrixXd withConstant(const Eigen::MatrixXd &quantities)
{
    Eigen::MatrixXd design(quantities.rows(), quantities.cols() + 1);
    design << Eigen::VectorXd::Ones(quantities.rows()), quantities;
    return design;
}

TcqShare shareOf(std::string name, const Eigen::MatrixXd &design, const Eigen::VectorXd &error)
{
    TcqShare share;
    share.name = std::move(name);
    share.terms = design.cols();
    share.residual = error - design * solveLeastSquares(design, error);
    const double left = share.residual.squaredNorm();
    share.unexplained = left / (error.array() - error.mean()).matrix().squaredNorm();
    share.explained = 1.0 - share.unexplained;
    share.residualRms = std::sqrt(left / static_cast<double>(error.size()));
    share.residualLargest = share.residual.cwiseAbs().maxCoeff();
    return share;
}

} // namespace

Result<std::vector<TcqShare>> explainedByQuantities(const Eigen::VectorXd &deltaTC,
                                                    const Eigen::VectorXd &error)
{
    assert(deltaTC.size() == error.size());
    if (deltaTC.size() < kFewestPoints)
        return Error{Errc::TooFewSamples, "There are " + std::to_string(deltaTC.size()) +
                                              " temperatures to fit the quantities to; give at least " +
                                              std::to_string(kFewestPoints) + "."};
    if (deltaTC.maxCoeff() == deltaTC.minCoeff())
        return Error{Errc::ConstantTemperature,
                     "All temperatures are the same; give a range of temperature to fit the quantities to."};
    if (error.maxCoeff() == error.minCoeff())
        return Error{Errc::InvalidOption,
                     "The error is the same at all temperatures, so there is nothing to explain; give a "
                     "displacement and an expansion that are not 0."};
    return std::vector<TcqShare>{
        shareOf("ΔT", withConstant(temperatureQuantities(FeatureSet::DeltaT, deltaTC)), error),
        shareOf("ΔT, ΔT²", withConstant(temperatureQuantities(FeatureSet::DeltaTSquared, deltaTC)), error),
        shareOf("ΔT, ΔT², √ΔT", withConstant(temperatureQuantities(FeatureSet::DeltaTSquaredRoot, deltaTC)),
                error),
        shareOf("ΔT, ΔT², ΔT³", powersOf(deltaTC, 3), error)};
}

} // namespace driftbench
