#include "engine/physics/comb_transducer.h"

#include "engine/base/text.h"

#include <cmath>

namespace driftbench {

Result<double> scaleFactorFfPerDps(const CombCapacitor &comb, const CombTransducer &transducer)
{
    const double perDps = transducer.displacementUmPerDps;
    if (!std::isfinite(perDps) || perDps == 0.0)
        return Error{Errc::InvalidOption, "The displacement per dps is " + shortest(perDps) +
                                              " µm; give one that is not 0, such as 0.001."};
    const auto restFf = comb.capacitanceFf(0.0, transducer.restDisplacementUm);
    if (!restFf)
        return restFf.error();
    return *restFf * perDps / (comb.parameters().geometry.gapUm - transducer.restDisplacementUm);
}

Result<DriftFunction> combDrift(const CombCapacitor &comb, const CombTransducer &transducer, double rateDps,
                                double lowestC, double highestC)
{
    const auto scale = scaleFactorFfPerDps(comb, transducer);
    if (!scale)
        return scale.error();
    const double displacementUm = transducer.restDisplacementUm + transducer.displacementUmPerDps * rateDps;
    for (const double endC : {lowestC, highestC}) {
        const auto errorFf = comb.errorFf(endC - comb.parameters().straightAtC, displacementUm);
        if (!errorFf)
            return errorFf.error();
    }
    return DriftFunction([comb, displacementUm, scaleFfPerDps = *scale](double temperatureC) {
        const auto errorFf = comb.errorFf(temperatureC - comb.parameters().straightAtC, displacementUm);
        return equivalentRateDps(*errorFf, scaleFfPerDps);
    });
}

} // namespace driftbench
