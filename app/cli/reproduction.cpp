#include "app/cli/reproduction.h"

#include "engine/base/axes.h"

#include <algorithm>

namespace driftbench::cli {

namespace {

const PaperExperiment *experimentOf(int table)
{
    for (const PaperExperiment &experiment : paperExperiments()) {
        if (experiment.shows(table))
            return &experiment;
    }
    return nullptr;
}

std::vector<double> simulatedFigures(const std::vector<PaperExperimentOutcome> &outcomes, int table,
                                     const PrintedRow &row, const PaperColumn &column)
{
    std::vector<double> figures;
    for (const PaperExperimentOutcome &outcome : outcomes) {
        if (!outcome.experiment.shows(table))
            continue;
        for (const std::string_view novel : kNovelModels)
            figures.push_back(column.of(outcome.msds(row.run, row.axis, novel)));
    }
    return figures;
}

ReproducedTable reproduce(int number, const std::vector<PaperExperimentOutcome> &outcomes)
{
    ReproducedTable table{paperTable(number), experimentOf(number), {}};
    const std::vector<PaperCheck> checks = checkPaperTable(table.printed);
    auto check = checks.begin();
    for (const PrintedRow &printed : table.printed.rows) {
        ReproducedRow row{printed.run, printed.axis, {}};
        for (std::size_t c = 0; c < table.printed.columns.size(); ++c) {
            const PaperColumn &column = table.printed.columns[c];
            ReproducedCell cell{printed.figure(c), {}, simulatedFigures(outcomes, number, printed, column)};
            if (column.kind != PaperColumnKind::Msd)
                cell.check = *check++;
            row.cells.push_back(std::move(cell));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace

Reproduction assembleReproduction(const std::vector<int> &tables, std::uint64_t seed,
                                  std::vector<PaperExperimentOutcome> outcomes)
{
    Reproduction reproduction;
    reproduction.seed = seed;
    const auto chosen = [&](int table) {
        return std::find(tables.begin(), tables.end(), table) != tables.end();
    };
    for (const int number : tables) {
        reproduction.tables.push_back(reproduce(number, outcomes));
        for (const PaperCheck &check : checkPaperTable(paperTable(number)))
            reproduction.checks.push_back(check);
    }
    for (const PaperStatement &statement : checkPaperStatements()) {
        bool all = true;
        for (int table = statement.firstTable; table <= statement.lastTable; ++table)
            all = all && chosen(table);
        if (all)
            reproduction.statements.push_back(statement);
    }
    for (const UnseenRunBound &bound : rowsBelowUnseenRunBound()) {
        if (chosen(bound.table))
            reproduction.belowBound.push_back(bound);
    }
    for (const PaperExperimentOutcome &outcome : outcomes)
        reproduction.summaries.push_back(summarise(outcome));
    reproduction.outcomes = std::move(outcomes);
    return reproduction;
}

bool dependsOnNovel(const PaperColumn &column)
{
    return column.role == PaperRole::Novel;
}

std::string rowName(const ReproducedTable &table, const ReproducedRow &row)
{
    return table.printed.number == 1 ? "run " + std::to_string(row.run + 1)
                                     : std::string(kAxisNames[static_cast<std::size_t>(row.axis)]);
}

std::string cellName(const PaperCheck &check)
{
    const std::string row = check.table == 1
                                ? "run " + std::to_string(check.row.run + 1)
                                : std::string(kAxisNames[static_cast<std::size_t>(check.row.axis)]);
    return "Table " + std::to_string(check.table) + ", " + row + ", " + std::string(check.column.name);
}

} // namespace driftbench::cli
