#include "app/report/figure_list.h"

#include "app/report/figure_writer.h"
#include "engine/base/axes.h"
#include "engine/evaluation/allan.h"
#include "widgets/style/role_pens.h"
#include "widgets/views/allan_view.h"
#include "widgets/views/before_after_view.h"
#include "widgets/views/centres_view.h"
#include "widgets/views/residual_view.h"
#include "widgets/views/tcq_scatter_view.h"
#include "widgets/views/tcq_time_view.h"

#include <cctype>

namespace driftbench {

namespace {

// A run that was held out, with the model that never saw it.
struct HeldOutRun
{
    const ReportRun *run = nullptr;
    const TrainedModel *model = nullptr;
    Eigen::MatrixX3d residualDps;
};

} // namespace

static QString axisName(int axis)
{
    return QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data());
}

static std::string fileNamePart(const std::string &name)
{
    std::string part;
    for (const char c : name)
        part += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.' ? c : '_';
    return part;
}

static std::vector<std::shared_ptr<const RunFeatures>> featuresOfAll(const ReportData &data)
{
    std::vector<std::shared_ptr<const RunFeatures>> runs;
    for (const ReportRun &run : data.runs)
        runs.push_back(run.features);
    return runs;
}

static std::vector<HeldOutRun> heldOutRuns(const ReportData &data)
{
    std::vector<HeldOutRun> result;
    for (const ReportRun &run : data.runs) {
        const auto models = data.heldOut.find(run.features->name);
        const TrainedModel *model = models == data.heldOut.end() ? nullptr : mainModel(models->second);
        if (model == nullptr)
            continue;
        const Eigen::VectorXd temperatureC = run.features->deltaT.array() + data.referenceTemperatureC;
        result.push_back(
            {&run, model, run.features->tdeDps - predictAtTemperature(*model, temperatureC).tdeDps});
    }
    return result;
}

static QString trainedOnText(const TrainedModel &model)
{
    QStringList runs;
    for (const std::string &run : model.trainedOn)
        runs.append(QString::fromStdString(run));
    return QStringLiteral("%1 trained on %2")
        .arg(modelLabel(model.name),
             runs.isEmpty() ? QStringLiteral("other runs") : runs.join(QStringLiteral(", ")));
}

static void writeTcqOverTime(const ReportData &data, const Palette &look, FigureWriter &writer)
{
    if (data.runs.empty())
        return;
    TcqTimeView view(look);
    view.setRun(data.runs.front().features);
    writer.write(
        view, "fig7_tcq_over_time", QStringLiteral("Temperature quantities and drift error over time"),
        QStringLiteral("Run %1: ΔT, ΔT² and √ΔT, and the temperature drift error (TDE) of each axis.")
            .arg(QString::fromStdString(data.runs.front().features->name)));
}

static TcqScatterData scatterOf(const ReportData &data, int axis)
{
    TcqScatterData scatter;
    scatter.axis = axis;
    scatter.runs = featuresOfAll(data);
    scatter.referenceTemperatureC = data.referenceTemperatureC;
    if (const TrainedModel *main = mainModel(data.models)) {
        scatter.curves.push_back(modelCurve(*main));
        scatter.band = main->band;
        for (const char *other : {"cubic", "linear"}) {
            const auto found = data.models.find(other);
            if (found != data.models.end() && &found->second != main)
                scatter.curves.push_back(modelCurve(found->second));
        }
    }
    Eigen::Index excluded = 0;
    for (const ReportRun &run : data.runs)
        excluded += run.excludedDeltaT.size();
    scatter.excludedDeltaT.resize(excluded);
    scatter.excludedTdeDps.resize(excluded, 3);
    Eigen::Index row = 0;
    for (const ReportRun &run : data.runs) {
        const Eigen::Index count = run.excludedDeltaT.size();
        scatter.excludedDeltaT.segment(row, count) = run.excludedDeltaT;
        scatter.excludedTdeDps.middleRows(row, count) = run.excludedTdeDps;
        row += count;
    }
    return scatter;
}

static void writeTcqAgainstTde(const ReportData &data, const Palette &look, FigureWriter &writer)
{
    for (int axis = 0; axis < kAxisCount; ++axis) {
        TcqScatterView view(look);
        view.setData(scatterOf(data, axis));
        writer.write(
            view, "fig8_tcq_against_tde_" + axisName(axis).toStdString(),
            QStringLiteral("TDE of %1 against each temperature quantity").arg(axisName(axis)),
            QStringLiteral("All runs, with the curves fitted to them; below, what the fitted curve "
                           "leaves. Where heating and cooling part, no curve of temperature follows."));
    }
}

