#include "app/cli/physics_study.h"

#include <algorithm>

namespace driftbench::cli {

namespace {

constexpr int kGapPoints = 101;
constexpr int kGapProfiles = 5;
// Of the way to contact: there the error grows without bound, and a curve up to it would show nothing else.
constexpr double kShareOfWayToContact = 0.9;

double endOfCurveC(const CombSweep &table, const CombSweepRange &range)
{
    if (!table.endsAtContact)
        return range.highestC;
    return std::max(table.rows.back().temperatureC,
                    range.lowestC + kShareOfWayToContact * (table.contactC - range.lowestC));
}

void explain(PhysicsStudy &study)
{
    const auto count = static_cast<Eigen::Index>(study.curve.rows.size());
    Eigen::VectorXd deltaTC(count);
    Eigen::VectorXd errorFf(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        deltaTC[i] = study.curve.rows[static_cast<std::size_t>(i)].deltaTC;
        errorFf[i] = study.curve.rows[static_cast<std::size_t>(i)].errorFf;
    }
    auto shares = explainedByQuantities(deltaTC, errorFf);
    if (shares)
        study.quantities = *std::move(shares);
    else
        study.nothingToExplain = shares.error().message;
}

void profileGaps(const CombCapacitor &comb, PhysicsStudy &study)
{
    const double lowestC = study.curve.rows.front().temperatureC;
    const double highestC = study.curve.rows.back().temperatureC;
    study.alongUm = Eigen::VectorXd::LinSpaced(kGapPoints, 0.0, comb.parameters().geometry.overlapLengthUm);
    for (int i = 0; i < kGapProfiles; ++i) {
        const double temperatureC = lowestC + (highestC - lowestC) * i / (kGapProfiles - 1);
        const double deltaTC = temperatureC - comb.parameters().straightAtC;
        study.gaps.push_back(
            {temperatureC, study.alongUm.unaryExpr([&](double xUm) { return comb.gapUm(deltaTC, xUm); })});
    }
}

} // namespace

Result<PhysicsStudy> studyPhysics(const PhysicsRequest &request)
{
    const auto comb = CombCapacitor::create(request.comb);
    if (!comb)
        return comb.error();
    auto table = sweepComb(*comb, request.transducer, request.range);
    if (!table)
        return table.error();
    PhysicsStudy study{};
    study.request = request;
    study.table = *std::move(table);
    const double lowestC = request.range.lowestC;
    const double highestC = endOfCurveC(study.table, request.range);
    auto curve =
        sweepComb(*comb, request.transducer, {lowestC, highestC, (highestC - lowestC) / (kCurvePoints - 1)});
    if (!curve)
        return curve.error();
    study.curve = *std::move(curve);
    study.sensitivitiesAtC = study.table.rows.back().temperatureC;
    const auto sensitivities =
        combSensitivities(*comb, study.table.rows.back().deltaTC, request.transducer.restDisplacementUm);
    if (!sensitivities)
        return sensitivities.error();
    study.sensitivities = *sensitivities;
    const double lengthUm = request.comb.geometry.overlapLengthUm;
    study.thinnestCombUm = std::min(comb->thicknessUm(study.table.rows.front().deltaTC, lengthUm),
                                    comb->thicknessUm(study.table.rows.back().deltaTC, lengthUm));
    explain(study);
    profileGaps(*comb, study);
    return study;
}

} // namespace driftbench::cli
