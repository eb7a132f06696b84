#include "engine/physics/comb_drift.h"

#include "engine/base/text.h"
#include "engine/physics/comb_transducer.h"

#include <cmath>
#include <limits>

namespace driftbench {

namespace {

struct CombAxisCurve
{
    CombCapacitor combs;
    PackageTerm package;
    double displacementUm;
    double scaleFfPerDps; // S

    double operator()(double temperatureC) const
    {
        const double deltaTC = temperatureC - combs.parameters().straightAtC;
        const auto errorFf = combs.errorFf(deltaTC, displacementUm);
        if (!errorFf)
            return std::numeric_limits<double>::quiet_NaN();
        return equivalentRateDps(*errorFf, scaleFfPerDps) +
               package.stepDps * std::tanh((temperatureC - package.stepAtC) / package.stepWidthC);
    }
};

Status checkPositive(std::string_view what, double value, std::string_view unit)
{
    if (std::isfinite(value) && value > 0.0)
        return {};
    return invalidOption("The " + std::string(what) + " is " + shortest(value) + std::string(unit) +
                         "; give more than 0.");
}

Status checkAxis(const CombAxis &axis, double referenceRateDps, std::string_view name)
{
    for (const double figure : {axis.restDps, axis.package.stepDps, axis.package.stepAtC, referenceRateDps}) {
        if (!std::isfinite(figure))
            return invalidOption("A figure of the comb drift on " + std::string(name) + " is " +
                                 shortest(figure) + "; give finite rates and temperatures.");
    }
    return checkPositive("width of the package term on " + std::string(name), axis.package.stepWidthC, " °C");
}

} // namespace

Result<DriftCurves> combDriftCurves(const CombDrift &drift, const Eigen::Vector3d &referenceRateDps)
{
    if (const Status ok =
            checkPositive("displacement of the combs by one dps", drift.displacementPerDpsUm, " µm");
        !ok)
        return ok.error();
    DriftCurves curves;
    curves.name = kCombDriftName;
    for (int i = 0; i < kAxisCount; ++i) {
        const CombAxis &axis = drift.axes[i];
        if (const Status ok = checkAxis(axis, referenceRateDps[i], kAxisNames[i]); !ok)
            return ok.error();
        const auto combs = CombCapacitor::create(axis.combs);
        if (!combs)
            return combs.error();
        const auto scaleFfPerDps = scaleFactorFfPerDps(*combs, {drift.displacementPerDpsUm, 0.0});
        if (!scaleFfPerDps)
            return scaleFfPerDps.error();
        curves.rateDps[i] =
            CombAxisCurve{*combs, axis.package,
                          (axis.restDps + referenceRateDps[i]) * drift.displacementPerDpsUm, *scaleFfPerDps};
    }
    return curves;
}

} // namespace driftbench
