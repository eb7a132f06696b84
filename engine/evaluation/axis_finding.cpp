#include "engine/evaluation/axis_finding.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr double kNegligibleShareOfFloor = 0.02; // as in verdict.h

const ComparisonRow *constantRow(const std::vector<ComparisonRow> &rows, const ComparisonRow &of)
{
    const auto found = std::find_if(rows.begin(), rows.end(), [&of](const ComparisonRow &row) {
        return row.model == "constant" && row.run == of.run && row.axis == of.axis;
    });
    return found == rows.end() ? nullptr : &*found;
}

RunLeft leftOf(const ComparisonRow &row, const ComparisonRow *constant, std::optional<double> limitDps)
{
    RunLeft left;
    left.run = row.run;
    left.leftDps = std::sqrt(row.msdAfter);
    left.noiseDps = std::sqrt(row.noiseFloor);
    left.withinLimit = !limitDps || left.leftDps <= *limitDps;
    if (constant != nullptr) {
        left.constantDps = std::sqrt(constant->msdAfter);
        const double floor = std::isfinite(row.noiseFloor) ? row.noiseFloor : 0.0;
        left.constantIsBetter = row.msdAfter > constant->msdAfter + kNegligibleShareOfFloor * floor;
    }
    return left;
}

Verdict byLimit(const AxisFinding &finding)
{
    if (finding.passing() < finding.runs.size())
        return Verdict::NotRepeatable;
    return finding.losing() > 0 ? Verdict::WithCare : Verdict::Yes;
}

} // namespace

std::size_t AxisFinding::passing() const
{
    return static_cast<std::size_t>(
        std::count_if(runs.begin(), runs.end(), [](const RunLeft &run) { return run.withinLimit; }));
}

std::size_t AxisFinding::losing() const
{
    return static_cast<std::size_t>(
        std::count_if(runs.begin(), runs.end(), [](const RunLeft &run) { return run.constantIsBetter; }));
}

std::string judgedModel(const AxisVerdict &verdict, const std::string &fallback)
{
    return verdict.model.empty() || verdict.model == "constant" ? fallback : verdict.model;
}

AxisFinding findAxis(const std::vector<ComparisonRow> &rows, int axis, const std::string &model,
                     Verdict judged, std::optional<double> limitDps)
{
    AxisFinding finding;
    finding.axis = axis;
    finding.model = model;
    finding.limitDps = limitDps;
    for (const ComparisonRow &row : rows) {
        if (row.axis == axis && row.model == model)
            finding.runs.push_back(leftOf(row, constantRow(rows, row), limitDps));
    }
    finding.verdict = judged;
    if (judged == Verdict::NotRepeatable || finding.runs.empty())
        return finding;
    const Verdict limited = byLimit(finding);
    // An axis without drift needs no table, and stays so; only a limit that nothing meets overrides it.
    if (judged == Verdict::NoDrift) {
        if (limited == Verdict::NotRepeatable)
            finding.verdict = Verdict::NotRepeatable;
        return finding;
    }
    if (limited == Verdict::NotRepeatable || (limited == Verdict::WithCare && judged == Verdict::Yes))
        finding.verdict = limited;
    return finding;
}

} // namespace driftbench
