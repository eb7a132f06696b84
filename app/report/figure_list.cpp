#include "app/report/figure_list.h"

#include "app/report/figure_writer.h"
#include "app/report/report_text.h"
#include "engine/base/axes.h"
#include "widgets/style/role_pens.h"
#include "widgets/views/allan_view.h"
#include "widgets/views/before_after_view.h"
#include "widgets/views/centres_view.h"
#include "widgets/views/judged_run_view.h"
#include "widgets/views/tcq_time_view.h"

#include <cctype>

namespace driftbench {

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

static void gatherExcluded(const ReportData &data, TcqScatterData &scatter)
{
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
    gatherExcluded(data, scatter);
    return scatter;
}

static ResidualData residualsOf(const PreparedFigures &prepared)
{
    ResidualData left;
    left.referenceTemperatureC = prepared.data->referenceTemperatureC;
    for (const HeldOutRun &run : prepared.heldOut) {
        left.runs.push_back(run.run->features);
        left.residualDps.push_back(run.residualDps);
    }
    if (const TrainedModel *main = mainModel(prepared.data->models))
        left.band = main->band;
    return left;
}

Result<PreparedFigures> prepareFigures(std::shared_ptr<const ReportData> data, const ProgressHook &hook)
{
    PreparedFigures prepared;
    prepared.data = std::move(data);
    const ReportData &report = *prepared.data;
    const Judging judging = judgingFromName(report.judging).value_or(Judging::Absolute);
    std::size_t done = 0;
    for (const ReportRun &run : report.runs) {
        const double part = static_cast<double>(done++) / static_cast<double>(report.runs.size());
        if (driftbench::report(hook, "preparing the report", part) == Flow::Stop)
            return Error{Errc::Cancelled, "The report was cancelled; nothing was written."};
        const auto models = report.heldOut.find(run.features->name);
        const TrainedModel *model = models == report.heldOut.end() ? nullptr : mainModel(models->second);
        if (model == nullptr)
            continue;
        const auto constant = models->second.find("constant");
        const Eigen::VectorXd temperatureC = run.features->deltaT.array() + report.referenceTemperatureC;
        prepared.heldOut.push_back(
            {&run, model, run.features->tdeDps - predictAtTemperature(*model, temperatureC).tdeDps,
             judgedTraces(run.features, *model,
                          constant == models->second.end() ? nullptr : &constant->second, judging)});
    }
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        prepared.scatter[a] = scatterOf(report, axis);
        prepared.dots[a] = tcqDots(prepared.scatter[a]);
    }
    prepared.residuals = residualTraces(residualsOf(prepared));
    return prepared;
}

QString trainedOnText(const TrainedModel &model)
{
    QStringList runs;
    for (const std::string &run : model.trainedOn)
        runs.append(QString::fromStdString(run));
    return runs.isEmpty() ? ReportText::tr("%1 trained on other runs").arg(modelLabel(model.name))
                          : ReportText::tr("%1 trained on %2")
                                .arg(modelLabel(model.name), runs.join(QStringLiteral(", ")));
}

// With its origin before its data: a view is built anew by each.
template <class View>
static std::unique_ptr<View> viewFor(const Palette &look, const QString &origin)
{
    auto view = std::make_unique<View>(look);
    if (!origin.isEmpty())
        view->setOrigin(origin);
    return view;
}

static FigureTask tcqOverTime(const ReportData &data, const Palette &look)
{
    const auto run = data.runs.front().features;
    return {"fig7_tcq_over_time", ReportText::tr("Temperature quantities and drift error over time"),
            ReportText::tr("Run %1: ΔT, ΔT² and √ΔT, and the temperature drift error (TDE) of each axis.")
                .arg(QString::fromStdString(run->name)),
            [run, look](const QString &origin) {
                auto view = viewFor<TcqTimeView>(look, origin);
                view->setRun(run);
                return view;
            }};
}

using SharedFigures = std::shared_ptr<const PreparedFigures>;

static FigureTask tcqAgainstTde(const SharedFigures &prepared, int axis, const Palette &look)
{
    return {"fig8_tcq_against_tde_" + axisName(axis).toStdString(),
            ReportText::tr("TDE of %1 against each temperature quantity").arg(axisName(axis)),
            ReportText::tr("All runs, with the curves fitted to them; below, what the fitted curve "
                           "leaves. Where heating and cooling part, no curve of temperature follows."),
            [prepared, axis, look](const QString &origin) {
                const auto a = static_cast<std::size_t>(axis);
                auto view = viewFor<TcqScatterView>(look, origin);
                view->setData(prepared->scatter[a], prepared->dots[a]);
                return view;
            }};
}

static BeforeAfterData tracesOf(const ReportData &data, const HeldOutRun &heldOut)
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
    return traces;
}

