#include "app/cli/reproduce_files.h"
#include "engine/base/text.h"

#include <array>

namespace driftbench::cli {

namespace {

// "3.7210e-3" as it is printed: 3.7210 × 10⁻³.
std::string typeset(const std::string &figure)
{
    static constexpr std::array<const char *, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    bool raised = false;
    for (const char c : figure) {
        if (c == 'e') {
            text += " × 10";
            raised = true;
        } else if (c == '-') {
            text += raised ? "⁻" : "−";
        } else {
            text += raised ? kDigits[static_cast<std::size_t>(c - '0')] : std::string(1, c);
        }
    }
    return text;
}

std::string line(const std::vector<std::string> &cells)
{
    std::string text = "|";
    for (const std::string &cell : cells)
        text += " " + cell + " |";
    return text + "\n";
}

std::string rule(std::size_t columns, std::size_t names)
{
    std::string text = "|";
    for (std::size_t i = 0; i < columns; ++i)
        text += i < names ? "---|" : "---:|";
    return text + "\n";
}

// A bar would end the cell; a minus is not a hyphen.
std::string withoutBars(std::string_view name)
{
    std::string text;
    for (const char c : name)
        text += c == '|' ? std::string("\\|") : c == '-' ? std::string("−") : std::string(1, c);
    return text;
}

std::string headOf(const PaperColumn &column)
{
    return withoutBars(column.name) + (column.kind == PaperColumnKind::Improvement ? " (%)" : "");
}

std::string rowText(const ReproducedTable &table, const ReproducedRow &row)
{
    std::vector<std::string> printed{rowName(table, row), "printed"};
    for (const ReproducedCell &cell : row.cells) {
        const bool disagrees = cell.check && cell.check->agreement == PrintedAgreement::No;
        printed.push_back(typeset(std::string(cell.printed.text())) + (disagrees ? " \\*" : ""));
    }
    std::string text = line(printed);
    for (std::size_t novel = 0; novel < row.cells.front().simulated.size(); ++novel) {
        std::vector<std::string> ours{"",
                                      novel == 0 ? "simulated" : "with " + std::string(kNovelModels[novel])};
        for (std::size_t c = 0; c < row.cells.size(); ++c) {
            const ReproducedCell &cell = row.cells[c];
            const bool shown = novel == 0 || dependsOnNovel(table.printed.columns[c]);
            ours.push_back(shown ? typeset(cell.printed.inThisForm(cell.simulated[novel])) : "");
        }
        text += line(ours);
    }
    return text;
}

std::string tableAsMarkdown(const ReproducedTable &table)
{
    std::vector<std::string> head{"", ""};
    for (const PaperColumn &column : table.printed.columns)
        head.push_back(headOf(column));
    std::string text = captionOf(table) + ".\n\n" + line(head) + rule(head.size(), 2);
    for (const ReproducedRow &row : table.rows)
        text += rowText(table, row);
    return text + "\n";
}

std::string checkTable(const std::vector<PaperCheck> &checks)
{
    std::string rows;
    for (const PaperCheck &check : checks) {
        if (check.agreement == PrintedAgreement::Exact)
            continue;
        const auto form = [&](double value) { return typeset(check.printed.inThisForm(value)); };
        rows +=
            line({withoutBars(cellName(check)), typeset(std::string(check.printed.text())),
                  form(check.recomputed), form(check.possible.lowest) + " to " + form(check.possible.highest),
                  std::string(agreementName(check.agreement))});
    }
    if (rows.empty())
        return {};
    return line({"cell", "printed", "recomputed", "rounding allows", "agrees"}) +
           "|---|---:|---:|---:|---|\n" + rows + "\n";
}

std::string list(const std::vector<std::string> &sentences)
{
    std::string text;
    for (const std::string &sentence : sentences)
        text += "- " + sentence + "\n";
    return text + "\n";
}

} // namespace

std::string reproductionToMarkdown(const Reproduction &reproduction)
{
    std::string text = "# The paper's Tables 1 to 6, printed and simulated\n\n";
    text += list(howItWasDone(reproduction));
    for (const ReproducedTable &table : reproduction.tables)
        text += tableAsMarkdown(table);
    text += "\\* does not follow from the printed MSDs.\n\n## Arithmetic of the printed tables\n\n";
    text += list(findingsOfArithmetic(reproduction)) + checkTable(reproduction.checks);
    if (!reproduction.statements.empty()) {
        text += line({"what the paper's text says", "text", "tables", "unit"}) + "|---|---:|---:|---|\n";
        for (const PaperStatement &statement : reproduction.statements)
            text += line({statement.about, fixed(statement.stated, 1), fixed(statement.fromTables, 1),
                          std::string(statement.unit)});
        text += "\n";
    }
    return text + "## What the simulated runs show\n\n" + list(findingsOfSimulation(reproduction));
}

} // namespace driftbench::cli
