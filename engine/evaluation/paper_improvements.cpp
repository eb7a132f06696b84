#include "engine/evaluation/paper_improvements.h"

#include "engine/base/statistics.h"

#include <algorithm>

namespace driftbench {

namespace {

void derive(PaperRow &row)
{
    row.q3 = row.msd4 / row.msd1;
    row.q4 = row.msd5 / row.msd1;
    row.q5 = row.msd6 / row.msd1;
    row.q4AgainstQ3 = (row.q3 - row.q4) / row.q3;
    row.q5AgainstQ3 = (row.q3 - row.q5) / row.q3;
    row.q5AgainstQ4 = (row.q4 - row.q5) / row.q4;
}

} // namespace

std::vector<PaperRow> paperImprovements(const std::vector<ComparisonRow> &rows, const PaperModels &models)
{
    std::vector<PaperRow> table;
    for (const ComparisonRow &row : rows) {
        auto found = std::find_if(table.begin(), table.end(), [&](const PaperRow &candidate) {
            return candidate.run == row.run && candidate.axis == row.axis;
        });
        if (found == table.end()) {
            PaperRow fresh;
            fresh.run = row.run;
            fresh.axis = row.axis;
            fresh.msd1 = row.msdBefore;
            fresh.msd4 = fresh.msd5 = fresh.msd6 = kNaN;
            found = table.insert(table.end(), fresh);
        }
        if (row.model == models.conventional1)
            found->msd4 = row.msdAfter;
        if (row.model == models.conventional2)
            found->msd5 = row.msdAfter;
        if (row.model == models.novel)
            found->msd6 = row.msdAfter;
    }
    for (PaperRow &row : table)
        derive(row);
    return table;
}

} // namespace driftbench
