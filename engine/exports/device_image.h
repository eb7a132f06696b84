// A compensation table as the bytes that a bank of the native gyro bridge holds (device_image_layout.h), and
// back. What the device does with them is in device_compensation.h.
//
// Fixed point holds the FixedPointTable of the table, float32 the knots rounded to float and the reciprocal
// of TableApply<float>. An image is for one sensor, by model and serial number, and for one thermometer.
//
// Errors: encode InvalidOption (sensor unknown or too long for the image, no axis, a value of 2^30 dps or
// more); decode ModelDamaged (cut, no image, fields that contradict each other), ModelTooNew.
#pragma once

#include "engine/base/result.h"
#include "engine/compensation/compensation_table.h"
#include "engine/compensation/fixed_point_table.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace driftbench {

enum class DeviceTableKind
{
    FixedPoint,
    Float,
};

enum class DeviceThermometer
{
    Die,
    External,
};

struct DeviceImage
{
    DeviceThermometer thermometer = DeviceThermometer::Die;
    // Knots, range, axes and sensor; what else its provenance says is not in an image. From fixed point the
    // knots are units times dpsPerUnit().
    CompensationTable table;
    std::optional<FixedPointTable> fixed; // unset: a float image. Its error bounds are not in an image.

    DeviceTableKind kind() const { return fixed ? DeviceTableKind::FixedPoint : DeviceTableKind::Float; }
};

Result<std::vector<std::uint8_t>> encodeDeviceImage(const CompensationTable &table, DeviceTableKind kind,
                                                    DeviceThermometer thermometer);

// name: where the bytes come from, for messages.
Result<DeviceImage> decodeDeviceImage(std::span<const std::uint8_t> bytes, const std::string &name);

// CRC-32 of an image, as begin announces it and a bank's status repeats it.
std::uint32_t deviceImageCrc(std::span<const std::uint8_t> bytes);

} // namespace driftbench