static FigureTask beforeAfter(const SharedFigures &prepared, std::size_t run, const Palette &look)
{
    const std::string &name = prepared->heldOut[run].run->features->name;
    return {"fig10_before_after_" + fileNamePart(name),
            ReportText::tr("Run %1 before and after compensation").arg(QString::fromStdString(name)),
            ReportText::tr("The model has not seen this run. Mean, and lowest to highest, of each stretch of "
                           "time; rms about the reference rate."),
            [prepared, run, look](const QString &origin) {
                auto view = viewFor<BeforeAfterView>(look, origin);
                view->setData(tracesOf(*prepared->data, prepared->heldOut[run]));
                return view;
            }};
}

static FigureTask allanOf(const SharedFigures &prepared, std::size_t run, const Palette &look)
{
    const std::string &name = prepared->heldOut[run].run->features->name;
    return {"allan_" + fileNamePart(name),
            ReportText::tr("Allan deviation of run %1").arg(QString::fromStdString(name)),
            ReportText::tr("Noise falls with the averaging time, drift rises with it."),
            [prepared, run, look](const QString &origin) {
                const HeldOutRun &heldOut = prepared->heldOut[run];
                const RunFeatures &features = *heldOut.run->features;
                auto view = viewFor<AllanView>(look, origin);
                view->setData({allanDeviation(features.timeS, features.tdeDps),
                               allanDeviation(features.timeS, heldOut.residualDps),
                               trainedOnText(*heldOut.model)});
                return view;
            }};
}

static FigureTask judgedRun(const SharedFigures &prepared, std::size_t run, const Palette &look)
{
    const std::string &name = prepared->heldOut[run].run->features->name;
    return {
        "judged_" + fileNamePart(name),
        ReportText::tr("Run %1, held out: what is left, and its Allan deviation")
            .arg(QString::fromStdString(name)),
        ReportText::tr("Before, less the constant; after, by a model that has not seen this run. Each axis "
                       "has its own scale."),
        [prepared, run, look](const QString &origin) {
            auto view = viewFor<JudgedRunView>(look, origin);
            view->setData({std::make_shared<const JudgedTraces>(prepared->heldOut[run].traces),
                           prepared->data->limitDps});
            return view;
        }};
}

static FigureTask residuals(const SharedFigures &prepared, const Palette &look)
{
    return {"residuals", ReportText::tr("What is left of the TDE on runs held out"),
            ReportText::tr("Each run less the model that has not seen it. Lines that are level at zero mean "
                           "that the drift repeats."),
            [prepared, look](const QString &origin) {
                auto view = viewFor<ResidualView>(look, origin);
                view->setTraces(prepared->residuals);
                return view;
            }};
}

static CentresData centresOf(const ReportData &data, const TrainedModel &model, const RbfNetwork &network)
{
    CentresData centres;
    centres.selection = data.rbfSelection;
    centres.curve = modelCurve(model);
    centres.centres = rbfCentres(network);
    centres.centreCount = network.centreCount;
    centres.runs = featuresOfAll(data);
    centres.referenceTemperatureC = data.referenceTemperatureC;
    return centres;
}

static FigureTask centres(const std::shared_ptr<const ReportData> &data, const Palette &look)
{
    return {"centres", ReportText::tr("How many centres the RBF network needs"),
            ReportText::tr("The smallest number whose loss on data left out is as good as the lowest; below, "
                           "where the centres stand."),
            [data, look](const QString &origin) {
                auto view = viewFor<CentresView>(look, origin);
                const auto found = data->models.find("rbf");
                const auto *network =
                    found == data->models.end() ? nullptr : std::get_if<RbfNetwork>(&found->second.model);
                if (network != nullptr)
                    view->setData(centresOf(*data, found->second, *network));
                return view;
            }};
}

std::vector<FigureTask> figureTasks(const SharedFigures &prepared, const Palette &look, bool judged)
{
    std::vector<FigureTask> tasks;
    if (!prepared->data->runs.empty())
        tasks.push_back(tcqOverTime(*prepared->data, look));
    for (int axis = 0; axis < kAxisCount; ++axis)
        tasks.push_back(tcqAgainstTde(prepared, axis, look));
    for (std::size_t run = 0; run < prepared->heldOut.size(); ++run)
        tasks.push_back(beforeAfter(prepared, run, look));
    tasks.push_back(residuals(prepared, look));
    for (std::size_t run = 0; run < prepared->heldOut.size(); ++run)
        tasks.push_back(judged ? judgedRun(prepared, run, look) : allanOf(prepared, run, look));
    tasks.push_back(centres(prepared->data, look));
    return tasks;
}

Result<std::vector<WrittenFigure>> writeFigures(const ReportData &data, const Palette &look,
                                                const std::filesystem::path &folder)
{
    FigureWriter writer(folder, data.simulated ? ReportText::tr("Simulated data") : QString());
    auto prepared = prepareFigures(std::make_shared<const ReportData>(data));
    if (!prepared)
        return prepared.error();
    for (const FigureTask &task :
         figureTasks(std::make_shared<const PreparedFigures>(*std::move(prepared)), look)) {
        const auto view = task.make(QString());
        writer.write(*view, task.stem, task.title, task.caption);
    }
    return writer.finish();
}

} // namespace driftbench
