#include "engine/physics/control_figures.h"

#include "engine/base/text.h"
#include "engine/physics/temperature_profile.h"

#include <cmath>

namespace driftbench {

namespace {

constexpr double kPaperPeriodS = 30.0;
constexpr double kPeriodGrainS = 10.0;
constexpr double kJoulePerKilojoule = 1000.0;
// A figure that is a round one but for rounding errors must not be moved to the next.
constexpr double kRoundingSlack = 1e-9;

// 1, 2 or 5 times a power of ten, at most value.
double roundedDown(double value)
{
    const double decade = std::pow(10.0, std::floor(std::log10(value) + kRoundingSlack));
    const double mantissa = value / decade * (1.0 + kRoundingSlack);
    return (mantissa >= 5.0 ? 5.0 : mantissa >= 2.0 ? 2.0 : 1.0) * decade;
}

// 0.02 × 8.75 × 62.5 is not quite 10.9375 in binary.
std::string number(double value)
{
    constexpr double kPartsPerUnit = 1e9;
    return shortest(std::round(value * kPartsPerUnit) / kPartsPerUnit);
}

// (85 - -40) reads badly.
std::string inBrackets(double value)
{
    return value < 0.0 ? "(−" + number(-value) + ")" : number(value);
}

std::string conductionEquation(const ChamberDatasheet &chamber, double specificHeat, double lowest,
                               double highest)
{
    return "C ρ L² (Tb − T0)/(k_h Tb) = " + number(specificHeat) + " × " + number(chamber.densityKgPerM3) +
           " × " + number(chamber.edgeM) + "² × (" + number(highest) + " − " + inBrackets(lowest) + ")/(" +
           number(chamber.conductivityWPerMK) + " × " + inBrackets(highest) + ")";
}

} // namespace

Status checkTemperatureRange(double lowestC, double highestC)
{
    for (const double temperatureC : {lowestC, highestC}) {
        if (!std::isfinite(temperatureC) || temperatureC <= kAbsoluteZeroC)
            return Error{Errc::InvalidOption,
                         "The plan goes to " + shortest(temperatureC) +
                             " °C; give a temperature above absolute zero (−273.15 °C)."};
    }
    if (lowestC >= highestC)
        return Error{Errc::InvalidOption, "The plan goes from " + shortest(lowestC) + " to " +
                                              shortest(highestC) +
                                              " °C; the lowest temperature must be below the highest."};
    return {};
}

Result<ControlInterval> controlInterval(const SensorDatasheet &sensor, double lowestC, double highestC)
{
    if (const Status ok = checkDatasheet(sensor); !ok)
        return ok.error();
    if (const Status ok = checkTemperatureRange(lowestC, highestC); !ok)
        return ok.error();
    const double spanC = highestC - lowestC;
    const double countShare = sensor.sensitivityChangePercent / 100.0 * sensor.sensitivityMdps;
    ControlInterval interval;
    interval.zeroRateMdpsPerC =
        sensor.zeroRateChangeMdpsPerC * sensor.rangeDps / sensor.zeroRateChangeRangeDps;
    interval.sensitivityMdpsPerC = countShare * spanC / 2.0;
    interval.printedSensitivityMdpsPerC = countShare * spanC * spanC;
    interval.longestC = sensor.sensitivityMdps / (interval.zeroRateMdpsPerC + interval.sensitivityMdpsPerC);
    interval.printedLongestC =
        sensor.sensitivityMdps / (interval.zeroRateMdpsPerC + interval.printedSensitivityMdpsPerC);
    interval.recommendedC = roundedDown(interval.longestC);
    return interval;
}

Result<ControlPeriod> controlPeriod(const ChamberDatasheet &chamber, double lowestC, double highestC)
{
    if (const Status ok = checkDatasheet(chamber); !ok)
        return ok.error();
    if (const Status ok = checkTemperatureRange(lowestC, highestC); !ok)
        return ok.error();
    const double diffusionS = chamber.specificHeatJPerKgK * chamber.densityKgPerM3 * chamber.edgeM *
                              chamber.edgeM / chamber.conductivityWPerMK;
    const double spanC = highestC - lowestC;
    ControlPeriod period;
    if (highestC > 0.0) {
        period.celsiusS = diffusionS * spanC / highestC;
        period.printedS = *period.celsiusS / kJoulePerKilojoule;
    }
    period.kelvinS = diffusionS * spanC / (highestC - kAbsoluteZeroC);
    period.recommendedS = period.printedS
                              ? std::ceil(*period.printedS / kPeriodGrainS - kRoundingSlack) * kPeriodGrainS
                              : kPaperPeriodS;
    return period;
}

std::vector<PlanFigure> intervalFigures(const ControlInterval &interval, const SensorDatasheet &sensor,
                                        double lowestC, double highestC)
{
    const std::string percent = number(sensor.sensitivityChangePercent) + " %";
    const std::string count = number(sensor.sensitivityMdps);
    const std::string span = number(highestC - lowestC);
    const auto equation = [&](double sensitivityTerm) {
        return "ΔE_S/(γ′ + β) = " + count + "/(" + number(interval.zeroRateMdpsPerC) + " + " +
               number(sensitivityTerm) + ")";
    };
    return {
        {"ΔE_S", "sensitivity", sensor.sensitivityMdps, "mdps",
         "One count of " + sensor.model + " at ±" + number(sensor.rangeDps) + " dps, from its datasheet."},
        {"γ′",
         number(sensor.zeroRateChangeMdpsPerC) + " × " + number(sensor.rangeDps) + "/" +
             number(sensor.zeroRateChangeRangeDps),
         interval.zeroRateMdpsPerC, "mdps/°C",
         "Zero-rate change with temperature, brought from the full scale at which the datasheet states it to "
         "the one in use (Eq. 27)."},
        {"β, printed", percent + " × " + count + " × " + span + "²", interval.printedSensitivityMdpsPerC,
         "mdps/°C", "Eq. 26 prints the span squared; the paper itself does not go on with this figure."},
        {"β, used", percent + " × " + count + " × " + span + "/2", interval.sensitivityMdpsPerC, "mdps/°C",
         "Half the span gives the value that Eqs. 26 and 27 state and use."},
        {"ΔT, printed β", equation(interval.printedSensitivityMdpsPerC), interval.printedLongestC, "°C",
         "What Eq. 14 would give with the β of Eq. 26 as it is printed."},
        {"ΔT, longest", equation(interval.sensitivityMdpsPerC), interval.longestC, "°C",
         "The step at which the estimated error reaches one count (Eqs. 14, 27)."},
        {"ΔT, recommended", "rounded down to 1, 2 or 5 × 10ⁿ", interval.recommendedC, "°C",
         "A step that is easy to set and no longer than the longest."},
    };
}

std::vector<PlanFigure> periodFigures(const ControlPeriod &period, const ChamberDatasheet &chamber,
                                      double lowestC, double highestC)
{
    const std::string none = "There is no such figure because Tb is not above 0 °C.";
    const double heatJ = chamber.specificHeatJPerKgK;
    const double lowestK = lowestC - kAbsoluteZeroC;
    const double highestK = highestC - kAbsoluteZeroC;
    return {
        {"t_s, printed", conductionEquation(chamber, heatJ / kJoulePerKilojoule, lowestC, highestC),
         period.printedS, "s",
         period.printedS ? "Eq. 28 puts C in kJ/(kg K) beside k_h in W/(m K), which makes the figure a "
                           "thousand times too small, and takes Tb in °C."
                         : none},
        {"t_s, SI, Tb in °C", conductionEquation(chamber, heatJ, lowestC, highestC), period.celsiusS, "s",
         period.celsiusS ? "C in J/(kg K), so that the units cancel; Tb in °C still makes the figure depend "
                           "on where the scale has its zero."
                         : none},
        {"t_s, SI, Tb in K", conductionEquation(chamber, heatJ, lowestK, highestK), period.kelvinS, "s",
         "C in J/(kg K) and Tb in kelvin: Eq. 25 as it stands, in consistent units."},
        {"t_p, recommended", period.printedS ? "printed t_s rounded up to 10 s" : "as in the paper",
         period.recommendedS, "s",
         "The period of the paper's experiment; still air does not follow it (see the chamber below), a fan "
         "must."},
    };
}

} // namespace driftbench
