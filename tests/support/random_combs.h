// Comb geometries drawn at random, of the sizes that silicon combs have, and their integrals by quadrature.
#pragma once

#include "engine/base/random.h"
#include "engine/physics/comb_capacitor.h"
#include "tests/support/adaptive_quadrature.h"

#include <cmath>

namespace driftbench::test {

inline CombParameters randomComb(Random &random)
{
    const auto between = [&random](double low, double high) {
        return low * std::pow(high / low, random.uniform());
    };
    CombParameters comb;
    comb.material.expansionPerC = between(5e-7, 2e-5);
    comb.geometry = {between(1.0, 10.0),
                     between(3.0, 200.0),
                     between(5.0, 100.0),
                     between(0.5, 5.0),
                     1 + static_cast<int>(500.0 * random.uniform()),
                     between(1.0, 4.0)};
    comb.straightAtC = -40.0 + 125.0 * random.uniform();
    return comb;
}

// The comb in long double, straight from Eqs. (5) to (10); nothing is shared with the engine but the inputs.
struct CombIntegrals
{
    long double bend; // K = 12 alpha dT / a0
    long double b0, d0, growth, scaleFf;

    CombIntegrals(const CombParameters &comb, double deltaTC)
        : bend(12.0L * comb.material.expansionPerC * deltaTC / comb.geometry.thicknessUm)
        , b0(comb.geometry.overlapLengthUm)
        , d0(comb.geometry.gapUm)
        , growth(2.0L * comb.material.expansionPerC * deltaTC)
        , scaleFf(8.8541878188e-3L * comb.geometry.gapCount * comb.geometry.relativePermittivity *
                  comb.geometry.overlapWidthUm)
    {
    }

    long double narrowing(long double x) const { return bend * (2 * x * x - 2 * b0 * x + b0 * b0); }

    long double capacitanceFf(long double displacement) const
    {
        const auto integral =
            integrate([&](long double x) { return 1 / (d0 - narrowing(x) - displacement); }, 0, b0);
        return scaleFf * (1 + growth) * (1 + growth) * integral;
    }
    long double changeFf(long double displacement) const
    {
        const auto integrand = [&](long double x) {
            const long double gap = d0 - narrowing(x);
            return displacement / ((gap - displacement) * gap);
        };
        return scaleFf * (1 + growth) * (1 + growth) * integrate(integrand, 0, b0);
    }
    // The integrand of dC' - dC brought to one denominator, so that it keeps its digits near dT = 0.
    long double errorFf(long double displacement) const
    {
        const auto integrand = [&](long double x) {
            const long double n = narrowing(x);
            const long double first = d0 - displacement;
            const long double area = growth * (2 + growth) / ((first - n) * (d0 - n));
            return displacement * (area + n * (first + d0 - n) / (first * d0 * (first - n) * (d0 - n)));
        };
        return scaleFf * integrate(integrand, 0, b0);
    }
    // Of the narrowest gap that is left, as a fraction of the gap without bending.
    long double clearance(long double displacement) const
    {
        const long double rest = d0 - std::max(displacement, 0.0L);
        return (rest - bend * b0 * b0) / rest;
    }
};

} // namespace driftbench::test
