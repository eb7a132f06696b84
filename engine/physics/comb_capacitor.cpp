#include "engine/physics/comb_capacitor.h"

#include "engine/base/text.h"
#include "engine/physics/comb_formula.h"
#include "engine/physics/temperature_profile.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace driftbench {

namespace {

constexpr double kNewtonMetresPerGPaCubicUm = 1e-9;
// Of the gap: closer than this the ends count as touching, as rounding can't tell them apart from contact.
constexpr double kContactFraction = 1e-12;

Status checkMaterial(const CombMaterial &material)
{
    if (!std::isfinite(material.expansionPerC))
        return invalidOption(
            "The thermal expansion coefficient is not a finite number; give it per °C, such as "
            "2.4e-6 of silicon.");
    if (!std::isfinite(material.elasticModulusGPa) || material.elasticModulusGPa <= 0.0)
        return invalidOption("The elastic modulus is " + shortest(material.elasticModulusGPa) +
                             " GPa; give more than 0.");
    if (!(material.poissonRatio >= -1.0 && material.poissonRatio <= 0.5))
        return invalidOption("The Poisson ratio is " + shortest(material.poissonRatio) +
                             "; give one from −1 to 0.5.");
    return {};
}

Status checkGeometry(const CombGeometry &geometry)
{
    struct Length
    {
        const char *what;
        double um;
    };
    const std::array lengths{Length{"comb thickness a0", geometry.thicknessUm},
                             Length{"overlap length b0", geometry.overlapLengthUm},
                             Length{"overlap width c0", geometry.overlapWidthUm},
                             Length{"gap d0", geometry.gapUm}};
    for (const Length &length : lengths) {
        if (!std::isfinite(length.um) || length.um <= 0.0)
            return invalidOption("The " + std::string(length.what) + " is " + shortest(length.um) +
                                 " µm; give more than 0.");
    }
    if (geometry.gapCount < 1)
        return invalidOption("The number of gaps is " + std::to_string(geometry.gapCount) +
                             "; give at least 1.");
    if (!std::isfinite(geometry.relativePermittivity) || geometry.relativePermittivity <= 0.0)
        return invalidOption("The relative permittivity is " + shortest(geometry.relativePermittivity) +
                             "; give more than 0.");
    return {};
}

Status checkTemperature(const std::string &what, double temperatureC)
{
    if (!std::isfinite(temperatureC) || temperatureC < kAbsoluteZeroC)
        return invalidOption(what + " is " + shortest(temperatureC) +
                             " °C; give a temperature above absolute zero (−273.15 °C).");
    return {};
}

CombInputs<double> inputsOf(const CombParameters &parameters, double deltaTC, double displacementUm)
{
    const CombGeometry &geometry = parameters.geometry;
    return {parameters.material.expansionPerC,
            geometry.thicknessUm,
            geometry.overlapLengthUm,
            geometry.overlapWidthUm,
            geometry.gapUm,
            geometry.relativePermittivity,
            displacementUm,
            deltaTC,
            static_cast<double>(geometry.gapCount)};
}

double curvaturePerUm(const CombParameters &parameters, double deltaTC) // K
{
    return 12.0 * parameters.material.expansionPerC * deltaTC / parameters.geometry.thicknessUm;
}

// The bracket of Eq. (10) as it is printed: one term of it, without the prefactor.
double printedTerm(double restGapUm, double kappaPerUm, double lengthUm)
{
    const double root = std::sqrt(restGapUm / kappaPerUm - lengthUm * lengthUm / 4.0);
    return std::log(std::abs((lengthUm / 2.0 + root) / (-lengthUm / 2.0 + root))) /
           std::sqrt(restGapUm - kappaPerUm * lengthUm * lengthUm / 4.0);
}

Result<double> printedChange(const CombParameters &parameters, double deltaTC, double displacementUm)
{
    const double expansion = parameters.material.expansionPerC * deltaTC;
    if (!(expansion > 0.0))
        return invalidOption(
            "Eq. (10) as printed has no value at a temperature difference of " + shortest(deltaTC) +
            " °C, where its root is zero or imaginary; use the corrected formula or a warmer "
            "temperature.");
    const CombGeometry &geometry = parameters.geometry;
    const double kappaPerUm = 24.0 * expansion / geometry.thicknessUm;
    const double growth = 1.0 + 2.0 * expansion;
    const double prefactor = geometry.gapCount * kVacuumPermittivityFfPerUm * geometry.relativePermittivity *
                             geometry.overlapLengthUm * geometry.overlapWidthUm * growth * growth /
                             (4.0 * std::sqrt(6.0 * expansion / geometry.thicknessUm));
    return prefactor * (printedTerm(geometry.gapUm - displacementUm, kappaPerUm, geometry.overlapLengthUm) -
                        printedTerm(geometry.gapUm, kappaPerUm, geometry.overlapLengthUm));
}

} // namespace

Result<CombCapacitor> CombCapacitor::create(const CombParameters &parameters)
{
    for (const Status &status :
         {checkMaterial(parameters.material), checkGeometry(parameters.geometry),
          checkTemperature("The temperature at which the combs are straight", parameters.straightAtC)}) {
        if (!status)
            return status.error();
    }
    return CombCapacitor(parameters);
}

