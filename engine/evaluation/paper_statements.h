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

} // namespace driftbench
