// What the device's panel says of banks, tables and uploads.
#pragma once

#include "device/table_upload.h"
#include "engine/compensation/compensation_table.h"
#include "engine/exports/device_image.h"

#include <QString>

#include <cstdint>

namespace driftbench {

QString bankName(std::uint8_t bank); // "A", "B"
QString crcText(std::uint32_t crc);  // eight digits

// What was compared at work, where the device can stream its own samples beside the raw ones.
QString checkText(const TableUploadReport &report);

QString rangeText(const CompensationTable &table); // "-40.0 to 85.0 °C, 251 rows"
QString kindText(DeviceTableKind kind);
QString thermometerText(DeviceThermometer thermometer);

} // namespace driftbench
