#include "engine/recording/quality.h"

#include "engine/base/text.h"
#include "engine/recording/block_means.h"
#include "engine/recording/quality_checks.h"

#include <algorithm>
#include <filesystem>

namespace driftbench {

namespace quality {

void Draft::note(FindingSeverity severity, std::string kind, std::string message, double startS, double endS)
{
    findings.push_back({severity, std::move(kind), std::move(message), startS, endS});
}

void Draft::refuse(Errc code, std::string kind, std::string message)
{
    note(FindingSeverity::Refusal, std::move(kind), message);
    if (!refusal)
        refusal = Error{code, sourcePrefix(recording) + message};
}

Draft::Draft(Recording recordingToCheck) : recording(std::move(recordingToCheck)), m_mask(recording.size()) {}

void Draft::exclude(Eigen::Index sample, MaskReason reason)
{
    m_mask.set(sample, reason);
    m_usableIsCurrent = m_usableIsCurrent && m_mask.usableForJudging(sample);
}

void Draft::replaceTemperature(const std::vector<Eigen::Index> &rows, const std::vector<double> &temperatureC)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        recording.temperatureC[rows[i]] = temperatureC[i];
    m_usableIsCurrent = false;
}

const UsableColumns &Draft::usable()
{
    if (m_usableIsCurrent)
        return m_usable;
    const auto count = static_cast<std::size_t>(m_mask.countUsableForJudging());
    m_usable.rows.clear();
    m_usable.rows.reserve(count);
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        if (m_mask.usableForJudging(i))
            m_usable.rows.push_back(i);
    }
    const auto gather = [&](const double *from, std::vector<double> &to) {
        to.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            to[i] = from[m_usable.rows[i]];
    };
    gather(recording.timeS.data(), m_usable.timeS);
    gather(recording.temperatureC.data(), m_usable.temperatureC);
    for (int axis = 0; axis < kAxisCount; ++axis)
        gather(recording.rateDps.col(axis).data(), m_usable.rateDps[static_cast<std::size_t>(axis)]);
    m_usableIsCurrent = true;
    return m_usable;
}

std::string countText(Eigen::Index count)
{
    std::string digits = std::to_string(count);
    for (auto end = static_cast<std::ptrdiff_t>(digits.size()) - 3; end > 0; end -= 3)
        digits.insert(static_cast<std::size_t>(end), " ");
    return digits;
}

std::string countOf(Eigen::Index count, const std::string &thing)
{
    return countText(count) + ' ' + thing + (count == 1 ? "" : "s");
}

std::string rangeText(double startS, double endS)
{
    return fixed(startS, 1) + " to " + fixed(endS, 1) + " s";
}

std::string sourcePrefix(const Recording &recording)
{
    return recording.info.source.empty() ? std::string() : recording.info.source + ": ";
}

} // namespace quality

CheckedRun checkRun(Recording recording, const QualityOptions &options)
{
    quality::Draft draft(std::move(recording));
    if (const std::string means = meansText(draft.recording); !means.empty())
        draft.note(FindingSeverity::Note, "means", means + " Findings count the means.");
    quality::checkValues(draft, options);
    quality::checkTimes(draft, options);
    quality::excludeRanges(draft, options);
    quality::checkStartUp(draft);
    quality::checkSaturation(draft);
    quality::checkTemperature(draft);
    quality::interpolateStairs(draft, options);
    quality::checkMotion(draft, options);
    quality::checkOutliers(draft);
    quality::checkSufficiency(draft, options);
    quality::checkDrift(draft);

    std::stable_sort(draft.findings.begin(), draft.findings.end(),
                     [](const Finding &a, const Finding &b) { return a.startS < b.startS; });
    CheckedRun checked;
    checked.run.name = options.name.empty()
                           ? std::filesystem::path(draft.recording.info.source).stem().string()
                           : options.name;
    checked.run.mask = draft.mask();
    checked.run.findings = std::move(draft.findings);
    checked.run.recording = std::make_shared<const Recording>(std::move(draft.recording));
    checked.refusal = std::move(draft.refusal);
    return checked;
}

Result<Run> prepareRun(Recording recording, const QualityOptions &options)
{
    CheckedRun checked = checkRun(std::move(recording), options);
    if (checked.refusal)
        return *checked.refusal;
    return std::move(checked.run);
}

} // namespace driftbench
