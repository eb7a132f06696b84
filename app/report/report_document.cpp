#include "app/report/report_document.h"

#include "app/report/report_text.h"
#include "engine/base/axes.h"
#include "engine/evaluation/axis_finding.h"
#include "engine/models/parameter_count.h"
#include "widgets/figure/figure_export.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"
#include "widgets/tables/comparison_table_model.h"
#include "widgets/tables/models_table_model.h"

#include <cmath>

namespace driftbench {

static QString runList(const std::vector<std::string> &runs)
{
    QStringList names;
    for (const std::string &run : runs)
        names.append(QString::fromStdString(run));
    return names.join(QStringLiteral(", "));
}

static QString novelModel(const ReportData &data)
{
    const TrainedModel *main = mainModel(data.models);
    return main != nullptr ? QString::fromStdString(main->name) : QStringLiteral("rbf");
}

static QString holdOutText(const ReportData &data)
{
    if (!data.holdOut.empty())
        return ReportText::tr("%1 held out").arg(runList(data.holdOut));
    return data.runs.size() == 1 ? ReportText::tr("Blocks of temperature held out in turn")
                                 : ReportText::tr("Each run held out once");
}

static QString judgingText(const ReportData &data)
{
    return data.judging == "anchored"
               ? ReportText::tr("Anchored: the bias at the start of each run is removed")
               : ReportText::tr("Absolute: the turn-on bias counts");
}

static void addFacts(const ReportData &data, const QDateTime &made, ReportDocument &document)
{
    Eigen::Index samples = 0, usable = 0;
    for (const RunFacts &run : data.facts) {
        samples += run.samples;
        usable += run.usable;
    }
    document.facts = {
        {ReportText::tr("Sensor"), data.sensor.empty() ? ReportText::tr("not stated by the logs")
                                                       : QString::fromStdString(data.sensor)},
        {ReportText::tr("Data"), document.origin},
        {ReportText::tr("Date of this report"), made.toString(Qt::ISODate)},
        {ReportText::tr("Runs"),
         ReportText::tr("%1, with %2 samples, %3 of them usable")
             .arg(data.runs.size())
             .arg(numberText(static_cast<double>(samples), 0), numberText(static_cast<double>(usable), 0))},
        {ReportText::tr("Reference temperature"),
         ReportText::tr("%1 °C").arg(numberText(data.referenceTemperatureC, 2))},
        {ReportText::tr("Hold-out"), holdOutText(data)},
        {ReportText::tr("Judged"), judgingText(data)},
        {ReportText::tr("Seed"), QString::number(data.seed)},
        {ReportText::tr("Limit"),
         data.limitDps
             ? ReportText::tr("%1 dps rms may be left on a held-out run").arg(numberText(*data.limitDps, 3))
             : ReportText::tr("none was set")}};
}

static void addCards(const ReportData &data, ReportDocument &document)
{
    const std::string novel = novelModel(data).toStdString();
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const AxisVerdict &judged = data.verdicts[static_cast<std::size_t>(axis)];
        const AxisFinding finding =
            findAxis(data.rows, axis, judgedModel(judged, novel), judged.verdict, data.limitDps);
        document.cards.push_back({QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data()),
                                  finding.verdict, verdictWord(finding.verdict), passText(finding),
                                  findingText(finding, data.hysteresis.rmsDps[axis]).whole(),
                                  QString::fromStdString(judged.reason)});
    }
}

static TableGrid::Cell cell(const QString &shown)
{
    return {shown, shown};
}

static QString maskedText(const RunFacts &run)
{
    QStringList parts;
    for (const auto &[reason, count] : run.masked)
        parts.append(QStringLiteral("%1 %2").arg(QString::fromStdString(reason),
                                                 numberText(static_cast<double>(count), 0)));
    return parts.isEmpty() ? ReportText::tr("nothing") : parts.join(QStringLiteral(", "));
}

static ReportTable runsTable(const ReportData &data)
{
    ReportTable table;
    table.title = ReportText::tr("Where the data come from");
    table.grid.heads = {ReportText::tr("Run"),
                        ReportText::tr("Source"),
                        ReportText::tr("Format"),
                        ReportText::tr("Reference dps"),
                        ReportText::tr("Samples"),
                        ReportText::tr("Usable"),
                        ReportText::tr("Left out, and why")};
    table.grid.numeric = {false, false, false, false, true, true, false};
    for (const RunFacts &run : data.facts) {
        const Eigen::Vector3d &rate = run.referenceRateDps;
        const QString rates =
            QStringLiteral("%1, %2, %3")
                .arg(numberText(rate[0], 2), numberText(rate[1], 2), numberText(rate[2], 2));
        table.grid.rows.push_back(
            {cell(QString::fromStdString(run.name)), cell(QString::fromStdString(run.file)),
             cell(QString::fromStdString(run.format)), cell(rates),
             cell(numberText(static_cast<double>(run.samples), 0)),
             cell(numberText(static_cast<double>(run.usable), 0)), cell(maskedText(run))});
    }
    return table;
}

static double meanOver(const std::vector<ComparisonRow> &rows, const std::string &model, int axis,
                       double ComparisonRow::*figure)
{
    double sum = 0.0;
    int count = 0;
    for (const ComparisonRow &row : rows) {
        if (row.model != model || row.axis != axis)
            continue;
        sum += row.*figure;
        ++count;
    }
    return count > 0 ? sum / count : NAN;
}

