// The drift of a gyro's rate with its die temperature: one function per axis, temperature in degrees Celsius
// to rate in dps. This is the seam between what causes the drift and the simulator that plays it.
//
// Named curves, u = (T - 22.5 C) / 62.5 C, all made up to lie where a three-axis MEMS gyro lies:
//   curved  smooth; mean square over the paper's profile about 4, 6 and 0.7 dps^2 on x, y, z, the size of the
//           column before compensation of the paper's Tables 2-6; a cubic leaves 22, 0.9 and 2 % of the
//           variance of 0.14 dps of noise
//   steep   the same size, with a step tanh((T - T0) / 3 C) and a bump exp(-((T - T1) / 5 C)^2 / 2) per axis;
//           a cubic leaves 70, 11 and 15 %
//   mild    a tenth of the swing, close to a parabola
//   none    no drift
//
// Run-to-run spread s: the curve of a run is g(T) (1 + s m(T)) + b, with per axis
//   m(T) = (n0 + sum over k = 1..5 of n_k cos(k w T) + n'_k sin(k w T)) / sqrt(6),  w = 2 pi / 190 C,
// all n standard normal. m has mean 0 and variance 1 at every temperature: s is the relative standard
// deviation of the runs wherever one looks. A sixth of the variance is a factor of the whole curve, the rest
// smooth changes of shape no finer than 38 C. b is the turn-on bias, normal with its own standard deviation.
#pragma once

#include "engine/base/axes.h"
#include "engine/base/random.h"
#include "engine/base/result.h"

#include <Eigen/Core>
#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

using DriftFunction = std::function<double(double temperatureC)>;

struct DriftCurves
{
    std::string name;
    std::array<DriftFunction, kAxisCount> rateDps;
};

inline constexpr std::array<std::string_view, 4> kDriftCurveNames{"curved", "steep", "mild", "none"};

// One of kDriftCurveNames; else Errc::InvalidOption.
Result<DriftCurves> namedDriftCurves(std::string_view name);

// The curves of one run; random gives the run its own.
DriftCurves withRunSpread(const DriftCurves &curves, double spread, double turnOnBiasDps, Random random);

// Drift curves tabulated every 1/64 C and joined by straight lines, so that a sample costs the same whatever
// the function costs. Outside its range the table holds the edge. Joining bends a curve by at most
// max|g''| (1/64 C)^2 / 8, 2e-6 dps at the sharpest of the named ones.
class DriftTable
{
public:
    DriftTable(const DriftCurves &curves, double lowestC, double highestC);

    // The piece of the table that holds a temperature (finite), ready to be read axis by axis.
    struct Place
    {
        const Eigen::Vector3d *node;
        double part; // of the way to the next node

        double rateDps(int axis) const { return node[0][axis] + part * (node[1][axis] - node[0][axis]); }
    };
    Place at(double temperatureC) const;

    Eigen::Vector3d rateDps(double temperatureC) const;

    double lowestC() const { return m_lowestC; }
    double highestC() const { return m_highestC; }

private:
    double m_lowestC;
    double m_highestC;
    std::vector<Eigen::Vector3d> m_rateDps;
};

} // namespace driftbench
