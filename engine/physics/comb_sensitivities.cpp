#include "engine/physics/comb_sensitivities.h"

#include "engine/physics/comb_formula.h"

#include <limits>

namespace driftbench {

namespace {

constexpr int kVariables = 8; // that the closed form depends on
using Variable = Eigen::AutoDiffScalar<Eigen::Matrix<double, kVariables, 1>>;

Variable errorWithSlopesFf(const CombParameters &parameters, double deltaTC, double displacementUm)
{
    const CombGeometry &geometry = parameters.geometry;
    const auto variable = [](double value, int place) { return Variable(value, kVariables, place); };
    const CombInputs<Variable> inputs{variable(parameters.material.expansionPerC, 0),
                                      variable(geometry.thicknessUm, 1),
                                      variable(geometry.overlapLengthUm, 2),
                                      variable(geometry.overlapWidthUm, 3),
                                      variable(geometry.gapUm, 4),
                                      variable(geometry.relativePermittivity, 5),
                                      variable(displacementUm, 6),
                                      variable(deltaTC, 7),
                                      static_cast<double>(geometry.gapCount)};
    return CombTerms<Variable>(inputs).errorFf();
}

} // namespace

Result<CombSensitivities> combSensitivities(const CombCapacitor &comb, double deltaTC, double displacementUm)
{
    if (const auto possible = comb.errorFf(deltaTC, displacementUm); !possible)
        return possible.error();
    const auto &[material, geometry, straightAtC] = comb.parameters();
    const Variable error = errorWithSlopesFf(comb.parameters(), deltaTC, displacementUm);
    const auto &slope = error.derivatives();
    CombSensitivities all{{
        {"alpha", "thermal expansion coefficient", "1/°C", material.expansionPerC, slope[0]},
        {"E", "elastic modulus", "GPa", material.elasticModulusGPa, 0.0},
        {"nu", "Poisson ratio", "1", material.poissonRatio, 0.0},
        {"a0", "comb thickness", "µm", geometry.thicknessUm, slope[1]},
        {"b0", "overlap length", "µm", geometry.overlapLengthUm, slope[2]},
        {"c0", "overlap width", "µm", geometry.overlapWidthUm, slope[3]},
        {"d0", "gap", "µm", geometry.gapUm, slope[4]},
        {"eps", "relative permittivity", "1", geometry.relativePermittivity, slope[5]},
        {"dd", "displacement", "µm", displacementUm, slope[6]},
        {"dT", "temperature difference", "°C", deltaTC, slope[7]},
    }};
    for (CombSensitivity &each : all)
        each.relative = error.value() != 0.0 ? each.value * each.slopeFfPerUnit / error.value()
                                             : std::numeric_limits<double>::quiet_NaN();
    return all;
}

} // namespace driftbench
