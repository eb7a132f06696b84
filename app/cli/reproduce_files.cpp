#include "app/cli/reproduce_files.h"

#include "app/cli/pending_files.h"
#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string axisName(int axis)
{
    return std::string(kAxisNames[static_cast<std::size_t>(axis)]);
}

Json checkToJson(const PaperCheck &check)
{
    return {{"table", check.table},
            {"run", check.row.run + 1},
            {"axis", axisName(check.row.axis)},
            {"column", std::string(check.column.name)},
            {"unit", std::string(check.column.unit())},
            {"printed", check.printed.value()},
            {"recomputed", check.recomputed},
            {"lowest_possible", check.possible.lowest},
            {"highest_possible", check.possible.highest},
            {"agreement", std::string(agreementName(check.agreement))}};
}

Json rowToJson(const ReproducedTable &table, const ReproducedRow &row)
{
    Json printed;
    std::vector<Json> simulated(row.cells.front().simulated.size());
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
        const std::string name(table.printed.columns[c].name);
        printed[name] = row.cells[c].printed.value();
        for (std::size_t novel = 0; novel < simulated.size(); ++novel)
            simulated[novel][name] = row.cells[c].simulated[novel];
    }
    Json json{{"run", row.run + 1}, {"axis", axisName(row.axis)}, {"printed", printed}};
    for (std::size_t novel = 0; novel < simulated.size(); ++novel)
        json["simulated"][std::string(kNovelModels[novel])] = simulated[novel];
    return json;
}

Json tableToJson(const ReproducedTable &table)
{
    Json columns = Json::array();
    for (const PaperColumn &column : table.printed.columns)
        columns.push_back({{"name", std::string(column.name)}, {"unit", std::string(column.unit())}});
    Json rows = Json::array();
    for (const ReproducedRow &row : table.rows)
        rows.push_back(rowToJson(table, row));
    return {{"number", table.printed.number},
            {"sensor", table.experiment->sensor},
            {"columns", columns},
            {"rows", rows}};
}

Json summaryToJson(const ExperimentSummary &summary)
{
    Json axes = Json::array();
    for (const AxisSummary &axis : summary.axes) {
        Json models = Json::array();
        for (const ModelOnAxis &model : axis.models)
            models.push_back({{"model", model.model},
                              {"msd_dps2", model.msd},
                              {"excess_over_floor", model.excessOverFloor}});
        axes.push_back({{"axis", axisName(axis.axis)},
                        {"msd_before_dps2", axis.msdBefore},
                        {"noise_floor_dps2", axis.floor},
                        {"models", models}});
    }
    return {{"sensor", summary.sensor}, {"axes", axes}};
}

Json experimentToJson(const PaperExperimentOutcome &outcome)
{
    const Eigen::Vector3d &rate = outcome.experiment.referenceRateDps;
    return {{"sensor", outcome.experiment.sensor},
            {"seed", outcome.seed},
            {"reference_rate_dps", {rate[0], rate[1], rate[2]}},
            {"runs", kPaperRuns},
            {"judged", "each run by models trained on the others, absolute"},
            {"conventional_1", std::string(kConventional1Model)},
            {"conventional_2", std::string(kConventional2Model)},
            {"novel", kNovelModels}};
}

std::string csvLine(const ReproducedTable &table, const ReproducedRow &row, std::size_t c)
{
    const ReproducedCell &cell = row.cells[c];
    const PaperColumn &column = table.printed.columns[c];
    std::string line = std::to_string(table.printed.number) + "," + std::to_string(row.run + 1) + "," +
                       axisName(row.axis) + "," + std::string(column.name) + "," +
                       std::string(column.unit()) + "," + std::string(cell.printed.text());
    if (cell.check)
        line += "," + shortest(cell.check->recomputed) + "," + shortest(cell.check->possible.lowest) + "," +
                shortest(cell.check->possible.highest) + "," +
                std::string(agreementName(cell.check->agreement));
    else
        line += ",,,,";
    for (std::size_t novel = 0; novel < kNovelModels.size(); ++novel)
        line += "," + (cell.simulated.empty() ? std::string() : shortest(cell.simulated[novel]));
    return line + "\n";
}

} // namespace

Json reproductionToJson(const Reproduction &reproduction)
{
    Json json{{"simulated", reproduction.simulated()}};
    if (reproduction.simulated()) {
        json["how"] = howItWasDone(reproduction);
        json["experiments"] = Json::array();
        for (const PaperExperimentOutcome &outcome : reproduction.outcomes)
            json["experiments"].push_back(experimentToJson(outcome));
    }
    json["tables"] = Json::array();
    for (const ReproducedTable &table : reproduction.tables)
        json["tables"].push_back(tableToJson(table));
    json["checks"] = Json::array();
    for (const PaperCheck &check : reproduction.checks)
        json["checks"].push_back(checkToJson(check));
    json["statements"] = Json::array();
    for (const PaperStatement &statement : reproduction.statements)
        json["statements"].push_back({{"about", statement.about},
                                      {"unit", std::string(statement.unit)},
                                      {"stated", statement.stated},
                                      {"from_tables", statement.fromTables}});
    json["findings_of_arithmetic"] = findingsOfArithmetic(reproduction);
    if (reproduction.simulated()) {
        json["summaries"] = Json::array();
        for (const ExperimentSummary &summary : reproduction.summaries)
            json["summaries"].push_back(summaryToJson(summary));
        json["findings_of_simulation"] = findingsOfSimulation(reproduction);
    }
    return json;
}

std::string reproductionToCsv(const Reproduction &reproduction)
{
    std::string text =
        "table,run,axis,column,unit,printed,recomputed,lowest_possible,highest_possible,agreement";
    for (const std::string_view novel : kNovelModels)
        text += ",simulated_" + std::string(novel);
    text += "\n";
    for (const ReproducedTable &table : reproduction.tables) {
        for (const ReproducedRow &row : table.rows) {
            for (std::size_t c = 0; c < row.cells.size(); ++c)
                text += csvLine(table, row, c);
        }
    }
    return text;
}

Status writeReproduction(const Reproduction &reproduction, const std::filesystem::path &folder)
{
    PendingFiles files;
    if (Status added = files.add(folder / "tables.md", reproductionToMarkdown(reproduction)); !added)
        return added;
    if (Status added = files.add(folder / "tables.csv", reproductionToCsv(reproduction)); !added)
        return added;
    if (Status added = files.add(folder / "tables.json", reproductionToJson(reproduction).dump(2) + "\n");
        !added)
        return added;
    return files.commit();
}

} // namespace driftbench::cli
