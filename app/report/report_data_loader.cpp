#include "app/report/report_data_loader.h"

#include "app/campaign/campaign_request.h"
#include "app/campaign/held_out_folders.h"
#include "app/session/session.h"
#include "engine/exports/comparison_reader.h"
#include "engine/models/model_file.h"

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

static void keepRuns(const LoadedCampaign &loaded, ReportData &data)
{
    if (loaded.campaign.sensor.known())
        data.sensor = loaded.campaign.sensor.text();
    for (std::size_t i = 0; i < loaded.campaign.runs.size(); ++i) {
        const Run &run = loaded.campaign.runs[i];
        ReportRun kept;
        kept.features = loaded.features.runs[i];
        kept.referenceRateDps = run.referenceRateDps;
        keepExcluded(run, data.referenceTemperatureC, kept);
        data.runs.push_back(std::move(kept));
        data.facts.push_back(factsOf(run));
    }
}

// The runs as the fit read, checked and referred them.
static Status readRuns(const std::filesystem::path &folder, ReportData &data)
{
    auto request = loadRequest(folder / "request.json");
    if (!request)
        return request.error();
    request->referenceTemperatureC = data.referenceTemperatureC;
    const auto loaded = loadCampaign(*request);
    if (!loaded)
        return loaded.error();
    keepRuns(*loaded, data);
    return {};
}

static Status loadHeldOut(const std::filesystem::path &folder, ReportData &data)
{
    std::vector<std::string> names;
    for (const ReportRun &run : data.runs)
        names.push_back(run.features->name);
    const std::vector<std::string> folders = heldOutFolders(names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string &name = names[i];
        auto heldOut = loadModels(folder / "held-out" / folders[i]);
        if (!heldOut)
            return heldOut.error();
        if (heldOut->empty())
            data.warnings.push_back(
                "Run " + name + " has no model that was trained without it, so it is not shown compensated.");
        else
            data.heldOut.emplace(name, std::move(*heldOut));
    }
    return {};
}

static ReportData withFigures(ReadComparison figures)
{
    ReportData data;
    data.simulated = figures.simulated;
    data.judging = figures.judging;
    data.referenceTemperatureC = figures.referenceTemperatureC;
    data.rbfSelection = std::move(figures.rbfSelection);
    data.verdicts = figures.verdicts;
    data.rows = std::move(figures.rows);
    data.hysteresis = std::move(figures.hysteresis);
    data.seed = figures.seed;
    data.holdOut = std::move(figures.holdOut);
    data.warnings = std::move(figures.warnings);
    return data;
}

ReportData reportDataOf(const PreparedCampaign &prepared, const CalibrationResult &result)
{
    ReportData data = withFigures(result.figures);
    data.limitDps = prepared.plan.limitRmsDps;
    data.trainingS = result.trainingS;
    keepRuns(prepared.loaded, data);
    for (const TrainedModel &model : result.models)
        data.models.emplace(model.name, model);
    for (const HeldOutModels &fold : result.heldOut) {
        for (const TrainedModel &model : fold.models)
            data.heldOut[fold.fold].emplace(model.name, model);
    }
    return data;
}

static Result<ReportData> loadSessionReport(const std::filesystem::path &path)
{
    const auto session = Session::open(path, SessionAccess::ReadOnly);
    if (!session)
        return session.error();
    const auto &result = (*session)->result();
    if (!result)
        return Error{Errc::NoSuchRun, path.string() +
                                          " holds no models of its runs as they are now; train them with "
                                          "\"driftbench-cli fit " +
                                          path.string() + "\"."};
    CalibrationPlan plan = (*session)->plan();
    plan.referenceTemperatureC = result->figures.referenceTemperatureC;
    const auto runs = loadRuns((*session)->file(), plan, {});
    if (!runs)
        return runs.error();
    const auto prepared = prepareCampaign(plan, *runs);
    if (!prepared)
        return prepared.error();
    if (prepared->refusal)
        return *prepared->refusal;
    return reportDataOf(*prepared, *result);
}

Result<ReportData> loadReportData(const std::filesystem::path &folder)
{
    if (folder.extension() == kSessionEnding)
        return loadSessionReport(folder);
    auto file = readComparisonFile(folder / "comparison.json");
    if (!file)
        return file.error();
    ReportData data = withFigures(*std::move(file));

    auto models = loadModels(folder / "models");
    if (!models)
        return models.error();
    data.models = std::move(*models);
    if (Status runs = readRuns(folder, data); !runs)
        return runs.error();
    if (Status heldOut = loadHeldOut(folder, data); !heldOut)
        return heldOut.error();
    return data;
}

} // namespace driftbench
