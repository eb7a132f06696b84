// What `reproduce` shows, before it becomes text, Markdown, CSV or JSON.
#pragma once

#include "app/campaign/paper_experiments.h"
#include "app/campaign/paper_summary.h"
#include "engine/evaluation/paper_statements.h"
#include "engine/evaluation/paper_tables.h"

#include <optional>
#include <string>
#include <vector>

namespace driftbench::cli {

// A cell of a table: the printed figure, and ours beside it.
struct ReproducedCell
{
    PrintedFigure printed;
    std::optional<PaperCheck> check; // none of an MSD
    std::vector<double> simulated;   // a figure for each of kNovelModels; none if nothing was simulated
};

struct ReproducedRow
{
    int run = 0;
    int axis = 0;
    std::vector<ReproducedCell> cells;
};

struct ReproducedTable
{
    PaperTable printed;
    const PaperExperiment *experiment = nullptr;
    std::vector<ReproducedRow> rows;
};

struct Reproduction
{
    std::uint64_t seed = 0;
    std::vector<PaperExperimentOutcome> outcomes; // none if only the arithmetic was checked
    std::vector<ExperimentSummary> summaries;
    std::vector<ReproducedTable> tables;
    std::vector<PaperCheck> checks; // of these tables
    std::vector<PaperStatement> statements;
    std::vector<UnseenRunBound> belowBound;

    bool simulated() const { return !outcomes.empty(); }
};

// Of these tables (1 to 6, in order) and what was simulated for them.
Reproduction assembleReproduction(const std::vector<int> &tables, std::uint64_t seed,
                                  std::vector<PaperExperimentOutcome> outcomes);

// Whether the column has another figure with another Novel.
bool dependsOnNovel(const PaperColumn &column);

// "run 3" in Table 1, "x" in the others.
std::string rowName(const ReproducedTable &table, const ReproducedRow &row);
// "Table 4, z, |Q4-Q3|/Q3"; "Table 1, run 2, Q2".
std::string cellName(const PaperCheck &check);

// Captions and findings in sentences; nothing in them is known beforehand but the names of the models.
std::string captionOf(const ReproducedTable &table);
std::vector<std::string> howItWasDone(const Reproduction &reproduction);
std::vector<std::string> findingsOfArithmetic(const Reproduction &reproduction);
std::vector<std::string> findingsOfSimulation(const Reproduction &reproduction);

} // namespace driftbench::cli
