// How far and how fast a chamber may step, from the datasheets of gyro and chamber (Eqs. 13-14, 25-28):
// every figure with its equation as text, as the paper prints it and in the units it should have, so that
// they can be shown side by side.
//
//   interval  dT <= dE_S / (gamma' + beta)                                                          (Eq. 14)
//             dE_S    sensitivity, mdps
//             gamma'  zero-rate change x range / full scale at which it is stated, mdps/C           (Eq. 27)
//             beta    sensitivity change x sensitivity x (highest - lowest) / 2, mdps/C             (Eq. 26)
//             Eq. 26 prints the span squared, which is not what the paper goes on with.
//   period    t_s = C rho L^2 (Tb - T0) / (k_h Tb)                                              (Eqs. 25, 28)
//             Tb the highest, T0 the lowest temperature. The printed figure takes C in kJ and Tb in C.
//
// Temperatures in degrees Celsius, rates in mdps, times in seconds.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/datasheets.h"

#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct PlanFigure
{
    std::string name;
    std::string equation;        // with the numbers put in
    std::optional<double> value; // nothing where the equation has none
    std::string unit;
    std::string remark; // one sentence: where the figure comes from, what is wrong with it
};

struct ControlInterval
{
    double zeroRateMdpsPerC = 0.0;           // gamma'
    double sensitivityMdpsPerC = 0.0;        // beta
    double printedSensitivityMdpsPerC = 0.0; // beta of Eq. 26 as printed
    double longestC = 0.0;                   // dE_S / (gamma' + beta)
    double printedLongestC = 0.0;            // the same with the printed beta
    double recommendedC = 0.0;               // longestC rounded down to 1, 2 or 5 times a power of ten
};

struct ControlPeriod
{
    std::optional<double> printedS; // C in kJ, Tb in C; nothing where Tb is not above 0 C
    std::optional<double> celsiusS; // SI units but Tb in C
    double kelvinS = 0.0;           // SI units, Tb in kelvin
    double recommendedS = 0.0;      // printedS rounded up to a whole multiple of 10 s; else the paper's 30 s
};

// Over lowestC ... highestC, which is also the span of beta. Errc::InvalidOption as checkDatasheet says, for
// an empty range, or for a temperature that is not above absolute zero.
Result<ControlInterval> controlInterval(const SensorDatasheet &sensor, double lowestC, double highestC);
Result<ControlPeriod> controlPeriod(const ChamberDatasheet &chamber, double lowestC, double highestC);

// The same figures and their terms with equations and remarks, in the order in which they are derived. The
// datasheets and temperatures are those that the figures were made from.
std::vector<PlanFigure> intervalFigures(const ControlInterval &interval, const SensorDatasheet &sensor,
                                        double lowestC, double highestC);
std::vector<PlanFigure> periodFigures(const ControlPeriod &period, const ChamberDatasheet &chamber,
                                      double lowestC, double highestC);

// Errc::InvalidOption unless -273.15 C < lowestC < highestC.
Status checkTemperatureRange(double lowestC, double highestC);

} // namespace driftbench
