#include "engine/evaluation/paper_statements.h"

#include "engine/base/axes.h"
#include "engine/evaluation/paper_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace driftbench {

namespace {

double meanImprovement(int firstTable, int lastTable, PaperRole role, PaperRole against)
{
    const PaperColumn column{"", PaperColumnKind::Improvement, role, against};
    double sum = 0.0;
    int rows = 0;
    for (int number = firstTable; number <= lastTable; ++number) {
        const PaperTable table = paperTable(number);
        for (const PrintedRow &row : table.rows) {
            sum += column.of(table.msds(row));
            ++rows;
        }
    }
    return sum / rows;
}

double leastOrders(int firstTable, int lastTable)
{
    const PaperColumn column{"", PaperColumnKind::Ratio, PaperRole::Novel};
    double least = std::numeric_limits<double>::infinity();
    for (int number = firstTable; number <= lastTable; ++number) {
        const PaperTable table = paperTable(number);
        for (const PrintedRow &row : table.rows)
            least = std::min(least, -std::log10(column.of(table.msds(row))));
    }
    return least;
}

// One axis of all runs of an experiment.
struct AxisRun
{
    int table = 0;
    int run = 0;
    double before = 0.0; // dps^2
    double novel = 0.0;
};

std::vector<AxisRun> runsOnAxis(int firstTable, int lastTable, int axis)
{
    std::vector<AxisRun> runs;
    for (int number = firstTable; number <= lastTable; ++number) {
        const PaperTable table = paperTable(number);
        for (const PrintedRow &row : table.rows) {
            const MsdByRole msds = table.msds(row);
            if (row.axis == axis)
                runs.push_back({number, row.run, msds[static_cast<std::size_t>(PaperRole::Before)],
                                msds[static_cast<std::size_t>(PaperRole::Novel)]});
        }
    }
    return runs;
}

double leastOnUnseen(const std::vector<AxisRun> &runs, std::size_t unseen)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < runs.size(); ++i)
        sum += i == unseen ? 0.0 : std::sqrt(runs[i].before);
    const double others = sum / static_cast<double>(runs.size() - 1);
    const double own = std::sqrt(runs[unseen].before - runs[unseen].novel);
    return own > others ? (own - others) * (own - others) : 0.0;
}

} // namespace

std::vector<PaperStatement> checkPaperStatements()
{
    using enum PaperRole;
    constexpr int kFirst = 2; // of the tables on three axes
    constexpr int kLast = kPaperTableCount;
    constexpr std::string_view kOrders = "orders of magnitude";
    return {
        {"Table 1: Novel better than Conventional 2, mean", "%", 10.5,
         meanImprovement(1, 1, Novel, Conventional2), 1, 1},
        {"Table 1: MSD1 over MSD3, least", kOrders, 4.0, leastOrders(1, 1), 1, 1},
        {"Tables 2-6: Conventional 2 better than Conventional 1, mean", "%", 15.0,
         meanImprovement(kFirst, kLast, Conventional2, Conventional1), kFirst, kLast},
        {"Tables 2-6: Novel better than Conventional 1, mean", "%", 15.0,
         meanImprovement(kFirst, kLast, Novel, Conventional1), kFirst, kLast},
        {"Tables 2-6: Novel better than Conventional 2, mean", "%", 5.0,
         meanImprovement(kFirst, kLast, Novel, Conventional2), kFirst, kLast},
        {"Tables 2-6: MSD1 over MSD6, least", kOrders, 2.0, leastOrders(kFirst, kLast), kFirst, kLast},
    };
}

std::vector<UnseenRunBound> rowsBelowUnseenRunBound()
{
    std::vector<UnseenRunBound> bounds;
    for (const auto &[firstTable, lastTable] : {std::pair{1, 1}, std::pair{2, kPaperTableCount}}) {
        for (int axis = 0; axis < kAxisCount; ++axis) {
            const std::vector<AxisRun> runs = runsOnAxis(firstTable, lastTable, axis);
            for (std::size_t i = 0; i < runs.size(); ++i) {
                const double least = leastOnUnseen(runs, i);
                if (least > runs[i].novel)
                    bounds.push_back({runs[i].table, runs[i].run, axis, least, runs[i].novel});
            }
        }
    }
    std::stable_sort(bounds.begin(), bounds.end(),
                     [](const UnseenRunBound &a, const UnseenRunBound &b) { return a.table < b.table; });
    return bounds;
}

} // namespace driftbench
