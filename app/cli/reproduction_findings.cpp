#include "app/cli/reproduction.h"
#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <algorithm>
#include <cmath>

namespace driftbench::cli {

namespace {

// Of the noise floor: models nearer to each other, or to the floor, count as the same.
constexpr double kSameShare = 0.01;
// In %: an improvement that is smaller is none worth the name.
constexpr double kNoImprovement = 1.0;
constexpr double kPercent = 100.0;

struct Span
{
    double lowest = 0.0;
    double highest = 0.0;
};

Span spanOf(const std::vector<double> &values)
{
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    return {*lowest, *highest};
}

std::string listed(const std::vector<std::string> &names)
{
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

std::string fromTo(const Span &span, int decimals)
{
    const std::string lowest = forReading(span.lowest, decimals);
    const std::string highest = forReading(span.highest, decimals);
    return lowest == highest ? lowest : lowest + " to " + highest;
}

// All models but the straight line.
std::vector<std::string> networkNames()
{
    std::vector<std::string> names = paperModelNames();
    names.erase(std::remove(names.begin(), names.end(), kConventional1Model), names.end());
    return names;
}

std::vector<double> networkExcess(const AxisSummary &axis)
{
    std::vector<double> excess;
    for (const ModelOnAxis &model : axis.models) {
        if (model.model != kConventional1Model)
            excess.push_back(model.excessOverFloor);
    }
    return excess;
}

std::string nameOf(const ExperimentSummary &summary, const AxisSummary &axis)
{
    return summary.sensor + " " + std::string(kAxisNames[static_cast<std::size_t>(axis.axis)]);
}

const ImprovementSummary *improvementOf(const ExperimentSummary &summary, int axis, PaperRole role,
                                        PaperRole against)
{
    for (const ImprovementSummary &improvement : summary.improvements) {
        if (improvement.axis == axis && improvement.role == role && improvement.against == against)
            return &improvement;
    }
    return nullptr;
}

// Whether the networks differ among themselves.
std::string findingOfNetworks(const ExperimentSummary &summary)
{
    double widest = 0.0;
    std::string where;
    std::vector<double> printed;
    std::vector<double> simulated;
    for (const AxisSummary &axis : summary.axes) {
        const Span span = spanOf(networkExcess(axis));
        if (span.highest - span.lowest >= widest) {
            widest = span.highest - span.lowest;
            where = nameOf(summary, axis);
        }
        const ImprovementSummary *improvement =
            improvementOf(summary, axis.axis, PaperRole::Novel, PaperRole::Conventional2);
        printed.push_back(improvement->printed);
        simulated.push_back(improvement->simulated);
    }
    const std::string difference = forReading(kPercent * widest, 2) + " % of the noise floor";
    const std::string gains = "the improvement of Novel on Conventional 2 is " +
                              fromTo(spanOf(simulated), 2) + " % here, " + fromTo(spanOf(printed), 1) +
                              " % in print.";
    if (widest <= kSameShare) {
        return summary.sensor + ": " + listed(networkNames()) + " leave the same, to within " + difference +
               ". All are functions of one temperature, and none gains by its kind; " + gains;
    }
    return summary.sensor + ": " + listed(networkNames()) + " differ by up to " + difference + " (on " +
           where + "); " + gains;
}

std::string findingOfLine(const ExperimentSummary &summary)
{
    std::vector<double> printed;
    std::vector<double> simulated;
    for (const AxisSummary &axis : summary.axes) {
        const ImprovementSummary *improvement =
            improvementOf(summary, axis.axis, PaperRole::Conventional2, PaperRole::Conventional1);
        if (!improvement)
            return {};
        printed.push_back(improvement->printed);
        simulated.push_back(improvement->simulated);
    }
    const Span span = spanOf(simulated);
    const std::string figures =
        fromTo(span, 1) + " % here, " + fromTo(spanOf(printed), 1) + " % in print (means of five runs).";
    if (span.highest < kNoImprovement)
        return summary.sensor + ": the straight line does as well as a network: Conventional 2 improves on " +
               "Conventional 1 by " + figures;
    return summary.sensor + ": Conventional 2 improves on the straight line by " + figures +
           " It is the curvature of the drift that the line can't follow.";
}

std::string findingOfFloor(const ExperimentSummary &summary)
{
    double farthest = 0.0;
    std::string where;
    for (const AxisSummary &axis : summary.axes) {
        const double least = spanOf(networkExcess(axis)).lowest;
        if (where.empty() || least > farthest) {
            farthest = least;
            where = nameOf(summary, axis);
        }
    }
    if (farthest <= kSameShare)
        return summary.sensor + ": the best network ends within " + forReading(kPercent * kSameShare, 0) +
               " % of the noise floor on every axis shown. The rest is noise, which no model of "
               "temperature " +
               "removes.";
    return summary.sensor + ": the best network stays up to " + forReading(kPercent * farthest, 1) +
           " % over the noise floor (on " + where + "): what differs between the runs.";
}

std::size_t countOfAgreement(const std::vector<PaperCheck> &checks, PrintedAgreement agreement)
{
    return static_cast<std::size_t>(std::count_if(
        checks.begin(), checks.end(), [&](const PaperCheck &check) { return check.agreement == agreement; }));
}

std::string findingOfRounding(const Reproduction &reproduction)
{
    double farthest = 0.0;
    for (const PaperCheck &check : reproduction.checks) {
        if (check.agreement == PrintedAgreement::WithinRounding)
            farthest = std::max(farthest, std::abs(check.recomputed - check.printed.value()) /
                                              check.printed.lastDigitWorth());
    }
    const auto &checks = reproduction.checks;
    std::string text = "Of the " + std::to_string(checks.size()) +
                       " printed Q and percentages, recomputed from the printed MSDs, " +
                       std::to_string(countOfAgreement(checks, PrintedAgreement::Exact)) +
                       " come out as printed, " +
                       std::to_string(countOfAgreement(checks, PrintedAgreement::WithinRounding)) +
                       " differ but lie within what the rounding of the MSDs allows";
    if (farthest > 0.0)
        text += " (by up to " + forReading(farthest, 1) + " units of the last digit)";
    return text + ", and " + std::to_string(countOfAgreement(checks, PrintedAgreement::No)) +
           " can't be explained by rounding.";
}

bool isWrongThroughout(const ReproducedRow &row)
{
    return std::all_of(row.cells.begin(), row.cells.end(), [](const ReproducedCell &cell) {
        return !cell.check || cell.check->column.kind != PaperColumnKind::Improvement ||
               cell.check->agreement == PrintedAgreement::No;
    });
}

} // namespace

std::string captionOf(const ReproducedTable &table)
{
    const PaperExperiment &experiment = *table.experiment;
    std::string rate;
    for (const double rateDps : experiment.referenceRateDps)
        rate += (rate.empty() ? "" : ", ") + fixed(rateDps, 0);
    const bool atRest = experiment.referenceRateDps.isZero();
    std::string text =
        "Table " + std::to_string(table.printed.number) + ". " + experiment.sensor +
        (atRest ? " at rest, five runs"
                : " at " + rate + " dps, run " + std::to_string(table.rows.front().run + 1) + " of five") +
        ": MSD in dps² before (MSD1)";
    for (const PaperColumn &column : table.printed.columns) {
        if (column.kind != PaperColumnKind::Msd || column.role == PaperRole::Before)
            continue;
        const std::string model = column.role == PaperRole::Conventional1   ? "a line"
                                  : column.role == PaperRole::Conventional2 ? "BP network"
                                                                            : "RBF network";
        text += ", after " + model + " (" + std::string(column.name) + ")";
    }
    return text;
}

std::vector<std::string> howItWasDone(const Reproduction &reproduction)
{
    std::vector<std::string> seeds;
    for (const PaperExperimentOutcome &outcome : reproduction.outcomes)
        seeds.push_back(std::to_string(outcome.seed) + " for the " + outcome.experiment.sensor);
    return {
        "All figures in rows marked \"simulated\" are of simulated data (seed " + listed(seeds) +
            "), not of sensors. The simulator's noise and drift were sized after the printed tables: that "
            "MSD1, "
            "the straight line's MSD and the floor lie near them is no finding; how the networks compare on "
            "unseen runs is.",
        "Each run is judged by models that were trained on the other four runs only.",
        "Conventional 1 is " + std::string(kConventional1Model) + ", Conventional 2 " +
            std::string(kConventional2Model) + ", Novel " + std::string(kNovelModels[0]) +
            " (Gaussians of one width, Eq. 29); rows marked \"with " + std::string(kNovelModels[1]) +
            "\" put Gaussians of several widths in its place.",
        "Printed percentages are without sign; simulated ones have it: below zero the model named first is "
        "worse.",
    };
}

std::vector<std::string> findingsOfArithmetic(const Reproduction &reproduction)
{
    std::vector<std::string> findings{findingOfRounding(reproduction)};
    for (const ReproducedTable &table : reproduction.tables) {
        for (std::size_t r = 0; r < table.rows.size(); ++r) {
            if (isWrongThroughout(table.rows[r]) &&
                improvementsAgreeAmongThemselves(table.printed, table.printed.rows[r]))
                findings.push_back("The percentages of Table " + std::to_string(table.printed.number) + ", " +
                                   rowName(table, table.rows[r]) +
                                   ", follow from each other but not from the row's MSDs: they belong to "
                                   "other MSDs than those printed.");
        }
    }
    if (reproduction.belowBound.empty())
        return findings;
    std::vector<std::string> rows;
    for (const UnseenRunBound &bound : reproduction.belowBound)
        rows.push_back("Table " + std::to_string(bound.table) + " " +
                       std::string(kAxisNames[static_cast<std::size_t>(bound.axis)]) + " (" +
                       fixed(bound.printed, 4) + ", at least " + fixed(bound.least, 4) + ")");
    findings.push_back(
        "No model trained on the other four runs can leave as little as is printed for Novel in " +
        listed(rows) +
        " dps²: so much does the drift before compensation differ between the runs. Unless the "
        "runs went through different temperatures, these rows were judged by models that had "
        "seen the run.");
    return findings;
}

std::vector<std::string> findingsOfSimulation(const Reproduction &reproduction)
{
    std::vector<std::string> findings;
    for (const ExperimentSummary &summary : reproduction.summaries) {
        for (const std::string &finding :
             {findingOfNetworks(summary), findingOfLine(summary), findingOfFloor(summary)}) {
            if (!finding.empty())
                findings.push_back(finding);
        }
    }
    return findings;
}

} // namespace driftbench::cli
