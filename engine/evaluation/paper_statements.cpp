#include "engine/evaluation/paper_statements.h"

#include "engine/evaluation/paper_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

} // namespace driftbench
