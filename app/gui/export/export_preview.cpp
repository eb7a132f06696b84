#include "app/gui/export/export_preview.h"

#include "engine/compensation/axis_selection.h"

#include <algorithm>
#include <cctype>

namespace driftbench {

namespace {

constexpr std::array kFormats{ExportFormat::Csv, ExportFormat::Json, ExportFormat::C, ExportFormat::Px4,
                              ExportFormat::ArduPilot};

std::string fileStem(const TrainedModel &model)
{
    std::string stem = (model.sensor.known() ? model.sensor.text() + " " : std::string()) + model.name;
    for (char &letter : stem) {
        if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '-' && letter != '.')
            letter = '_';
    }
    return stem;
}

void addFiles(const TrainedModel &model, const ExportChoice &choice, ExportPreview &preview)
{
    for (const ExportFormat format : kFormats) {
        FilePreview file;
        file.format = format;
        auto exported = exportModel(model, format, choice.options);
        if (exported)
            file.exported = *std::move(exported);
        else
            file.refusal = exported.error();
        preview.files.push_back(std::move(file));
    }
}

void addImage(const CompensationTable &table, const ExportChoice &choice, ExportPreview &preview)
{
    auto image = encodeDeviceImage(table, choice.deviceTable, choice.deviceThermometer);
    if (image)
        preview.image = *std::move(image);
    else
        preview.imageRefusal = image.error();
}

} // namespace

const FilePreview *ExportPreview::file(ExportFormat format) const
{
    const auto found = std::find_if(files.begin(), files.end(),
                                    [format](const FilePreview &each) { return each.format == format; });
    return found == files.end() ? nullptr : &*found;
}

ExportPreview makeExportPreview(const TrainedModel &model, const ExportChoice &choice)
{
    ExportPreview preview;
    preview.model = model.name;
    const auto selection = selectAxes(model, choice.options.axes, choice.options.force);
    if (!selection) {
        preview.refusal = selection.error();
        return preview;
    }
    preview.compensated = selection->compensated;
    preview.notes = selection->notes;
    auto table = makeCompensationTable(model, selection->compensated, choice.options.table);
    if (!table) {
        preview.refusal = table.error();
        return preview;
    }
    KnotsTableData data;
    data.table = *std::move(table);
    data.fixed = makeFixedPointTable(data.table);
    data.errors = measureTableErrors(model, data.table, data.fixed);
    preview.cubic = refitCubic(model, selection->compensated,
                               0.5 * (model.lowestTemperatureC + model.highestTemperatureC),
                               model.lowestTemperatureC, model.highestTemperatureC);
    addFiles(model, choice, preview);
    addImage(data.table, choice, preview);
    preview.table = std::make_shared<const KnotsTableData>(std::move(data));
    return preview;
}

std::string exportFileName(const TrainedModel &model, ExportFormat format)
{
    switch (format) {
    case ExportFormat::Csv:
        return fileStem(model) + ".csv";
    case ExportFormat::Json:
        return fileStem(model) + ".json";
    case ExportFormat::C:
        return fileStem(model) + ".h";
    case ExportFormat::Px4:
        return fileStem(model) + ".params";
    case ExportFormat::ArduPilot:
        return fileStem(model) + ".parm";
    }
    return fileStem(model);
}

std::string imageFileName(const TrainedModel &model)
{
    return fileStem(model) + ".bin";
}

} // namespace driftbench
