// How the capacitance error dE of a comb (Eq. 11, corrected) changes with each of its parameters.
//
//   slope     d(dE)/dp, in fF per unit of p
//   relative  (p / dE) d(dE)/dp: percent of dE per percent of p; NaN where dE is zero
// By forward automatic differentiation of the closed form (comb_formula.h), exact to rounding. Elastic
// modulus and Poisson ratio have none: the modulus stands in the moment (Eq. 7) and in the stiffness that it
// bends (Eq. 8) and cancels, and the beam of Eq. (8) has no lateral contraction. dE is proportional to the
// number of gaps, which is not listed as it cannot change by a little.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/comb_capacitor.h"

#include <array>
#include <string_view>

namespace driftbench {

struct CombSensitivity
{
    std::string_view symbol; // as in comb_capacitor.h
    std::string_view name;
    std::string_view unit; // of the parameter
    double value = 0.0;    // of the parameter
    double slopeFfPerUnit = 0.0;
    double relative = 0.0;
};

inline constexpr std::size_t kCombSensitivityCount = 10;
using CombSensitivities = std::array<CombSensitivity, kCombSensitivityCount>;

// The errors of CombCapacitor::errorFf.
Result<CombSensitivities> combSensitivities(const CombCapacitor &comb, double deltaTC, double displacementUm);

} // namespace driftbench
