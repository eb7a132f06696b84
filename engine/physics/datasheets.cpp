#include "engine/physics/datasheets.h"

#include "engine/base/text.h"
#include "engine/physics/temperature_profile.h"

#include <cmath>
#include <span>

namespace driftbench {

namespace {

Error unknown(std::string_view kind, std::string_view name, std::span<const std::string_view> names)
{
    std::string known;
    for (const std::string_view each : names)
        known += (known.empty() ? "" : ", ") + std::string(each);
    return invalidOption("There is no datasheet of a " + std::string(kind) + " \"" + std::string(name) +
                         "\"; choose one of " + known + ".");
}

struct Figure
{
    std::string_view what;
    double value;
    std::string_view unit;
};

Status checkPositive(std::span<const Figure> figures, const std::string &model)
{
    for (const Figure &figure : figures) {
        if (!std::isfinite(figure.value) || figure.value <= 0.0)
            return invalidOption("The " + std::string(figure.what) + " of " + model + " is " +
                                 shortest(figure.value) + std::string(figure.unit) + "; give more than 0.");
    }
    return {};
}

} // namespace

Result<SensorDatasheet> namedSensor(std::string_view model)
{
    if (lowered(model) == "i3g4250d")
        return SensorDatasheet{"I3G4250D", 8.75, 245.0, 30.0, 245.0, 2.0, 0.03, -40.0, 85.0};
    if (lowered(model) == "l3gd20h")
        return SensorDatasheet{"L3GD20H", 8.75, 245.0, 40.0, 2000.0, 2.0, 0.011, -40.0, 85.0};
    return unknown("gyro", model, kSensorNames);
}

Result<ChamberDatasheet> namedChamber(std::string_view model)
{
    if (lowered(model) == "set-z-021")
        return ChamberDatasheet{"SET-Z-021", 0.6, 1005.0, 1.293, 0.0267, 0.03};
    return unknown("chamber", model, kChamberNames);
}

Status checkDatasheet(const SensorDatasheet &sensor)
{
    const std::array figures{
        Figure{"sensitivity", sensor.sensitivityMdps, " mdps"},
        Figure{"range", sensor.rangeDps, " dps"},
        Figure{"zero-rate level change", sensor.zeroRateChangeMdpsPerC, " mdps/°C"},
        Figure{"full scale of the zero-rate level change", sensor.zeroRateChangeRangeDps, " dps"},
        Figure{"sensitivity change", sensor.sensitivityChangePercent, " %"},
        Figure{"noise density", sensor.noiseDensityDpsPerRootHz, " dps/√Hz"},
    };
    if (const Status ok = checkPositive(figures, sensor.model); !ok)
        return ok;
    for (const double temperatureC : {sensor.lowestC, sensor.highestC}) {
        if (!std::isfinite(temperatureC) || temperatureC < kAbsoluteZeroC)
            return invalidOption("The operating range of " + sensor.model + " has an end at " +
                                 shortest(temperatureC) +
                                 " °C; give a temperature above absolute zero (−273.15 °C).");
    }
    if (sensor.lowestC >= sensor.highestC)
        return invalidOption("The operating range of " + sensor.model + " goes from " +
                             shortest(sensor.lowestC) + " to " + shortest(sensor.highestC) +
                             " °C; the lower end must come first.");
    return {};
}

Status checkDatasheet(const ChamberDatasheet &chamber)
{
    const std::array figures{
        Figure{"inner edge", chamber.edgeM, " m"},
        Figure{"specific heat of the air", chamber.specificHeatJPerKgK, " J/(kg K)"},
        Figure{"density of the air", chamber.densityKgPerM3, " kg/m³"},
        Figure{"heat conductivity of the air", chamber.conductivityWPerMK, " W/(m K)"},
        Figure{"accuracy of the thermometer", chamber.thermometerAccuracyC, " °C"},
    };
    return checkPositive(figures, chamber.model);
}

} // namespace driftbench
