#include "engine/formats/units.h"

#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <array>
#include <string>
#include <utility>

namespace driftbench {

namespace {

template <class Unit>
using Spelling = std::pair<std::string_view, Unit>;

// Signs such as the degree sign, the slash and the micro sign are gone when a name is looked up here.
constexpr std::array kTimeSpellings{
    Spelling<TimeUnit>{"s", TimeUnit::Seconds},
    Spelling<TimeUnit>{"sec", TimeUnit::Seconds},
    Spelling<TimeUnit>{"secs", TimeUnit::Seconds},
    Spelling<TimeUnit>{"second", TimeUnit::Seconds},
    Spelling<TimeUnit>{"seconds", TimeUnit::Seconds},
    Spelling<TimeUnit>{"ms", TimeUnit::Milliseconds},
    Spelling<TimeUnit>{"msec", TimeUnit::Milliseconds},
    Spelling<TimeUnit>{"millis", TimeUnit::Milliseconds},
    Spelling<TimeUnit>{"milliseconds", TimeUnit::Milliseconds},
    Spelling<TimeUnit>{"us", TimeUnit::Microseconds},
    Spelling<TimeUnit>{"usec", TimeUnit::Microseconds},
    Spelling<TimeUnit>{"micros", TimeUnit::Microseconds},
    Spelling<TimeUnit>{"microseconds", TimeUnit::Microseconds},
    Spelling<TimeUnit>{"ns", TimeUnit::Nanoseconds},
    Spelling<TimeUnit>{"nsec", TimeUnit::Nanoseconds},
    Spelling<TimeUnit>{"nanos", TimeUnit::Nanoseconds},
    Spelling<TimeUnit>{"nanoseconds", TimeUnit::Nanoseconds},
};

constexpr std::array kRateSpellings{
    Spelling<RateUnit>{"dps", RateUnit::DegreesPerSecond},
    Spelling<RateUnit>{"degps", RateUnit::DegreesPerSecond},
    Spelling<RateUnit>{"degs", RateUnit::DegreesPerSecond},
    Spelling<RateUnit>{"degsec", RateUnit::DegreesPerSecond},
    Spelling<RateUnit>{"rads", RateUnit::RadiansPerSecond},
    Spelling<RateUnit>{"radsec", RateUnit::RadiansPerSecond},
    Spelling<RateUnit>{"radps", RateUnit::RadiansPerSecond},
    Spelling<RateUnit>{"rad", RateUnit::RadiansPerSecond},
    Spelling<RateUnit>{"mdps", RateUnit::MillidegreesPerSecond},
    Spelling<RateUnit>{"mdegs", RateUnit::MillidegreesPerSecond},
    Spelling<RateUnit>{"mdegps", RateUnit::MillidegreesPerSecond},
    Spelling<RateUnit>{"counts", RateUnit::Counts},
    Spelling<RateUnit>{"count", RateUnit::Counts},
    Spelling<RateUnit>{"lsb", RateUnit::Counts},
    Spelling<RateUnit>{"raw", RateUnit::Counts},
};

constexpr std::array kTemperatureSpellings{
    Spelling<TemperatureUnit>{"c", TemperatureUnit::Celsius},
    Spelling<TemperatureUnit>{"degc", TemperatureUnit::Celsius},
    Spelling<TemperatureUnit>{"celsius", TemperatureUnit::Celsius},
    Spelling<TemperatureUnit>{"k", TemperatureUnit::Kelvin},
    Spelling<TemperatureUnit>{"degk", TemperatureUnit::Kelvin},
    Spelling<TemperatureUnit>{"kelvin", TemperatureUnit::Kelvin},
    Spelling<TemperatureUnit>{"f", TemperatureUnit::Fahrenheit},
    Spelling<TemperatureUnit>{"degf", TemperatureUnit::Fahrenheit},
    Spelling<TemperatureUnit>{"fahrenheit", TemperatureUnit::Fahrenheit},
};

// "°/s" -> "degs", "µs" (both code points) -> "us", "rad/s" -> "rads".
std::string plain(std::string_view name)
{
    std::string letters;
    const std::string low = lowered(name);
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::string_view two = std::string_view(low).substr(i, 2);
        if (two == "\u00b0")
            letters += "deg";
        else if (two == "\u00b5" || two == "\u03bc")
            letters += 'u';
        else if ((low[i] >= 'a' && low[i] <= 'z') || (low[i] >= '0' && low[i] <= '9'))
            letters += low[i];
    }
    return letters;
}

template <class Unit, std::size_t N>
std::optional<Unit> lookUp(const std::array<Spelling<Unit>, N> &spellings, std::string_view name)
{
    const std::string wanted = plain(name);
    for (const auto &[spelling, unit] : spellings) {
        if (spelling == wanted)
            return unit;
    }
    return std::nullopt;
}

} // namespace

UnitScale toSeconds(TimeUnit unit)
{
    switch (unit) {
    case TimeUnit::Seconds:
        return {};
    case TimeUnit::Milliseconds:
        return {.divisor = 1e3};
    case TimeUnit::Microseconds:
        return {.divisor = 1e6};
    case TimeUnit::Nanoseconds:
        return {.divisor = 1e9};
    }
    return {};
}

UnitScale toDps(RateUnit unit, double sensitivityMdpsPerCount)
{
    switch (unit) {
    case RateUnit::DegreesPerSecond:
        return {};
    case RateUnit::RadiansPerSecond:
        return {.factor = kDegreesPerRadian};
    case RateUnit::MillidegreesPerSecond:
        return {.divisor = 1e3};
    case RateUnit::Counts:
        return {.factor = sensitivityMdpsPerCount, .divisor = 1e3};
    }
    return {};
}

UnitScale toCelsius(TemperatureUnit unit)
{
    switch (unit) {
    case TemperatureUnit::Celsius:
        return {};
    case TemperatureUnit::Kelvin:
        return {.offset = -273.15};
    case TemperatureUnit::Fahrenheit:
        return {.factor = 5.0, .divisor = 9.0, .offset = -160.0 / 9.0};
    }
    return {};
}

std::string_view unitName(TimeUnit unit)
{
    constexpr std::array<std::string_view, 4> kNames{"s", "ms", "us", "ns"};
    return kNames[static_cast<std::size_t>(unit)];
}

std::string_view unitName(RateUnit unit)
{
    constexpr std::array<std::string_view, 4> kNames{"dps", "rad/s", "mdps", "counts"};
    return kNames[static_cast<std::size_t>(unit)];
}

std::string_view unitName(TemperatureUnit unit)
{
    constexpr std::array<std::string_view, 3> kNames{"C", "K", "F"};
    return kNames[static_cast<std::size_t>(unit)];
}

std::optional<TimeUnit> timeUnitNamed(std::string_view name)
{
    return lookUp(kTimeSpellings, name);
}

std::optional<RateUnit> rateUnitNamed(std::string_view name)
{
    return lookUp(kRateSpellings, name);
}

std::optional<TemperatureUnit> temperatureUnitNamed(std::string_view name)
{
    return lookUp(kTemperatureSpellings, name);
}

} // namespace driftbench
