// What the device's panel says of banks, tables and uploads.
#pragma once

#include "device/table_upload.h"
#include "engine/compensation/compensation_table.h"
#include "engine/exports/device_image.h"
#include "engine/recording/recording.h"

#include <QString>

#include <cstdint>
#include <string_view>

namespace driftbench {

struct TrainedModel;

QString bankName(std::uint8_t bank); // "A", "B"
QString crcText(std::uint32_t crc);  // eight digits

// What was compared at work, where the device can stream its own samples beside the raw ones.
QString checkText(const TableUploadReport &report);

// "recommended" for the choice of each axis's best; model: what adds its centres, may be null.
QString deviceModelName(std::string_view name, const TrainedModel *model = nullptr);
QString sensorText(const SensorIdentity &sensor);  // its serial, where it is known
QString rangeText(const CompensationTable &table); // "−40 to 85 °C, 251"
QString kindText(DeviceTableKind kind);
QString thermometerText(DeviceThermometer thermometer);

} // namespace driftbench
