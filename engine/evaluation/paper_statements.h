// What the paper's text says about its tables, beside what the printed MSDs give.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

struct PaperStatement
{
    std::string about; // which figure of which tables, in our words
    std::string_view unit;
    double stated = 0.0;
    double fromTables = 0.0; // recomputed from the printed MSDs
    int firstTable = 0;      // that it is about
    int lastTable = 0;
};

// Mean improvements in %, and how far an MSD falls in orders of magnitude: log10(MSD before / after), the
// least of the rows.
std::vector<PaperStatement> checkPaperStatements();

// A row of the tables that no model trained on the other four runs can have left behind.
//
// Write |.| for the root mean square over a run, d_r for its drift and e for its noise, so that
// |d_r|^2 = MSD1 - |e|^2 and |e|^2 <= the least MSD after. What is trained on the others gives at best the
// mean m of their drifts, |m| <= the mean of their |d|, and leaves on run r
//   MSD after >= (|d_r| - |m|)^2    where |d_r| > |m|,
// provided that the runs went through the same temperatures.
struct UnseenRunBound
{
    int table = 0;
    int run = 0;
    int axis = 0;
    double least = 0.0;   // dps^2, the bound
    double printed = 0.0; // dps^2, MSD of Novel
};

// Of all rows those whose bound lies above the printed figure, in the order of the tables.
std::vector<UnseenRunBound> rowsBelowUnseenRunBound();

} // namespace driftbench
