// What would be written, in every form, made at once off the window's thread: the table with its errors, each
// file's text with what it loses, the image for the device.
#pragma once

#include "app/session/export_choice.h"
#include "engine/base/progress.h"
#include "engine/exports/cubic_refit.h"
#include "widgets/tables/knots_table_model.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct FilePreview
{
    ExportFormat format = ExportFormat::Csv;
    std::optional<Error> refusal;
    Exported exported; // empty where it is refused
};

struct ExportPreview
{
    std::string model;
    std::array<bool, 3> compensated{};
    std::optional<Error> refusal;                // of the axes, or of the table: then there is nothing else
    std::vector<std::string> notes;              // axes left out or forced
    std::shared_ptr<const KnotsTableData> table; // null where it is refused
    CubicRefit cubic;                            // what the autopilots would get
    std::vector<FilePreview> files;              // in the order of ExportFormat
    std::optional<Error> imageRefusal;
    std::vector<std::uint8_t> image;

    const FilePreview *file(ExportFormat format) const; // null: there is none
};

ExportPreview makeExportPreview(const TrainedModel &model, const ExportChoice &choice);

// Of a file in a folder: "L3GD20H_SIM-0001_rbf.csv", with letters that every file system takes.
std::string exportFileName(const TrainedModel &model, ExportFormat format);
std::string imageFileName(const TrainedModel &model);

} // namespace driftbench