double CombCapacitor::bendingMomentNm(double deltaTC) const
{
    const auto &[material, geometry, straightAtC] = m_parameters;
    return material.expansionPerC * material.elasticModulusGPa * geometry.overlapLengthUm *
           geometry.thicknessUm * geometry.thicknessUm * deltaTC / 8.0 * kNewtonMetresPerGPaCubicUm;
}

double CombCapacitor::thicknessUm(double deltaTC, double xUm) const
{
    return m_parameters.geometry.thicknessUm + curvaturePerUm(m_parameters, deltaTC) * xUm * xUm;
}

double CombCapacitor::gapUm(double deltaTC, double xUm) const
{
    const double b0 = m_parameters.geometry.overlapLengthUm;
    const double fromEnd = b0 - xUm;
    return m_parameters.geometry.gapUm -
           curvaturePerUm(m_parameters, deltaTC) * (xUm * xUm + fromEnd * fromEnd);
}

double CombCapacitor::overlapLengthUm(double deltaTC) const
{
    return m_parameters.geometry.overlapLengthUm *
           (1.0 + 2.0 * m_parameters.material.expansionPerC * deltaTC);
}

double CombCapacitor::overlapWidthUm(double deltaTC) const
{
    return m_parameters.geometry.overlapWidthUm * (1.0 + 2.0 * m_parameters.material.expansionPerC * deltaTC);
}

double CombCapacitor::contactTemperatureC(double displacementUm) const
{
    const auto &[material, geometry, straightAtC] = m_parameters;
    const double length = geometry.overlapLengthUm;
    return straightAtC + (geometry.gapUm - displacementUm) * geometry.thicknessUm /
                             (12.0 * material.expansionPerC * length * length);
}

Status CombCapacitor::check(double deltaTC, double displacementUm) const
{
    const auto &[material, geometry, straightAtC] = m_parameters;
    if (!std::isfinite(displacementUm) || displacementUm >= geometry.gapUm)
        return invalidOption("The displacement is " + shortest(displacementUm) +
                             " µm; give less than the gap of " + shortest(geometry.gapUm) +
                             " µm, at which the combs touch.");
    if (Status ok = checkTemperature("The temperature of the combs", straightAtC + deltaTC); !ok)
        return ok;
    const double gapUm = geometry.gapUm - displacementUm;
    const double length = geometry.overlapLengthUm;
    if (gapUm - curvaturePerUm(m_parameters, deltaTC) * length * length <= kContactFraction * gapUm)
        return invalidOption("The combs touch at " + shortest(contactTemperatureC(displacementUm)) +
                             " °C when displaced by " + shortest(displacementUm) +
                             " µm, so there is no capacitance at " + shortest(straightAtC + deltaTC) +
                             " °C; stay short of contact or give another geometry.");
    if (1.0 + 2.0 * material.expansionPerC * deltaTC <= 0.0)
        return invalidOption("The overlap of the combs has shrunk to nothing at " +
                             shortest(straightAtC + deltaTC) +
                             " °C; give a smaller thermal expansion coefficient.");
    return {};
}

Status CombCapacitor::checkChange(double deltaTC, double displacementUm) const
{
    if (Status ok = check(deltaTC, displacementUm); !ok)
        return ok;
    return check(deltaTC,
                 0.0); // a displacement that opens the gap is compared with the rest, which is closer
}

Result<double> CombCapacitor::capacitanceFf(double deltaTC, double displacementUm) const
{
    if (const Status ok = check(deltaTC, displacementUm); !ok)
        return ok.error();
    return combCapacitanceFf(inputsOf(m_parameters, deltaTC, displacementUm));
}

Result<double> CombCapacitor::restChangeFf(double displacementUm) const
{
    if (const Status ok = checkChange(0.0, displacementUm); !ok)
        return ok.error();
    return CombTerms(inputsOf(m_parameters, 0.0, displacementUm)).restChangeFf();
}

Result<double> CombCapacitor::changeFf(double deltaTC, double displacementUm, CombFormula formula) const
{
    if (const Status ok = checkChange(deltaTC, displacementUm); !ok)
        return ok.error();
    if (formula == CombFormula::AsPrinted)
        return printedChange(m_parameters, deltaTC, displacementUm);
    return CombTerms(inputsOf(m_parameters, deltaTC, displacementUm)).changeFf();
}

Result<double> CombCapacitor::errorFf(double deltaTC, double displacementUm, CombFormula formula) const
{
    if (const Status ok = checkChange(deltaTC, displacementUm); !ok)
        return ok.error();
    const CombTerms terms(inputsOf(m_parameters, deltaTC, displacementUm));
    if (formula == CombFormula::Corrected)
        return terms.errorFf();
    const Result<double> printed = printedChange(m_parameters, deltaTC, displacementUm);
    if (!printed)
        return printed.error();
    return *printed - terms.restChangeFf();
}

} // namespace driftbench
