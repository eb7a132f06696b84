#include "engine/exports/export_model.h"

#include "engine/base/atomic_file.h"
#include "engine/base/text.h"
#include "engine/compensation/axis_selection.h"
#include "engine/exports/ardupilot_export.h"
#include "engine/exports/c_header_export.h"
#include "engine/exports/px4_export.h"
#include "engine/exports/table_csv.h"
#include "engine/exports/table_json.h"

#include <utility>

namespace driftbench {

namespace {

constexpr std::array<std::pair<ExportFormat, std::string_view>, 5> kFormatNames{
    {{ExportFormat::Csv, "csv"},
     {ExportFormat::Json, "json"},
     {ExportFormat::C, "c"},
     {ExportFormat::Px4, "px4"},
     {ExportFormat::ArduPilot, "ardupilot"}}};

std::string boundNote(const CompensationTable &table)
{
    return "The model is steep around its reference temperature: the table's " +
           std::to_string(table.size()) + " knots keep the interpolation error below " +
           fixed(table.interpolationErrorBoundDps, 4) + " dps instead of " +
           shortest(TableOptions::kDefaultErrorDps) + " dps.";
}

Result<std::string> tableText(const CompensationTable &table, ExportFormat format,
                              const ExportOptions &options)
{
    switch (format) {
    case ExportFormat::Csv:
        return tableToCsv(table);
    case ExportFormat::Json:
        return tableToJson(table);
    default:
        return tableToCHeader(table, options.symbol);
    }
}

Result<Exported> exportTable(const TrainedModel &model, ExportFormat format, const ExportOptions &options,
                             const AxisSelection &selection)
{
    auto table = makeCompensationTable(model, selection.compensated, options.table);
    if (!table)
        return table.error();
    auto text = tableText(*table, format, options);
    if (!text)
        return text.error();
    Exported exported{*std::move(text), selection.notes};
    if (!options.table.maxInterpolationErrorDps &&
        table->interpolationErrorBoundDps > TableOptions::kDefaultErrorDps)
        exported.notes.push_back(boundNote(*table));
    return exported;
}

} // namespace

std::string_view exportFormatName(ExportFormat format)
{
    for (const auto &[value, name] : kFormatNames) {
        if (value == format)
            return name;
    }
    return "";
}

std::optional<ExportFormat> exportFormatFromName(std::string_view name)
{
    for (const auto &[value, known] : kFormatNames) {
        if (known == name)
            return value;
    }
    return std::nullopt;
}

Result<Exported> exportModel(const TrainedModel &model, ExportFormat format, const ExportOptions &options)
{
    const auto selection = selectAxes(model, options.axes, options.force);
    if (!selection)
        return selection.error();
    if (format == ExportFormat::Px4)
        return exportForPx4(model, options, *selection);
    if (format == ExportFormat::ArduPilot)
        return exportForArduPilot(model, options, *selection);
    return exportTable(model, format, options, *selection);
}

Result<std::vector<std::string>> exportModelToFile(const TrainedModel &model, ExportFormat format,
                                                   const ExportOptions &options,
                                                   const std::filesystem::path &file)
{
    auto exported = exportModel(model, format, options);
    if (!exported)
        return exported.error();
    if (const Status status = writeFileAtomically(file, exported->text); !status)
        return status.error();
    return std::move(exported->notes);
}

} // namespace driftbench
