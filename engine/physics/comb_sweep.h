// The combs over a range of temperature: one row per temperature, up to where they touch.
//
// Errors: Errc::InvalidOption for a range that is empty or not finite, a step that is not positive, more than
// kMostCombRows rows, or combs that touch already at the first temperature.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/comb_capacitor.h"
#include "engine/physics/comb_transducer.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace driftbench {

inline constexpr std::size_t kMostCombRows = 100'000;

struct CombSweepRange
{
    double lowestC = -40.0;
    double highestC = 85.0;
    double stepC = 5.0;
};

struct CombRow
{
    double temperatureC = 0.0;
    double deltaTC = 0.0;
    double restChangeFf = 0.0;               // dC, the same in all rows
    double changeFf = 0.0;                   // dC'
    double errorFf = 0.0;                    // dE
    double rateDps = 0.0;                    // that dE is taken for
    std::optional<double> printedChangeFfUm; // dC' of Eq. (10) as printed, where that has a value
};

struct CombSweep
{
    std::vector<CombRow> rows;
    double scaleFactorFfPerDps = 0.0;
    double contactC = 0.0;      // displaced, or at rest if that comes first
    bool endsAtContact = false; // the range goes on, the rows do not
};

// The displacement is the transducer's at rest; lowestC, lowestC + stepC ... and highestC itself.
Result<CombSweep> sweepComb(const CombCapacitor &comb, const CombTransducer &transducer,
                            const CombSweepRange &range);

} // namespace driftbench
