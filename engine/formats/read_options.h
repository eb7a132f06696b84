// What a user may state about a log beyond what the log says itself.
#pragma once

#include "engine/formats/units.h"

#include <array>
#include <optional>
#include <string>

namespace driftbench {

enum class CsvQuantity
{
    Time,
    Temperature,
    RateX,
    RateY,
    RateZ
};

inline constexpr std::size_t kCsvQuantityCount = 5;

struct CsvOptions
{
    // Per CsvQuantity: the header's name for the column, or its number counted from 1. Empty: by spelling.
    std::array<std::string, kCsvQuantityCount> columns;
    std::optional<char> separator; // ',', ';' or '\t'; nothing: from the first line
    // What is not stated here is taken from the header, and where that is silent too: s, dps, degrees
    // Celsius.
    std::optional<TimeUnit> timeUnit;
    std::optional<RateUnit> rateUnit;
    std::optional<TemperatureUnit> temperatureUnit;
    std::optional<double> sensitivityMdpsPerCount; // for rates in counts

    std::string &column(CsvQuantity quantity) { return columns[static_cast<std::size_t>(quantity)]; }
};

struct ReadOptions
{
    std::optional<int> instance; // of the log's sensors; nothing: the only one there is
    CsvOptions csv;
};

} // namespace driftbench
