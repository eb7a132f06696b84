// What a native gyro bridge with a table does to its samples, bit for bit (device/firmware/bridge_counts.h).
//
// The table is looked up once a report, at the temperature t in whole millidegrees that the report carries,
// and c counts are taken off every sample of the report. One count is s x 10 udps (s: sensitivity):
//   fixed   units = tdeUnits(t) of 2^-F dps, m = floor(100000 2^r / s) with the smallest r that gives
//           m >= 2^30, c = floor(units m / 2^(r + F) + 1/2)
//   float   c = tde (100000 / s) with T = (float)t / 1000, all in float32; clamped to +-65536, 0.5 added
//           away from zero, cut off
//   both    c clamped to +-65536; compensated = raw - c, clamped to int16
#pragma once

#include "engine/compensation/table_apply.h"
#include "engine/exports/device_image.h"

#include <array>
#include <cstdint>

namespace driftbench {

class DeviceCompensation
{
public:
    // sensitivity: 1 .. 65535, in 10 udps a count, as the device's info states it for the range in use.
    DeviceCompensation(const DeviceImage &image, std::uint16_t sensitivity);

    std::array<std::int32_t, 3> tdeCounts(std::int32_t temperatureMilliC) const;

    static std::int16_t compensated(std::int16_t rawCounts, std::int32_t tdeCounts);

private:
    std::optional<FixedPointTable> m_fixed;
    std::optional<TableApply<float>> m_float; // where there is no fixed-point table
    std::uint16_t m_sensitivity;
};

} // namespace driftbench
