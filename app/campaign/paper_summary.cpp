#include "app/campaign/paper_summary.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

double mean(const std::vector<double> &values)
{
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

double standardError(const std::vector<double> &values)
{
    const double centre = mean(values);
    double sum = 0.0;
    for (const double value : values)
        sum += (value - centre) * (value - centre);
    const auto count = static_cast<double>(values.size());
    return std::sqrt(sum / (count - 1.0) / count);
}

std::vector<int> axesOf(const PaperTable &table)
{
    std::vector<int> axes;
    for (const PrintedRow &row : table.rows) {
        if (std::find(axes.begin(), axes.end(), row.axis) == axes.end())
            axes.push_back(row.axis);
    }
    return axes;
}

AxisSummary summariseAxis(const PaperExperimentOutcome &outcome, int axis)
{
    AxisSummary summary;
    summary.axis = axis;
    for (const std::string &model : paperModelNames()) {
        std::vector<double> before;
        std::vector<double> floor;
        std::vector<double> after;
        for (const ComparisonRow &row : outcome.rows) {
            if (row.axis != axis || row.model != model)
                continue;
            before.push_back(row.msdBefore);
            floor.push_back(row.noiseFloor);
            after.push_back(row.msdAfter);
        }
        summary.msdBefore = mean(before);
        summary.floor = mean(floor);
        summary.models.push_back({model, mean(after), (mean(after) - summary.floor) / summary.floor});
    }
    return summary;
}

// Of all the experiment's tables, on one axis.
double printedImprovement(const PaperExperiment &experiment, const PaperColumn &column, int axis)
{
    std::vector<double> printed;
    for (int number = experiment.firstTable; number <= experiment.lastTable; ++number) {
        const PaperTable table = paperTable(number);
        for (const PrintedRow &row : table.rows) {
            if (row.axis == axis)
                printed.push_back(column.of(table.msds(row)));
        }
    }
    return mean(printed);
}

ImprovementSummary summariseImprovement(const PaperExperimentOutcome &outcome, const PaperColumn &column,
                                        std::string_view novel, int axis)
{
    std::vector<double> simulated;
    for (int run = 0; run < kPaperRuns; ++run)
        simulated.push_back(column.of(outcome.msds(run, axis, novel)));
    return {column.role,
            column.against,
            std::string(column.role == PaperRole::Novel ? novel : kConventional2Model),
            axis,
            printedImprovement(outcome.experiment, column, axis),
            mean(simulated),
            standardError(simulated)};
}

} // namespace

ExperimentSummary summarise(const PaperExperimentOutcome &outcome)
{
    const PaperTable table = paperTable(outcome.experiment.firstTable);
    ExperimentSummary summary;
    summary.sensor = outcome.experiment.sensor;
    for (const int axis : axesOf(table)) {
        summary.axes.push_back(summariseAxis(outcome, axis));
        for (const PaperColumn &column : table.columns) {
            if (column.kind != PaperColumnKind::Improvement)
                continue;
            for (const std::string_view novel : kNovelModels) {
                if (column.role == PaperRole::Novel || novel == kNovelModels.front())
                    summary.improvements.push_back(summariseImprovement(outcome, column, novel, axis));
            }
        }
    }
    return summary;
}

} // namespace driftbench
