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

} // namespace driftbench
