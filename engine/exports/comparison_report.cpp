#include "engine/base/axes.h"
#include "engine/base/text.h"
#include "engine/evaluation/paper_improvements.h"
#include "engine/exports/comparison_files.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace driftbench {

namespace {

std::string superscript(int exponent)
{
    static constexpr std::array<const char *, 10> kDigits{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                                          "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text = exponent < 0 ? "\u207b" : "";
    for (const char digit : std::to_string(std::abs(exponent)))
        text += kDigits[static_cast<std::size_t>(digit - '0')];
    return text;
}

// Four significant digits; powers of ten as in the paper.
std::string figure(double value)
{
    constexpr int kDigits = 4;
    if (!std::isfinite(value))
        return "\u2013";
    if (value == 0.0)
        return "0";
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (exponent >= -2 && exponent < 5)
        return forReading(value, std::max(0, kDigits - 1 - exponent));
    return forReading(value / std::pow(10.0, exponent), kDigits - 1) + " \u00d7 10" + superscript(exponent);
}

std::string percent(double fraction)
{
    return std::isfinite(fraction) ? forReading(100.0 * fraction, 2) + " %" : "\u2013";
}

std::string axisName(int axis)
{
    return std::string(kAxisNames[static_cast<std::size_t>(axis)]);
}

// A file name or model name must not end a table's cell.
std::string cell(const std::string &text)
{
    std::string escaped;
    for (const char c : text)
        escaped += c == '|' ? std::string("\\|") : std::string(1, c);
    return escaped;
}

std::string tableRow(const std::vector<std::string> &cells)
{
    std::string text = "|";
    for (const std::string &entry : cells)
        text += ' ' + entry + " |";
    return text + '\n';
}

std::string tableHead(const std::vector<std::string> &names)
{
    std::string text = tableRow(names) + "|---|";
    for (std::size_t i = 1; i < names.size(); ++i)
        text += "---:|";
    return text + '\n';
}

std::string opening(const Comparison &comparison, const CampaignSummary &campaign)
{
    std::string text = "# Comparison of models on held-out runs\n\n";
    if (comparison.simulated)
        text += "**Simulated data**: this says nothing about a real sensor.\n\n";
    text += "Sensor: " + campaign.sensor.text() + ". Reference temperature " +
            forReading(campaign.referenceTemperatureC, 2) + " \u00b0C. Judged " +
            std::string(judgingName(comparison.options.judging)) +
            (comparison.options.judging == Judging::Anchored ? " (each run's bias at its start is removed)"
                                                             : " (the turn-on bias counts)") +
            ". Seed " + std::to_string(comparison.options.seed) + ".\n\n";
    for (const std::string &warning : comparison.warnings)
        text += "> " + warning + "\n\n";
    return text;
}

std::string verdicts(const Comparison &comparison)
{
    std::string text =
        "## Verdict\n\n" + tableHead({"axis", "verdict", "model", "gain", "gain without a model"});
    for (std::size_t axis = 0; axis < comparison.verdicts.size(); ++axis) {
        const AxisVerdict &verdict = comparison.verdicts[axis];
        const auto gain = [](double value) { return std::isfinite(value) ? forReading(value, 3) : "\u2013"; };
        text += tableRow({axisName(static_cast<int>(axis)), std::string(verdictName(verdict.verdict)),
                          cell(verdict.model), gain(verdict.gain), gain(verdict.gainModelFree)});
    }
    text += '\n';
    for (const AxisVerdict &verdict : comparison.verdicts)
        text += verdict.reason + "\n\n";
    return text;
}

std::string runs(const CampaignSummary &campaign)
{
    std::string text = "## Runs\n\n" + tableHead({"run", "file", "samples", "used",
                                                  "reference rate x, y, z (dps)", "masked"});
    for (const RunFacts &run : campaign.runs) {
        std::string masked;
        for (const auto &[reason, count] : run.masked)
            masked += (masked.empty() ? "" : ", ") + reason + ' ' + std::to_string(count);
        std::string reference;
        for (const double rateDps : run.referenceRateDps)
            reference += (reference.empty() ? "" : ", ") + figure(rateDps);
        text += tableRow({cell(run.name), cell(run.file), std::to_string(run.samples),
                          std::to_string(run.usable), reference, masked.empty() ? "none" : masked});
    }
    return text + '\n';
}

std::string paperTable(std::span<const PaperRow> table)
{
    std::string text = tableHead({"axis", "MSD1", "MSD4", "MSD5", "MSD6", "Q3", "Q4", "Q5", "\u2206Q4/Q3",
                                  "\u2206Q5/Q3", "\u2206Q5/Q4"});
    for (const PaperRow &row : table)
        text += tableRow({axisName(row.axis), figure(row.msd1), figure(row.msd4), figure(row.msd5),
                          figure(row.msd6), figure(row.q3), figure(row.q4), figure(row.q5),
                          percent(row.q4AgainstQ3), percent(row.q5AgainstQ3), percent(row.q5AgainstQ4)});
    return text + '\n';
}

std::string rmsTable(std::span<const ComparisonRow> rows)
{
    std::string text =
        tableHead({"axis", "model", "rms left (dps)", "MSD after (dps\u00b2)", "noise floor (dps\u00b2)",
                   "excess over floor", "rms of 10 s means (dps)", "bias instability (dps)"});
    for (const ComparisonRow &row : rows)
        text += tableRow({axisName(row.axis), cell(row.model), figure(row.rmsDps), figure(row.msdAfter),
                          figure(row.noiseFloor), percent(row.excessOverFloor), figure(row.rms10sDps),
                          figure(row.biasInstabilityDps)});
    return text + '\n';
}

std::string heldOutRuns(const Comparison &comparison)
{
    std::string text =
        "## Held-out runs\n\n"
        "MSD in dps\u00b2: MSD1 before, MSD4 after linear (Conventional 1), MSD5 after bpnn "
        "(Conventional 2), MSD6 after rbf (Novel). Q3, Q4, Q5: MSD4, MSD5, MSD6 over MSD1. "
        "\u2206Q4/Q3 is (Q3 \u2212 Q4)/Q3 and so on: positive where the first named is better.\n\n";
    const std::vector<PaperRow> table = paperImprovements(comparison.rows);
    const std::span<const ComparisonRow> rows(comparison.rows);
    for (std::size_t first = 0, paper = 0; first < rows.size();) {
        std::size_t last = first;
        while (last < rows.size() && rows[last].run == rows[first].run)
            ++last;
        std::size_t paperEnd = paper;
        while (paperEnd < table.size() && table[paperEnd].run == rows[first].run)
            ++paperEnd;
        text += "### " + rows[first].run + "\n\n";
        text += paperTable(std::span(table).subspan(paper, paperEnd - paper));
        text += rmsTable(rows.subspan(first, last - first));
        first = last;
        paper = paperEnd;
    }
    return text;
}

std::string hysteresis(const Hysteresis &hysteresis)
{
    std::string text = "## Heating against cooling\n\n";
    if (hysteresis.heatingAndCooling) {
        text += "Rms difference at the same temperature: ";
        for (int axis = 0; axis < kAxisCount; ++axis)
            text += (axis == 0 ? "" : ", ") + axisName(axis) + ' ' + forReading(hysteresis.rmsDps[axis], 3);
        text += " dps.\n\n";
    } else {
        text += "The runs do not pass a common temperature both heating and cooling.\n\n";
    }
    if (hysteresis.passages.empty())
        return text;
    text += "At " + forReading(hysteresis.meetingTemperatureC, 0) + " \u00b0C:\n\n" +
            tableHead({"run", "direction", "x (dps)", "y (dps)", "z (dps)"});
    for (const Passage &passage : hysteresis.passages)
        text += tableRow({cell(passage.run), passage.heating ? "heating" : "cooling",
                          forReading(passage.tdeDps[0], 3), forReading(passage.tdeDps[1], 3),
                          forReading(passage.tdeDps[2], 3)});
    return text + '\n';
}

} // namespace

std::string comparisonToMarkdown(const Comparison &comparison, const CampaignSummary &campaign)
{
    return opening(comparison, campaign) + verdicts(comparison) + runs(campaign) + heldOutRuns(comparison) +
           hysteresis(comparison.hysteresis);
}

} // namespace driftbench
