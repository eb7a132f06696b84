#include "app/cli/reproduce_text.h"

#include "app/cli/text_layout.h"
#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <algorithm>

namespace driftbench::cli {

namespace {

constexpr std::size_t kFirstColumn = 17;
constexpr std::size_t kRowName = 6; // of the first column

std::string heading(const std::string &text)
{
    return "\n" + text + "\n" + std::string(widthOf(text), '-') + "\n";
}

// Wide enough for a printed figure of this column and the mark behind it.
std::size_t columnWidth(const PaperColumn &column)
{
    switch (column.kind) {
    case PaperColumnKind::Msd:
        return 10;
    case PaperColumnKind::Ratio:
        return 11;
    case PaperColumnKind::Improvement:
        return 10;
    }
    return 0;
}

// "|Q4-Q3|/Q3" on two lines: the column is too narrow for it and its unit.
std::string headOf(const ReproducedTable &table)
{
    std::string names(kFirstColumn, ' ');
    std::string units(kFirstColumn, ' ');
    for (const PaperColumn &column : table.printed.columns) {
        const std::string name(column.name);
        const std::size_t slash = std::min(name.find('/'), name.size());
        const std::string unit = column.kind == PaperColumnKind::Msd ? "dps²" : std::string(column.unit());
        const std::string below = slash < name.size() ? name.substr(slash) + " " + unit : unit;
        names += right(name.substr(0, slash), columnWidth(column) - 1) + " ";
        units += right(below, columnWidth(column) - 1) + " ";
    }
    names.erase(names.find_last_not_of(' ') + 1);
    units.erase(units.find_last_not_of(' ') + 1);
    return names + "\n" + units + "\n";
}

std::string printedLine(const ReproducedTable &table, const ReproducedRow &row)
{
    std::string line = left(rowName(table, row), kRowName) + left("printed", kFirstColumn - kRowName);
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
        const ReproducedCell &cell = row.cells[c];
        const bool disagrees = cell.check && cell.check->agreement == PrintedAgreement::No;
        line += right(std::string(cell.printed.text()) + (disagrees ? "*" : " "),
                      columnWidth(table.printed.columns[c]));
    }
    return line;
}

// novel: index into kNovelModels. What another Novel does not change is left out of its line.
std::string simulatedLine(const ReproducedTable &table, const ReproducedRow &row, std::size_t novel)
{
    const std::string label = novel == 0 ? "simulated" : "with " + std::string(kNovelModels[novel]);
    std::string line = std::string(kRowName, ' ') + left(label, kFirstColumn - kRowName);
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
        const ReproducedCell &cell = row.cells[c];
        const PaperColumn &column = table.printed.columns[c];
        const bool shown = novel == 0 || dependsOnNovel(column);
        line += right(shown ? cell.printed.inThisForm(cell.simulated[novel]) + " " : "", columnWidth(column));
    }
    return line;
}

std::string withoutTrailing(std::string line)
{
    return line.erase(line.find_last_not_of(' ') + 1) + "\n";
}

std::string tableAsText(const ReproducedTable &table)
{
    std::string text = "\n" + wrapped("", captionOf(table)) + headOf(table);
    for (const ReproducedRow &row : table.rows) {
        text += withoutTrailing(printedLine(table, row));
        for (std::size_t novel = 0; novel < row.cells.front().simulated.size(); ++novel)
            text += withoutTrailing(simulatedLine(table, row, novel));
    }
    return text;
}

std::string checkLine(const PaperCheck &check)
{
    const auto form = [&](double value) { return check.printed.inThisForm(value); };
    const std::string unit(check.column.unit());
    return "  " + left(cellName(check), 30) + right(std::string(check.printed.text()), 12) +
           right(form(check.recomputed), 12) +
           right(form(check.possible.lowest) + " .. " + form(check.possible.highest), 24) + " " + unit;
}

std::string checkList(const std::vector<PaperCheck> &checks, PrintedAgreement agreement,
                      const std::string &title)
{
    std::string lines;
    for (const PaperCheck &check : checks) {
        if (check.agreement == agreement)
            lines += withoutTrailing(checkLine(check));
    }
    if (lines.empty())
        return {};
    return "\n" + left(title, 32) + right("printed", 12) + right("recomputed", 12) +
           right("rounding allows", 24) + "\n" + lines;
}

