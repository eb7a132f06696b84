// What the name of a column says: "imu.gyro.x", "GyrX", "x rate (dps)", "timestamp_us", "temperature [degC]".
//
// A name is cut into the words of a small vocabulary ("gyrx" is gyr + x, "timeus" is time + us); what it
// means follows from the words alone, in any order and with any signs between them.
#pragma once

#include "engine/formats/read_options.h"

#include <optional>
#include <string_view>

namespace driftbench {

struct ColumnSpelling
{
    bool time = false;
    bool stamp = false; // of the time words, "timestamp": often counted by a machine
    bool temperature = false;
    bool gyro = false;
    bool otherQuantity = false; // acceleration, magnetic field, a result of ours, ...
    bool onlyOneLetter = false;
    bool upperCase = false;
    int axis = -1;
    int unknownWords = 0;
    std::optional<TimeUnit> timeUnit;
    std::optional<RateUnit> rateUnit;
    std::optional<TemperatureUnit> temperatureUnit;

    // How well the name fits the quantity: 0 not at all, 10 perfectly.
    int fit(CsvQuantity quantity) const;
};

ColumnSpelling readSpelling(std::string_view name);

} // namespace driftbench