static ReportTable modelsTable(const ReportData &data)
{
    ModelsTableData shown;
    for (const auto &[name, model] : data.models) {
        if (name == "auto")
            continue;
        ModelLine line;
        line.name = name;
        line.state = ModelLine::State::Finished;
        line.parameters = parameterCount(model.model);
        const auto time = data.trainingS.find(name);
        line.timeS = time == data.trainingS.end() ? NAN : time->second;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int a = static_cast<int>(axis);
            line.msd[axis] = meanOver(data.rows, name, a, &ComparisonRow::msdAfter);
            line.excessPercent[axis] = 100.0 * meanOver(data.rows, name, a, &ComparisonRow::excessOverFloor);
            shown.floor[axis] = meanOver(data.rows, name, a, &ComparisonRow::noiseFloor);
        }
        shown.models.push_back(line);
    }
    ModelsTableModel model;
    model.setData(std::move(shown));
    ReportTable table;
    table.title = ReportText::tr("Models");
    table.note = ReportText::tr("Means over the held-out runs.");
    table.grid = gridOf(model);
    return table;
}

static ReportTable comparisonTable(const ReportData &data)
{
    ComparisonTableModel model;
    model.setData({data.rows, novelModel(data).toStdString(), std::nullopt, data.limitDps, {}});
    ReportTable table;
    table.title = ReportText::tr("Held-out runs, in the paper's order");
    table.note = ReportText::tr("MSD in dps²: mean square of what is left. Q: MSD after over MSD before. "
                                "Differences: negative where the first named is better. Novel: %1.")
                     .arg(modelLabel(novelModel(data).toStdString()));
    table.grid = gridOf(model);
    return table;
}

static QStringList methodText(const ReportData &data)
{
    return {
        ReportText::tr(
            "Each model estimates the rate error as a function of temperature alone and is judged "
            "only on runs that it has not seen. %1. The noise floor is the variance within 0.5 °C: "
            "what no function of temperature removes. Excess is what a model leaves above it.")
            .arg(holdOutText(data)),
        ReportText::tr(
            "Conventional 1 is a line in ΔT, Conventional 2 a BP network 2-10-1, Novel an RBF "
            "network on ΔT, ΔT² and √ΔT; cubic is the model of PX4 and ArduPilot, constant the bias "
            "alone."),
        ReportText::tr("Yes: within the limit and better than the constant on every held-out run. With care: "
                       "within the limit, but not always better. No: over the limit on any run, or the bias "
                       "does not repeat.")};
}

ReportDocument reportDocument(const ReportData &data, const QDateTime &made)
{
    const FileNumbers numbers;
    ReportDocument document;
    document.simulated = data.simulated;
    document.origin = data.simulated ? ReportText::tr("Simulated data") : ReportText::tr("Real log");
    const QString sensor =
        data.sensor.empty() ? ReportText::tr("unknown sensor") : QString::fromStdString(data.sensor);
    document.title = data.simulated ? ReportText::tr("Temperature drift of %1, simulated").arg(sensor)
                                    : ReportText::tr("Temperature drift of %1").arg(sensor);
    addFacts(data, made, document);
    addCards(data, document);
    document.method = methodText(data);
    document.tables.push_back(comparisonTable(data));
    document.tables.push_back(modelsTable(data));
    document.tables.push_back(runsTable(data));
    for (const std::string &warning : data.warnings)
        document.notes.append(QString::fromStdString(warning));
    return document;
}

FigureDrawing::FigureDrawing(FigureTask task, QString origin)
    : m_task(std::move(task)), m_origin(std::move(origin))
{
}

bool FigureDrawing::goOn()
{
    const FileNumbers numbers;
    switch (m_next) {
    case Part::View:
        m_view = m_task.make(m_origin);
        m_next = m_view->isEmpty() ? Part::Done : Part::Svg;
        return true;
    case Part::Svg:
        m_figure = ReportFigure{m_task.title, m_task.caption, m_view->figureSize(), QByteArray(), QPicture()};
        m_figure->svg = figureAsSvg(*m_view, m_figure->size, {m_task.title, m_task.caption});
        m_next = Part::Picture;
        return true;
    case Part::Picture:
        m_figure->picture = figureAsPicture(*m_view, m_figure->size);
        m_next = Part::Done;
        return true;
    case Part::Done:
        break;
    }
    m_view.reset();
    return false;
}

Result<ReportDocument> completeReport(const std::shared_ptr<const ReportData> &data, const QDateTime &made)
{
    auto prepared = prepareFigures(data);
    if (!prepared)
        return prepared.error();
    ReportDocument document = reportDocument(*data, made);
    const auto figures = std::make_shared<const PreparedFigures>(*std::move(prepared));
    for (FigureTask &task : figureTasks(figures, lightPalette(), true)) {
        FigureDrawing drawing(std::move(task), document.simulated ? document.origin : QString());
        while (drawing.goOn()) {
        }
        if (auto figure = drawing.take())
            document.figures.push_back(std::move(*figure));
    }
    return document;
}

} // namespace driftbench