std::string statementList(const std::vector<PaperStatement> &statements)
{
    if (statements.empty())
        return {};
    std::string text =
        "\n" + left("What the paper's text says", 64) + right("text", 10) + right("tables", 10) + "\n";
    for (const PaperStatement &statement : statements)
        text += "  " + left(statement.about, 62) + right(fixed(statement.stated, 1), 10) +
                right(fixed(statement.fromTables, 1), 10) + " " + std::string(statement.unit) + "\n";
    return text;
}

std::string arithmetic(const Reproduction &reproduction)
{
    std::string text = heading("Arithmetic of the printed tables");
    for (const std::string &finding : findingsOfArithmetic(reproduction))
        text += wrapped("- ", finding);
    text += checkList(reproduction.checks, PrintedAgreement::No, "Cells that do not agree (*)");
    text += checkList(reproduction.checks, PrintedAgreement::WithinRounding, "Cells off within rounding");
    return text + statementList(reproduction.statements);
}

std::string excessTable(const ExperimentSummary &summary)
{
    std::string text = left(summary.sensor, kFirstColumn) + right("before", 12) + right("floor", 12);
    for (const ModelOnAxis &model : summary.axes.front().models)
        text += right(model.model, 12);
    text += "\n";
    for (const AxisSummary &axis : summary.axes) {
        const std::string name(kAxisNames[static_cast<std::size_t>(axis.axis)]);
        text += left(name + "  MSD, dps²", kFirstColumn) + right(fixed(axis.msdBefore, 4), 12) +
                right(fixed(axis.floor, 5), 12);
        std::string excess = left("   over floor, %", kFirstColumn + 24);
        for (const ModelOnAxis &model : axis.models) {
            text += right(fixed(model.msd, 5), 12);
            excess += right(fixed(100.0 * model.excessOverFloor, 2), 12);
        }
        text += "\n" + excess + "\n";
    }
    return text;
}

std::string improvementTable(const std::vector<ExperimentSummary> &summaries)
{
    const auto roleName = [](PaperRole role) {
        return role == PaperRole::Conventional1   ? "Conventional 1"
               : role == PaperRole::Conventional2 ? "Conventional 2"
                                                  : "Novel";
    };
    std::string text =
        left("Mean improvement, %", 56) + right("printed", 12) + right("simulated ± s.e.", 22) + "\n";
    for (const ExperimentSummary &summary : summaries) {
        for (const ImprovementSummary &one : summary.improvements) {
            const std::string model = one.role == PaperRole::Novel ? " (" + one.model + ")" : "";
            text += left(summary.sensor + " " + std::string(kAxisNames[static_cast<std::size_t>(one.axis)]) +
                             ": " + roleName(one.role) + model + " on " + roleName(one.against),
                         56) +
                    right(fixed(one.printed, 2), 12) + right(fixed(one.simulated, 2), 14) + " ± " +
                    fixed(one.standardError, 2) + "\n";
        }
    }
    return text;
}

std::string simulation(const Reproduction &reproduction)
{
    std::string text = heading("What the simulated runs show");
    for (const std::string &finding : findingsOfSimulation(reproduction))
        text += wrapped("- ", finding);
    text += "\nMeans of five unseen runs; floor: what no function of temperature can remove.\n";
    for (const ExperimentSummary &summary : reproduction.summaries)
        text += excessTable(summary);
    return text + "\n" + improvementTable(reproduction.summaries);
}

} // namespace

std::string reproductionToText(const Reproduction &reproduction)
{
    if (!reproduction.simulated())
        return arithmetic(reproduction).substr(1);
    std::string text;
    for (const std::string &sentence : howItWasDone(reproduction))
        text += wrapped("", sentence);
    for (const ReproducedTable &table : reproduction.tables)
        text += tableAsText(table);
    return text + arithmetic(reproduction) + simulation(reproduction);
}

} // namespace driftbench::cli
