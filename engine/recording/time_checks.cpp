#include "engine/base/statistics.h"
#include "engine/base/text.h"
#include "engine/recording/quality_checks.h"

#include <algorithm>

namespace driftbench::quality {

namespace {

std::vector<Eigen::Index> usableRows(const Draft &draft)
{
    std::vector<Eigen::Index> rows;
    rows.reserve(static_cast<std::size_t>(draft.recording.size()));
    for (Eigen::Index i = 0; i < draft.recording.size(); ++i) {
        if (draft.mask().usableForJudging(i))
            rows.push_back(i);
    }
    return rows;
}

// The rows to keep so that as many as possible are left with a rising time: the longest rising subsequence,
// found by patience sorting. One wild time stamp then costs one row, not all that follow it.
std::vector<Eigen::Index> longestRisingRows(const Eigen::VectorXd &timeS,
                                            const std::vector<Eigen::Index> &rows)
{
    std::vector<std::size_t> pileTops; // pileTops[k]: end of that series of k + 1 rows which ends earliest
    std::vector<std::size_t> before(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto pile =
            std::lower_bound(pileTops.begin(), pileTops.end(), timeS[rows[i]],
                             [&](std::size_t top, double time) { return timeS[rows[top]] < time; });
        before[i] = pile == pileTops.begin() ? i : *(pile - 1);
        if (pile == pileTops.end())
            pileTops.push_back(i);
        else
            *pile = i;
    }
    std::vector<Eigen::Index> kept(pileTops.size());
    std::size_t last = pileTops.empty() ? 0 : pileTops.back();
    for (std::size_t k = pileTops.size(); k-- > 0; last = before[last])
        kept[k] = rows[last];
    return kept;
}

// Masks all of rows that are not in kept, a part of them in the same order.
void maskTheRest(Draft &draft, const std::vector<Eigen::Index> &rows, const std::vector<Eigen::Index> &kept)
{
    auto next = kept.begin();
    for (const Eigen::Index row : rows) {
        if (next != kept.end() && *next == row)
            ++next;
        else
            draft.exclude(row, MaskReason::BadTime);
    }
}

void maskDuplicates(Draft &draft, std::vector<Eigen::Index> &rows)
{
    const Eigen::VectorXd &timeS = draft.recording.timeS;
    std::vector<Eigen::Index> kept;
    kept.reserve(rows.size());
    Eigen::Index firstDuplicate = -1;
    for (const Eigen::Index row : rows) {
        if (kept.empty() || timeS[row] != timeS[kept.back()])
            kept.push_back(row);
        else if (firstDuplicate < 0)
            firstDuplicate = row;
    }
    if (firstDuplicate < 0)
        return;
    maskTheRest(draft, rows, kept);
    const auto count = static_cast<Eigen::Index>(rows.size() - kept.size());
    const double firstS = timeS[firstDuplicate];
    draft.note(FindingSeverity::Warning, "duplicate time",
               countOf(count, "sample") + (count == 1 ? " repeats" : " repeat") +
                   " the time stamp of the sample before, first at " + fixed(firstS, 3) + " s (sample " +
                   countText(firstDuplicate + 1) + "): masked.",
               firstS, firstS);
    rows = std::move(kept);
}

void maskBackwardTimes(Draft &draft, std::vector<Eigen::Index> &rows, const QualityOptions &options)
{
    const Eigen::VectorXd &timeS = draft.recording.timeS;
    const auto backward = std::adjacent_find(
        rows.begin(), rows.end(), [&](Eigen::Index a, Eigen::Index b) { return timeS[b] < timeS[a]; });
    if (backward == rows.end())
        return;
    const Eigen::Index row = *(backward + 1);
    const std::string where = "time goes backwards at sample " + countText(row + 1) + ", from " +
                              fixed(timeS[*backward], 3) + " to " + fixed(timeS[row], 3) + " s";
    std::vector<Eigen::Index> kept = longestRisingRows(timeS, rows);
    maskTheRest(draft, rows, kept);
    if (options.maskBadRows) {
        draft.note(FindingSeverity::Warning, "backward time",
                   "The " + where + "; " +
                       countOf(static_cast<Eigen::Index>(rows.size() - kept.size()), "sample") +
                       " out of order masked.",
                   timeS[row], timeS[row]);
    } else {
        draft.refuse(Errc::TimeBackwards, "backward time",
                     "The " + where + "; repair the log, or have bad rows masked.");
    }
    rows = std::move(kept);
}

void findGaps(Draft &draft, const std::vector<Eigen::Index> &rows, const QualityOptions &options)
{
    const Eigen::VectorXd &timeS = draft.recording.timeS;
    std::vector<double> intervals;
    intervals.reserve(rows.size());
    for (std::size_t i = 1; i < rows.size(); ++i)
        intervals.push_back(timeS[rows[i]] - timeS[rows[i - 1]]);
    if (intervals.empty())
        return;
    draft.intervalS = median(intervals);
    Eigen::Index gaps = 0;
    double missingS = 0.0;
    std::size_t longest = 0;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        if (intervals[i] <= options.gapFactor * draft.intervalS)
            continue;
        ++gaps;
        missingS += intervals[i] - draft.intervalS;
        longest = intervals[i] > intervals[longest] ? i : longest;
    }
    if (gaps == 0)
        return;
    const double startS = timeS[rows[longest]];
    const double percent = 100.0 * missingS / (timeS[rows.back()] - timeS[rows.front()]);
    draft.note(percent < 1.0 ? FindingSeverity::Note : FindingSeverity::Warning, "gap",
               countOf(gaps, "gap") + " in time: " + fixed(missingS, 1) + " s are missing (" +
                   fixed(percent, 1) + " %), the longest gap from " +
                   rangeText(startS, startS + intervals[longest]) + ".",
               startS, startS + intervals[longest]);
}

} // namespace

void checkTimes(Draft &draft, const QualityOptions &options)
{
    std::vector<Eigen::Index> rows = usableRows(draft);
    maskDuplicates(draft, rows);
    maskBackwardTimes(draft, rows, options);
    findGaps(draft, rows, options);
}

void excludeRanges(Draft &draft, const QualityOptions &options)
{
    for (const TimeRange &range : options.excluded) {
        Eigen::Index count = 0;
        for (Eigen::Index i = 0; i < draft.recording.size(); ++i) {
            const double timeS = draft.recording.timeS[i];
            if (timeS >= range.startS && timeS <= range.endS) {
                draft.exclude(i, MaskReason::Excluded);
                ++count;
            }
        }
        draft.note(FindingSeverity::Note, "excluded",
                   countOf(count, "sample") + " from " + rangeText(range.startS, range.endS) +
                       " excluded by the user.",
                   range.startS, range.endS);
    }
}

} // namespace driftbench::quality
