#include "engine/exports/comparison_files.h"

#include "engine/base/atomic_file.h"
#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <cmath>

namespace driftbench {

namespace {

std::string csvNumber(double value)
{
    return std::isfinite(value) ? shortest(value) : std::string();
}

// Quoted where a reader would split it otherwise (RFC 4180).
std::string csvText(const std::string &text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::string joined(const std::vector<std::string> &names)
{
    std::string text;
    for (const std::string &name : names)
        text += (text.empty() ? "" : ";") + name;
    return text;
}

} // namespace

template <class Counts>
static Eigen::Index samplesWhere(const Run &run, const Counts &counts)
{
    double samples = 0.0;
    for (Eigen::Index row = 0; row < run.mask.size(); ++row)
        samples += counts(row) ? run.recording->points.countAt(row) : 0.0;
    return static_cast<Eigen::Index>(samples);
}

RunFacts factsOf(const Run &run)
{
    RunFacts facts;
    facts.name = run.name;
    facts.file = run.recording->info.source;
    facts.format = run.recording->info.format;
    facts.instance = run.recording->info.instance;
    facts.referenceRateDps = run.referenceRateDps;
    facts.samples = static_cast<Eigen::Index>(run.recording->samples());
    facts.usable = samplesWhere(run, [&](Eigen::Index row) { return run.mask.usableForJudging(row); });
    for (const MaskReason reason : kMaskReasons) {
        const Eigen::Index count =
            samplesWhere(run, [&](Eigen::Index row) { return run.mask.has(row, reason); });
        if (count > 0)
            facts.masked[std::string(maskReasonName(reason))] = count;
    }
    return facts;
}

std::string comparisonToCsv(const Comparison &comparison)
{
    std::string text =
        "run,axis,model,msd_before,msd_after,q,noise_floor,excess_over_floor,rms10s_dps,rms_dps,"
        "bias_instability_dps,samples,trained_on\n";
    for (const ComparisonRow &row : comparison.rows) {
        text += csvText(row.run) + ',' + std::string(kAxisNames[static_cast<std::size_t>(row.axis)]) + ',' +
                csvText(row.model);
        for (const double value : {row.msdBefore, row.msdAfter, row.q, row.noiseFloor, row.excessOverFloor,
                                   row.rms10sDps, row.rmsDps, row.biasInstabilityDps})
            text += ',' + csvNumber(value);
        text += ',' + std::to_string(row.samples) + ',' + csvText(joined(row.trainedOn)) + '\n';
    }
    return text;
}

std::string recommendationToText(const Comparison &comparison)
{
    std::string text;
    if (comparison.simulated)
        text += "Simulated data: this says nothing about a real sensor.\n\n";
    for (std::size_t axis = 0; axis < comparison.verdicts.size(); ++axis) {
        const AxisVerdict &verdict = comparison.verdicts[axis];
        text += std::string(kAxisNames[axis]) + ": " + std::string(verdictName(verdict.verdict));
        if (verdict.verdict == Verdict::Yes || verdict.verdict == Verdict::WithCare)
            text += ", " + verdict.model;
        text += "\n   " + verdict.reason + '\n';
    }
    text += "\nJudged " + std::string(judgingName(comparison.options.judging)) + ".\n";
    for (const std::string &warning : comparison.warnings)
        text += "Warning: " + warning + '\n';
    return text;
}

std::vector<ComparisonFile> comparisonFiles(const Comparison &comparison, const CampaignSummary &campaign)
{
    return {{"comparison.json", comparisonToJson(comparison, campaign)},
            {"comparison.csv", comparisonToCsv(comparison)},
            {"comparison.md", comparisonToMarkdown(comparison, campaign)},
            {"recommendation.json", recommendationToJson(comparison)},
            {"recommendation.txt", recommendationToText(comparison)}};
}

Status writeComparisonFiles(const Comparison &comparison, const CampaignSummary &campaign,
                            const std::filesystem::path &folder)
{
    if (Status made = ensureWritableFolder(folder); !made)
        return made;
    for (const auto &[name, text] : comparisonFiles(comparison, campaign)) {
        if (Status written = writeFileAtomically(folder / name, text); !written)
            return written;
    }
    return {};
}

} // namespace driftbench
