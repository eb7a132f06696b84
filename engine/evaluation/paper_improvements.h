// The paper's Tables 2 to 6: MSDs, their ratios and how much one model improves on another.
#pragma once

#include "engine/evaluation/scoring.h"

#include <string>
#include <vector>

namespace driftbench {

// Which of the compared models stand for Conventional 1, Conventional 2 and Novel.
struct PaperModels
{
    std::string conventional1 = "linear";
    std::string conventional2 = "bpnn";
    std::string novel = "rbf";
};

// One run and axis. NaN where a model is not among the rows.
struct PaperRow
{
    std::string run;
    int axis = 0;
    double msd1 = 0.0; // dps^2, before
    double msd4 = 0.0; // Conventional 1
    double msd5 = 0.0; // Conventional 2
    double msd6 = 0.0; // Novel
    double q3 = 0.0;   // MSD4 / MSD1 (Eq. 34)
    double q4 = 0.0;
    double q5 = 0.0;
    // The paper's |Q4 - Q3| / Q3 and so on with the sign kept: positive where the first named is better.
    double q4AgainstQ3 = 0.0; // (Q3 - Q4) / Q3
    double q5AgainstQ3 = 0.0;
    double q5AgainstQ4 = 0.0;
};

// In the order of the rows' runs and axes.
std::vector<PaperRow> paperImprovements(const std::vector<ComparisonRow> &rows,
                                        const PaperModels &models = {});

} // namespace driftbench
