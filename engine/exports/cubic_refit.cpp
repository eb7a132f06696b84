#include "engine/exports/cubic_refit.h"

#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr int kRows = 2001;

// Columns 1, x, x^2, x^3.
Eigen::Matrix<double, Eigen::Dynamic, 4> powers(const Eigen::VectorXd &x)
{
    Eigen::Matrix<double, Eigen::Dynamic, 4> columns(x.size(), 4);
    columns.col(0).setOnes();
    for (int k = 1; k < 4; ++k)
        columns.col(k) = columns.col(k - 1).cwiseProduct(x);
    return columns;
}

// The matrix that takes the coefficients of a cubic in x = (T - middle) / half to those in d = T - centre:
// x = (d + shift) / half, expanded by the binomial theorem.
Eigen::Matrix4d recentring(double shift, double half)
{
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    matrix(0, 0) = 1.0;
    for (int k = 1; k < 4; ++k) {
        for (int i = 0; i <= k; ++i) {
            matrix(i, k) = matrix(i, k - 1) * shift / half;
            if (i > 0)
                matrix(i, k) += matrix(i - 1, k - 1) / half;
        }
    }
    return matrix;
}

void measureLoss(CubicRefit &cubic, const TrainedModel &model, const std::array<bool, 3> &compensated)
{
    const Eigen::VectorXd temperatureC =
        Eigen::VectorXd::LinSpaced(kRows, model.lowestTemperatureC, model.highestTemperatureC);
    Eigen::MatrixX3d loss = predictAtTemperature(model, temperatureC).tdeDps;
    for (Eigen::Index i = 0; i < loss.rows(); ++i)
        loss.row(i) -= cubic.tdeDps(temperatureC[i]).transpose();
    for (std::size_t axis = 0; axis < compensated.size(); ++axis) {
        const auto column = static_cast<Eigen::Index>(axis);
        if (compensated[axis]) {
            cubic.largestLossDps[column] = loss.col(column).cwiseAbs().maxCoeff();
            cubic.rmsLossDps[column] = std::sqrt(loss.col(column).squaredNorm() / kRows);
        }
    }
}

} // namespace

Eigen::Vector3d CubicRefit::tdeDps(double temperatureC) const
{
    const double d = std::clamp(temperatureC, lowestTemperatureC, highestTemperatureC) - centreC;
    return coefficientsDps.transpose() * Eigen::Vector4d(1.0, d, d * d, d * d * d);
}

CubicRefit refitCubic(const TrainedModel &model, const std::array<bool, 3> &compensated, double centreC,
                      double lowestTemperatureC, double highestTemperatureC)
{
    CubicRefit cubic;
    cubic.centreC = centreC;
    cubic.lowestTemperatureC = lowestTemperatureC;
    cubic.highestTemperatureC = highestTemperatureC;

    // On [-1, 1] the powers are far better conditioned than in degrees.
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(kRows, -1.0, 1.0);
    const double middle = 0.5 * (lowestTemperatureC + highestTemperatureC);
    const double half = 0.5 * (highestTemperatureC - lowestTemperatureC);
    const Eigen::VectorXd temperatureC = (middle + half * x.array()).matrix();
    const Eigen::MatrixX3d tde = predictAtTemperature(model, temperatureC).tdeDps;
    const Eigen::Matrix<double, 4, 3> scaled = powers(x).householderQr().solve(tde);
    cubic.coefficientsDps = recentring(centreC - middle, half) * scaled;
    for (std::size_t axis = 0; axis < compensated.size(); ++axis) {
        if (!compensated[axis])
            cubic.coefficientsDps.col(static_cast<Eigen::Index>(axis)).setZero();
    }
    measureLoss(cubic, model, compensated);
    return cubic;
}

std::string lossSentence(const CubicRefit &cubic, const std::string &modelName,
                         const std::array<bool, 3> &compensated)
{
    std::string text;
    for (std::size_t axis = 0; axis < compensated.size(); ++axis) {
        if (!compensated[axis])
            continue;
        const auto column = static_cast<Eigen::Index>(axis);
        text += (text.empty() ? "" : ", ") + std::string("up to ") + fixed(cubic.largestLossDps[column], 4) +
                " dps (" + fixed(cubic.rmsLossDps[column], 4) + " dps rms) on " +
                std::string(kAxisNames[axis]);
    }
    return "Against model " + modelName + " the cubic is off by " + text + " over the trained range.";
}

} // namespace driftbench
