#include "app/report/report_data_loader.h"

#include "app/report/report_json.h"
#include "engine/formats/log_reader.h"
#include "engine/models/model_file.h"
#include "engine/recording/quality.h"

#include <algorithm>

namespace driftbench {

const TrainedModel *mainModel(const std::map<std::string, TrainedModel> &models)
{
    for (const char *name : {"rbf", "rbf-paper", "bpnn", "cubic", "cubic-ardupilot", "linear"}) {
        const auto found = models.find(name);
        if (found != models.end())
            return &found->second;
    }
    return nullptr;
}

static Result<std::map<std::string, TrainedModel>> loadModels(const std::filesystem::path &folder)
{
    std::map<std::string, TrainedModel> models;
    std::error_code code;
    for (const auto &entry : std::filesystem::directory_iterator(folder, code)) {
        if (entry.path().extension() != ".json")
            continue;
        auto model = loadModel(entry.path());
        if (!model)
            return model.error();
        models.emplace(entry.path().stem().string(), std::move(*model));
    }
    return models;
}

static std::filesystem::path runFile(const std::filesystem::path &folder, const std::string &file)
{
    std::error_code code;
    const std::filesystem::path asWritten(file);
    return asWritten.is_relative() && !std::filesystem::exists(asWritten, code) ? folder / asWritten
                                                                                : asWritten;
}

static void keepExcluded(const Run &run, double referenceTemperatureC, ReportRun &kept)
{
    const Recording &recording = *run.recording;
    std::vector<Eigen::Index> excluded;
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        if (!run.mask.usableForJudging(i))
            excluded.push_back(i);
    }
    const auto count = static_cast<Eigen::Index>(excluded.size());
    kept.excludedDeltaT.resize(count);
    kept.excludedTdeDps.resize(count, 3);
    for (Eigen::Index row = 0; row < count; ++row) {
        const Eigen::Index i = excluded[static_cast<std::size_t>(row)];
        kept.excludedDeltaT[row] = recording.temperatureC[i] - referenceTemperatureC;
        kept.excludedTdeDps.row(row) = recording.rateDps.row(i) - run.referenceRateDps.transpose();
    }
}

// What the fit accepted is drawn, also where it had to be told to accept it.
static QualityOptions lenient(const std::string &name)
{
    QualityOptions options;
    options.name = name;
    options.maskBadRows = true;
    options.allowSmallSpan = true;
    options.allowShort = true;
    return options;
}

static Result<ReportRun> loadRun(const std::filesystem::path &folder, const ComparisonFile::RunEntry &entry,
                                 ReportData &data)
{
    ReadOptions options;
    if (entry.format != logFormatName(LogFormat::Csv)) // a table holds one sensor and has no numbers for it
        options.instance = entry.instance;
    auto recording = readLog(runFile(folder, entry.file), options);
    if (!recording)
        return recording.error();
    if (data.sensor.empty() && recording->info.sensor.known())
        data.sensor = recording->info.sensor.text();
    auto run = prepareRun(std::move(*recording), lenient(entry.name));
    if (!run)
        return run.error();
    run->referenceRateDps = entry.referenceRateDps;
    ReportRun loaded;
    loaded.features = std::make_shared<const RunFeatures>(makeRunFeatures(*run, data.referenceTemperatureC));
    loaded.referenceRateDps = entry.referenceRateDps;
    keepExcluded(*run, data.referenceTemperatureC, loaded);
    return loaded;
}

Result<ReportData> loadReportData(const std::filesystem::path &folder)
{
    auto file = readComparisonFile(folder / "comparison.json");
    if (!file)
        return file.error();
    ReportData data;
    data.simulated = file->simulated;
    data.judging = file->judging;
    data.referenceTemperatureC = file->referenceTemperatureC;
    data.rbfSelection = std::move(file->rbfSelection);
    data.verdicts = file->verdicts;
    data.rows = std::move(file->rows);

    auto models = loadModels(folder / "models");
    if (!models)
        return models.error();
    data.models = std::move(*models);
    for (const auto &entry : file->runs) {
        auto run = loadRun(folder, entry, data);
        if (!run)
            return run.error();
        data.runs.push_back(std::move(*run));
        auto heldOut = loadModels(folder / "held-out" / entry.name);
        if (!heldOut)
            return heldOut.error();
        if (heldOut->empty())
            data.warnings.push_back(
                "Run " + entry.name +
                " has no model that was trained without it, so it is not shown compensated.");
        else
            data.heldOut.emplace(entry.name, std::move(*heldOut));
    }
    return data;
}

} // namespace driftbench
