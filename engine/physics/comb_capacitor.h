// The sensing combs of a capacitive gyro under thermal stress (Eqs. 1-12 of the paper, corrected as
// docs/method.md says), from a temperature difference and a displacement to a capacitance error.
//
// With dT = T - T0, T0 the temperature at which the combs are straight, and K = 12 alpha dT / a0:
//   bending moment     M  = alpha E b0 a0^2 dT / 8                                             (Eq. 7)
//   thickness          a1(x) = a0 + K x^2                                                      (Eq. 8)
//   gap                d1(x) = d0 - K (2 x^2 - 2 b0 x + b0^2),  0 <= x <= b0                   (Eq. 9)
//   overlap            b1 = b0 (1 + 2 alpha dT),  c1 = c0 (1 + 2 alpha dT)                     (Eqs. 5, 6)
//   capacitance        C'(dd) = n eps/(4 pi k) (b1 c1 / b0) I(d0 - dd),
//                      I(D) = integral of dx / (d1(x) - d0 + D) over 0 ... b0
//   change by rotation dC' = C'(dd) - C'(0);  dC = the same at dT = 0                          (Eqs. 4, 10)
//   error              dE = dC' - dC                                                           (Eq. 11)
// Closed form of I with kappa = 2 K and D the rest gap:
//   dT > 0   ln[(s + b0/2) / (s - b0/2)] / sqrt(kappa (D - kappa b0^2/4)),  s = sqrt(D/kappa - b0^2/4)
//   dT < 0   2 / (|kappa| r) atan(b0 / (2 r)),  r = sqrt(D/|kappa| + b0^2/4)
//   dT = 0   b0 / D
// which are one analytic function of dT. The combs touch when D <= kappa b0^2 / 2, first at their ends.
// How the differences keep their digits is said in comb_formula.h.
//
// eps/(4 pi k) is the permittivity of the gap (k the electrostatic constant of Coulomb's law), 8.854 aF/um in
// vacuum or air. Lengths in micrometres, capacitances in femtofarads, temperatures in degrees Celsius.
#pragma once

#include "engine/base/result.h"

#include <array>
#include <string_view>

namespace driftbench {

struct CombMaterial // silicon as in section 2.1.2 of the paper
{
    double expansionPerC = 2.4e-6; // alpha
    double elasticModulusGPa = 175.0;
    double poissonRatio = 0.28;
};

struct CombGeometry
{
    double thicknessUm = 4.0;     // a0
    double overlapLengthUm = 8.0; // b0
    double overlapWidthUm = 30.0; // c0
    double gapUm = 2.0;           // d0
    int gapCount = 100;           // n
    double relativePermittivity = 1.0;
};

struct CombParameters
{
    CombMaterial material{};
    CombGeometry geometry{};
    double straightAtC = 25.0; // T0
};

// Corrected: the formulas above. AsPrinted: the last line of the paper's Eq. (10) to the letter, which has
// half of the right prefactor and one length too many: dC' in fF um, b0 / 2 times the right figure. It exists
// only for alpha dT > 0. For showing the factor, never for use.
enum class CombFormula
{
    Corrected,
    AsPrinted
};

class CombCapacitor
{
public:
    // Errc::InvalidOption for a length, permittivity or modulus that is not positive, a Poisson ratio outside
    // -1 ... 0.5, no gaps, or a temperature below absolute zero.
    static Result<CombCapacitor> create(const CombParameters &parameters);

    const CombParameters &parameters() const { return m_parameters; }

    double bendingMomentNm(double deltaTC) const;
    double thicknessUm(double deltaTC, double xUm) const;
    double gapUm(double deltaTC, double xUm) const;
    double overlapLengthUm(double deltaTC) const;
    double overlapWidthUm(double deltaTC) const;

    // The temperature at which the combs touch while displaced; above it nothing below is defined. Infinite
    // without expansion; with a negative coefficient the combs touch below it.
    double contactTemperatureC(double displacementUm) const;

    // C'(dd) at one temperature. Errc::InvalidOption that names the temperature of contact where the combs
    // touch, or absolute zero where T is below it.
    Result<double> capacitanceFf(double deltaTC, double displacementUm) const;
    // dC at T0, dC' and dE at T0 + dT. The same errors, also where the combs at rest touch; AsPrinted where
    // it has no value.
    Result<double> restChangeFf(double displacementUm) const;
    Result<double> changeFf(double deltaTC, double displacementUm,
                            CombFormula formula = CombFormula::Corrected) const;
    Result<double> errorFf(double deltaTC, double displacementUm,
                           CombFormula formula = CombFormula::Corrected) const;

private:
    explicit CombCapacitor(const CombParameters &parameters) : m_parameters(parameters) {}

    Status check(double deltaTC, double displacementUm) const;       // one state of the combs
    Status checkChange(double deltaTC, double displacementUm) const; // and the rest it is compared with

    CombParameters m_parameters;
};

} // namespace driftbench
