// A trained model in the form in which it is used elsewhere, one text file per format:
//   csv        the compensation table, with `#` lines that say where it comes from     (table_csv.h)
//   json       the table in floating and fixed point, with its provenance              (table_json.h)
//   c          a self-contained C99 header with evaluation functions, MIT              (c_header_export.h)
//   px4        TC_G* parameters: a cubic re-fitted from the model                      (px4_export.h)
//   ardupilot  INS_TCAL* parameters: the same in ArduPilot's convention                (ardupilot_export.h)
// Same model and options, same bytes: there is no date or time inside.
//
// Errors: VerdictForbids (axis_selection.h); ModelNotUsableHere and InvalidOption (compensation_table.h and
// the format's header); OutputNotWritable, OutputFull.
#pragma once

#include "engine/base/result.h"
#include "engine/compensation/compensation_table.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

enum class ExportFormat
{
    Csv,
    Json,
    C,
    Px4,
    ArduPilot
};
std::string_view exportFormatName(ExportFormat format); // "csv", "json", "c", "px4", "ardupilot"
std::optional<ExportFormat> exportFormatFromName(std::string_view name);

struct ExportOptions
{
    std::optional<std::array<bool, 3>> axes{}; // unset: every axis whose verdict is yes
    bool force = false;                        // also axes without a yes
    TableOptions table{};                      // csv, json, c
    std::string symbol = "gyro";               // c: prefix of every name in the header
    // Which gyro of the autopilot, as it counts: px4 0 to 3, ardupilot 1 to 3. Unset: the first.
    std::optional<int> gyro{};
    // px4: by which it knows the gyro again. Unset: the sensor's serial number, if that is a number.
    std::optional<std::uint32_t> deviceId{};
};

struct Exported
{
    std::string text;
    std::vector<std::string> notes; // what the user should know, each a sentence
};

Result<Exported> exportModel(const TrainedModel &model, ExportFormat format,
                             const ExportOptions &options = {});

// The notes of the above; the file is replaced whole or not at all.
Result<std::vector<std::string>> exportModelToFile(const TrainedModel &model, ExportFormat format,
                                                   const ExportOptions &options,
                                                   const std::filesystem::path &file);

} // namespace driftbench
