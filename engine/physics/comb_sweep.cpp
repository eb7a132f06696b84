#include "engine/physics/comb_sweep.h"

#include "engine/base/text.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

Status checkRange(const CombSweepRange &range)
{
    if (!std::isfinite(range.lowestC) || !std::isfinite(range.highestC) || range.lowestC >= range.highestC)
        return Error{Errc::InvalidOption, "The range of temperature goes from " + shortest(range.lowestC) +
                                              " to " + shortest(range.highestC) +
                                              " °C; give a lowest temperature below the highest."};
    if (!(range.stepC > 0.0) || !std::isfinite(range.stepC))
        return Error{Errc::InvalidOption,
                     "The step of temperature is " + shortest(range.stepC) + " °C; give more than 0."};
    if ((range.highestC - range.lowestC) / range.stepC > static_cast<double>(kMostCombRows - 2))
        return Error{Errc::InvalidOption, "A step of " + shortest(range.stepC) + " °C gives more than " +
                                              std::to_string(kMostCombRows) + " rows; give a larger one."};
    return {};
}

std::vector<double> temperaturesOf(const CombSweepRange &range)
{
    std::vector<double> temperaturesC;
    for (std::size_t i = 0;; ++i) {
        const double temperatureC = range.lowestC + static_cast<double>(i) * range.stepC;
        if (temperatureC >= range.highestC - 1e-9 * range.stepC)
            break;
        temperaturesC.push_back(temperatureC);
    }
    temperaturesC.push_back(range.highestC);
    return temperaturesC;
}

} // namespace

Result<CombSweep> sweepComb(const CombCapacitor &comb, const CombTransducer &transducer,
                            const CombSweepRange &range)
{
    if (const Status ok = checkRange(range); !ok)
        return ok.error();
    const auto scale = scaleFactorFfPerDps(comb, transducer);
    if (!scale)
        return scale.error();
    const double displacementUm = transducer.restDisplacementUm;
    CombSweep sweep;
    sweep.scaleFactorFfPerDps = *scale;
    sweep.contactC = comb.contactTemperatureC(std::max(displacementUm, 0.0));
    const auto restChangeFf = comb.restChangeFf(displacementUm);
    if (!restChangeFf)
        return restChangeFf.error();
    for (const double temperatureC : temperaturesOf(range)) {
        const double deltaTC = temperatureC - comb.parameters().straightAtC;
        const auto changeFf = comb.changeFf(deltaTC, displacementUm);
        const auto errorFf = comb.errorFf(deltaTC, displacementUm);
        if (!changeFf || !errorFf) {
            if (sweep.rows.empty() || temperatureC < sweep.contactC)
                return changeFf.error();
            sweep.endsAtContact = true;
            break;
        }
        CombRow row{temperatureC,
                    deltaTC,
                    *restChangeFf,
                    *changeFf,
                    *errorFf,
                    equivalentRateDps(*errorFf, *scale),
                    {}};
        if (const auto printed = comb.changeFf(deltaTC, displacementUm, CombFormula::AsPrinted); printed)
            row.printedChangeFfUm = *printed;
        sweep.rows.push_back(row);
    }
    return sweep;
}

} // namespace driftbench
