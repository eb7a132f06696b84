// What of a result is written, and in which form.
#pragma once

#include "engine/base/result.h"
#include "engine/exports/device_image.h"
#include "engine/exports/export_model.h"

#include <string>
#include <vector>

namespace driftbench {

struct ExportChoice
{
    std::string model = "auto";
    ExportOptions options{};
    std::vector<ExportFormat> formats{ExportFormat::Csv, ExportFormat::Json, ExportFormat::C};
    DeviceTableKind deviceTable = DeviceTableKind::FixedPoint;
    DeviceThermometer deviceThermometer = DeviceThermometer::Die;
};

std::string exportChoiceToJson(const ExportChoice &choice);
// SessionDamaged.
Result<ExportChoice> exportChoiceFromJson(const std::string &json);

} // namespace driftbench
