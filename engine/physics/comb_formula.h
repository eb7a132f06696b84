// The closed form of Eqs. (4), (10) and (11) of the paper (corrected), arranged so that nothing cancels.
// For double and for Eigen's automatic differentiation; comb_capacitor.h is what others use.
//
// With h = b0/2, kappa = 24 alpha dT / a0, the gap over u = x - h is m - kappa u^2 with m = D - kappa h^2 in
// the middle; D1 = d0 - dd and D2 = d0, and f_1, f_3 of tangent_series.h:
//   I(D) = (2h/m) f_1(kappa h^2 / m)
//   N = [I(D1) - I(D2)] / dd = 2h / (s1 s2 (s1 + s2)) { f_1(z1) / s1 + f_1(V) / (s2 (1 - rho)) },
//       s = sqrt m,  z1 = kappa h^2 / m1,  rho = kappa h^2 / (s1 s2),  V = kappa v^2 / (1 - rho)^2,
//       v = h dd / (s1 s2 (s1 + s2))                           (addition theorem of the inverse tangent)
//   N(kappa) - N(0) = kappa { 2h / (s1 s2 (s1 + s2)) [ (h^2/m1) f_3(z1) / s1
//       + (h^2/(s1 s2) + f_3(V) v^2 / (1 - rho)^2) / (s2 (1 - rho)) ] + 2 h^3 (m1 + D2) / (m1 m2 D1 D2) }
//   dC' = P c0 (1 + b)^2 dd N,  dC = P c0 dd N(0),  b = 2 alpha dT,  P = n eps
//   dE  = P c0 dd { b (2 + b) N + [N(kappa) - N(0)] }
// All terms of a sum have the same sign, for any sign of dT and dd: dE keeps its digits however small dT and
// dd are.
//
// Lengths in um, temperatures in degrees Celsius, capacitances in fF. The caller has made sure that the combs
// do not touch: D1, D2 > 0 and D1, D2 > 2 kappa h^2.
#pragma once

#include "engine/physics/tangent_series.h"

#include <Eigen/Core>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

namespace driftbench {

inline constexpr double kVacuumPermittivityFfPerUm = 8.8541878188e-3; // CODATA 2022

template <class Derivatives>
Eigen::AutoDiffScalar<Derivatives> tangentSeries(int order, const Eigen::AutoDiffScalar<Derivatives> &z)
{
    return {tangentSeries(order, z.value()), tangentSeriesSlope(order, z.value()) * z.derivatives()};
}

template <class Scalar>
struct CombInputs
{
    Scalar expansionPerC;
    Scalar thicknessUm;
    Scalar overlapLengthUm;
    Scalar overlapWidthUm;
    Scalar gapUm;
    Scalar relativePermittivity;
    Scalar displacementUm;
    Scalar deltaTC;
    double gapCount;
};

template <class Scalar>
Scalar combScaleFf(const CombInputs<Scalar> &in) // P c0
{
    return in.gapCount * kVacuumPermittivityFfPerUm * in.relativePermittivity * in.overlapWidthUm;
}

// C'(dd); needs only D1 clear of contact.
template <class Scalar>
Scalar combCapacitanceFf(const CombInputs<Scalar> &in)
{
    const Scalar half = 0.5 * in.overlapLengthUm;
    const Scalar growth = 1.0 + 2.0 * in.expansionPerC * in.deltaTC;
    const Scalar bulge = 24.0 * in.expansionPerC * in.deltaTC / in.thicknessUm * half * half;
    const Scalar middle = in.gapUm - in.displacementUm - bulge;
    const Scalar z = bulge / middle;
    return combScaleFf(in) * growth * growth * 2.0 * half / middle * tangentSeries(1, z);
}

template <class Scalar>
class CombTerms
{
public:
    explicit CombTerms(const CombInputs<Scalar> &in)
        : m_in(in)
        , m_half(0.5 * in.overlapLengthUm)
        , m_curvature(24.0 * in.expansionPerC * in.deltaTC / in.thicknessUm)
        , m_displacedGap(in.gapUm - in.displacementUm)
        , m_growth(2.0 * in.expansionPerC * in.deltaTC)
    {
        using std::sqrt;
        const Scalar bulge = m_curvature * m_half * m_half;
        m_middle1 = m_displacedGap - bulge;
        m_middle2 = in.gapUm - bulge;
        const Scalar root1 = sqrt(m_middle1);
        const Scalar root2 = sqrt(m_middle2);
        const Scalar product = root1 * root2;
        const Scalar shared = product * (root1 + root2);
        const Scalar rest = 1.0 - bulge / product;
        const Scalar lag = m_half * in.displacementUm / (shared * rest);
        const Scalar z = bulge / m_middle1;
        const Scalar v = m_curvature * lag * lag;
        m_spread =
            2.0 * m_half / shared * (tangentSeries(1, z) / root1 + tangentSeries(1, v) / (root2 * rest));
        const Scalar first = m_half * m_half / m_middle1 * tangentSeries(3, z) / root1;
        const Scalar second = (m_half * m_half / product + lag * lag * tangentSeries(3, v)) / (root2 * rest);
        m_spreadSlope = 2.0 * m_half / shared * (first + second) + areaSlope();
    }

    Scalar changeFf() const
    {
        return scale() * (1.0 + m_growth) * (1.0 + m_growth) * m_in.displacementUm * m_spread;
    }
    Scalar restChangeFf() const
    {
        return scale() * m_in.displacementUm * m_in.overlapLengthUm / (m_in.gapUm * m_displacedGap);
    }
    Scalar errorFf() const
    {
        return scale() * m_in.displacementUm *
               (m_growth * (2.0 + m_growth) * m_spread + m_curvature * m_spreadSlope);
    }

private:
    Scalar scale() const { return combScaleFf(m_in); }
    Scalar areaSlope() const
    {
        return 2.0 * m_half * m_half * m_half * (m_middle1 + m_in.gapUm) /
               (m_middle1 * m_middle2 * m_displacedGap * m_in.gapUm);
    }

    CombInputs<Scalar> m_in;
    Scalar m_half;
    Scalar m_curvature;    // kappa
    Scalar m_displacedGap; // D1
    Scalar m_growth;       // b
    Scalar m_middle1;
    Scalar m_middle2;
    Scalar m_spread;      // N
    Scalar m_spreadSlope; // [N(kappa) - N(0)] / kappa
};

} // namespace driftbench
