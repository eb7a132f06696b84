#include "engine/physics/drift_curves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace driftbench {

namespace {

constexpr double kTableStepsPerC = 64.0;
constexpr int kSpreadHarmonics = 5;
constexpr double kSpreadWavelengthC = 190.0;

double bump(double temperatureC, double centreC, double widthC)
{
    const double distance = (temperatureC - centreC) / widthC;
    return std::exp(-0.5 * distance * distance);
}

// A cubic in u with a soft step and a bump: what all named curves are made of.
struct NamedCurve
{
    std::array<double, 4> powersDps; // of u^0 .. u^3
    double stepDps, stepAtC, stepWidthC;
    double bumpDps, bumpAtC, bumpWidthC;

    double operator()(double temperatureC) const
    {
        const double u = (temperatureC - 22.5) / 62.5;
        const double cubic = powersDps[0] + u * (powersDps[1] + u * (powersDps[2] + u * powersDps[3]));
        return cubic + stepDps * std::tanh((temperatureC - stepAtC) / stepWidthC) +
               bumpDps * bump(temperatureC, bumpAtC, bumpWidthC);
    }
};

constexpr std::array<NamedCurve, kAxisCount> kCurved{{
    {{0.50, 2.00, 0.14, 0.00}, 0.45, 8.0, 12.0, 0.15, 55.0, 12.0},
    {{-0.30, -3.38, 0.40, 0.15}, 0.00, 0.0, 1.0, 0.11, 5.0, 18.0},
    {{0.30, 1.02, 0.06, 0.00}, 0.00, 0.0, 1.0, 0.14, -10.0, 15.0},
}};
constexpr std::array<NamedCurve, kAxisCount> kSteep{{
    {{0.50, 2.06, 0.00, 0.00}, 0.45, 20.0, 3.0, 0.25, 60.0, 5.0},
    {{-0.30, -3.45, 0.02, 0.00}, 0.09, 45.0, 3.0, 0.18, 0.0, 5.0},
    {{0.30, 1.09, 0.00, 0.00}, -0.13, -10.0, 3.0, 0.19, 35.0, 5.0},
}};
constexpr std::array<NamedCurve, kAxisCount> kMild{{
    {{0.15, 0.30, 0.05, 0.00}, 0.00, 0.0, 1.0, 0.00, 0.0, 1.0},
    {{-0.10, -0.35, 0.06, 0.03}, 0.00, 0.0, 1.0, 0.00, 0.0, 1.0},
    {{0.10, 0.20, -0.02, 0.00}, 0.00, 0.0, 1.0, 0.00, 0.0, 1.0},
}};
constexpr std::array<NamedCurve, kAxisCount> kNone{{
    {{0.0, 0.0, 0.0, 0.0}, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0},
    {{0.0, 0.0, 0.0, 0.0}, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0},
    {{0.0, 0.0, 0.0, 0.0}, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0},
}};

DriftCurves make(std::string_view name, const std::array<NamedCurve, kAxisCount> &curves)
{
    return {std::string(name), {curves[0], curves[1], curves[2]}};
}

// The relative deviation m(T) of one axis in one run; see the header.
struct RunDeviation
{
    double level;
    std::array<double, kSpreadHarmonics> cosines;
    std::array<double, kSpreadHarmonics> sines;

    explicit RunDeviation(Random &random) : level(random.normal())
    {
        for (int k = 0; k < kSpreadHarmonics; ++k) {
            cosines[k] = random.normal();
            sines[k] = random.normal();
        }
    }
    double operator()(double temperatureC) const
    {
        const double angle = 2.0 * std::numbers::pi * temperatureC / kSpreadWavelengthC;
        const double cosine = std::cos(angle);
        const double sine = std::sin(angle);
        double sum = level;
        double cosineK = 1.0;
        double sineK = 0.0;
        for (int k = 0; k < kSpreadHarmonics; ++k) {
            const double nextCosine = cosineK * cosine - sineK * sine; // of (k + 1) times the angle
            sineK = sineK * cosine + cosineK * sine;
            cosineK = nextCosine;
            sum += cosines[k] * cosineK + sines[k] * sineK;
        }
        return sum / std::sqrt(1.0 + kSpreadHarmonics);
    }
};

} // namespace

Result<DriftCurves> namedDriftCurves(std::string_view name)
{
    if (name == "curved")
        return make(name, kCurved);
    if (name == "steep")
        return make(name, kSteep);
    if (name == "mild")
        return make(name, kMild);
    if (name == "none")
        return make(name, kNone);
    std::string known;
    for (const std::string_view each : kDriftCurveNames)
        known += (known.empty() ? "" : ", ") + std::string(each);
    return Error{Errc::InvalidOption, "There is no drift curve \"" + std::string(name) +
                                          "\"; choose one of " + known +
                                          ", or comb, that of a sensor's combs."};
}

DriftCurves withRunSpread(const DriftCurves &curves, double spread, double turnOnBiasDps, Random random)
{
    DriftCurves run;
    run.name = curves.name;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const RunDeviation deviation(random);
        const double biasDps = turnOnBiasDps * random.normal();
        run.rateDps[axis] = [curve = curves.rateDps[axis], deviation, spread, biasDps](double temperatureC) {
            return curve(temperatureC) * (1.0 + spread * deviation(temperatureC)) + biasDps;
        };
    }
    return run;
}

DriftTable::DriftTable(const DriftCurves &curves, double lowestC, double highestC)
    : m_lowestC(lowestC), m_highestC(highestC)
{
    assert(lowestC <= highestC);
    const auto intervals = static_cast<std::size_t>(std::ceil((highestC - lowestC) * kTableStepsPerC));
    m_rateDps.resize(intervals + 2);
    for (std::size_t i = 0; i < m_rateDps.size(); ++i) {
        const double temperatureC = lowestC + static_cast<double>(i) / kTableStepsPerC;
        for (int axis = 0; axis < kAxisCount; ++axis)
            m_rateDps[i][axis] = curves.rateDps[axis](temperatureC);
    }
}

DriftTable::Place DriftTable::at(double temperatureC) const
{
    const double position = (std::clamp(temperatureC, m_lowestC, m_highestC) - m_lowestC) * kTableStepsPerC;
    const auto index = static_cast<std::int64_t>(position);
    return {m_rateDps.data() + index, position - static_cast<double>(index)};
}

Eigen::Vector3d DriftTable::rateDps(double temperatureC) const
{
    const Place place = at(temperatureC);
    return {place.rateDps(0), place.rateDps(1), place.rateDps(2)};
}

} // namespace driftbench
