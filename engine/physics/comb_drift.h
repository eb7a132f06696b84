// The drift of a gyro from the thermal stress of its sensing combs, per axis (comb_capacitor.h):
//
//   g(T) = dE(T - T0, (r + omega) k) / S + p(T),   S = k C0 / d0
//
// dE is the capacitance error (Eq. 11), k the displacement of the combs by one dps, omega the reference rate
// and r the rest displacement of combs that are not symmetrical, as the rate that would displace them as far.
// S is the change of capacitance by one dps at T0, C0 the capacitance of straight combs at rest. At T0 the
// combs drift by nothing; away from it by their change of sensitivity times r + omega, to first order.
//
// p is a package term: h tanh((T - Ts) / w). It is made up, without a formula behind it, and stands for what
// the combs alone do not explain: die attach and stress of the package.
//
// Temperatures in degrees Celsius, rates in dps, displacements in micrometres. The default k is made up too:
// 2.5 nm at 245 dps, so little of the gap that g hardly depends on it.
#pragma once

#include "engine/base/axes.h"
#include "engine/base/result.h"
#include "engine/physics/comb_capacitor.h"
#include "engine/physics/drift_curves.h"

#include <Eigen/Core>
#include <array>
#include <string_view>

namespace driftbench {

inline constexpr std::string_view kCombDriftName = "comb";

struct PackageTerm
{
    double stepDps = 0.0; // h: half of the way from cold to hot
    double stepAtC = 25.0;
    double stepWidthC = 15.0;
};

struct CombAxis
{
    CombParameters combs{};
    double restDps = 0.0;
    PackageTerm package{};
};

struct CombDrift
{
    std::array<CombAxis, kAxisCount> axes{};
    double displacementPerDpsUm = 1e-5;
};

// The curves, named kCombDriftName. Where the combs of an axis touch its curve is NaN. Errc::InvalidOption as
// CombCapacitor::create says, or for a displacement per dps or a width of the package term that is not
// positive, or figures that are not finite.
Result<DriftCurves> combDriftCurves(const CombDrift &drift, const Eigen::Vector3d &referenceRateDps);

} // namespace driftbench
