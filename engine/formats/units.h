// The units that logs come in, and the way from them to s, degrees Celsius and dps.
#pragma once

#include <optional>
#include <string_view>

namespace driftbench {

enum class TimeUnit
{
    Seconds,
    Milliseconds,
    Microseconds,
    Nanoseconds
};

enum class RateUnit
{
    DegreesPerSecond,
    RadiansPerSecond,
    MillidegreesPerSecond,
    Counts // of the sensor's registers; needs a sensitivity
};

enum class TemperatureUnit
{
    Celsius,
    Kelvin,
    Fahrenheit
};

// result = (value * factor) / divisor + offset. A divisor of its own because 1e6 is a double and 1e-6 is not.
struct UnitScale
{
    double factor = 1.0;
    double divisor = 1.0;
    double offset = 0.0;

    bool isIdentity() const { return factor == 1.0 && divisor == 1.0 && offset == 0.0; }
    double operator()(double value) const { return value * factor / divisor + offset; }
};

UnitScale toSeconds(TimeUnit unit);
UnitScale toDps(RateUnit unit, double sensitivityMdpsPerCount);
UnitScale toCelsius(TemperatureUnit unit);

std::string_view unitName(TimeUnit unit); // "us"
std::string_view unitName(RateUnit unit); // "rad/s"
std::string_view unitName(TemperatureUnit unit);

// As the command line and headers spell them: "ms", "rad/s", "K"; nothing if it is no such unit.
std::optional<TimeUnit> timeUnitNamed(std::string_view name);
std::optional<RateUnit> rateUnitNamed(std::string_view name);
std::optional<TemperatureUnit> temperatureUnitNamed(std::string_view name);

} // namespace driftbench