static void writeBeforeAfter(const ReportData &data, const Palette &look, const HeldOutRun &heldOut,
                             FigureWriter &writer)
{
    const RunFeatures &run = *heldOut.run->features;
    const Eigen::RowVector3d reference = heldOut.run->referenceRateDps.transpose();
    BeforeAfterData traces;
    traces.timeS = run.timeS;
    traces.temperatureC = run.deltaT.array() + data.referenceTemperatureC;
    traces.beforeDps = run.tdeDps.rowwise() + reference;
    traces.afterDps = heldOut.residualDps.rowwise() + reference;
    traces.referenceRateDps = heldOut.run->referenceRateDps;
    traces.afterText = trainedOnText(*heldOut.model);
    BeforeAfterView view(look);
    view.setData(std::move(traces));
    writer.write(
        view, "fig10_before_after_" + fileNamePart(run.name),
        QStringLiteral("Run %1 before and after compensation").arg(QString::fromStdString(run.name)),
        QStringLiteral("The model has not seen this run. Mean, and lowest to highest, of each stretch of "
                       "time; rms about the reference rate."));
}

static void writeAllan(const Palette &look, const HeldOutRun &heldOut, FigureWriter &writer)
{
    const RunFeatures &run = *heldOut.run->features;
    AllanView view(look);
    view.setData({allanDeviation(run.timeS, run.tdeDps), allanDeviation(run.timeS, heldOut.residualDps),
                  trainedOnText(*heldOut.model)});
    writer.write(view, "allan_" + fileNamePart(run.name),
                 QStringLiteral("Allan deviation of run %1").arg(QString::fromStdString(run.name)),
                 QStringLiteral("Noise falls with the averaging time, drift rises with it."));
}

static void writeResiduals(const ReportData &data, const Palette &look,
                           const std::vector<HeldOutRun> &heldOut, FigureWriter &writer)
{
    ResidualData residuals;
    residuals.referenceTemperatureC = data.referenceTemperatureC;
    for (const HeldOutRun &run : heldOut) {
        residuals.runs.push_back(run.run->features);
        residuals.residualDps.push_back(run.residualDps);
    }
    if (const TrainedModel *main = mainModel(data.models))
        residuals.band = main->band;
    ResidualView view(look);
    view.setData(std::move(residuals));
    writer.write(
        view, "residuals", QStringLiteral("What is left of the TDE on runs held out"),
        QStringLiteral("Each run less the model that has not seen it. Lines that are level at zero mean "
                       "that the drift repeats."));
}

static void writeCentres(const ReportData &data, const Palette &look, FigureWriter &writer)
{
    const auto found = data.models.find("rbf");
    const auto *network =
        found == data.models.end() ? nullptr : std::get_if<RbfNetwork>(&found->second.model);
    if (network == nullptr)
        return;
    CentresData centres;
    centres.selection = data.rbfSelection;
    centres.curve = modelCurve(found->second);
    centres.centres = rbfCentres(*network);
    centres.centreCount = network->centreCount;
    centres.runs = featuresOfAll(data);
    centres.referenceTemperatureC = data.referenceTemperatureC;
    CentresView view(look);
    view.setData(std::move(centres));
    writer.write(
        view, "centres", QStringLiteral("How many centres the RBF network needs"),
        QStringLiteral("The smallest number whose loss on data left out is as good as the lowest; below, "
                       "where the centres stand."));
}

Result<std::vector<WrittenFigure>> writeFigures(const ReportData &data, const Palette &look,
                                                const std::filesystem::path &folder)
{
    FigureWriter writer(folder, data.simulated ? QStringLiteral("Simulated data") : QString());
    const std::vector<HeldOutRun> heldOut = heldOutRuns(data);
    writeTcqOverTime(data, look, writer);
    writeTcqAgainstTde(data, look, writer);
    for (const HeldOutRun &run : heldOut)
        writeBeforeAfter(data, look, run, writer);
    writeResiduals(data, look, heldOut, writer);
    for (const HeldOutRun &run : heldOut)
        writeAllan(look, run, writer);
    writeCentres(data, look, writer);
    return writer.finish();
}

} // namespace driftbench
