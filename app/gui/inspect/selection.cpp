#include "app/gui/inspect/selection.h"

#include <algorithm>

namespace driftbench {

Selection selectionOfStrip(const InspectionData &seen, double startS, double endS)
{
    Selection selection;
    for (std::size_t r = 0; r < seen.runs.size(); ++r) {
        const InspectedRun &run = seen.runs[r];
        const double from = std::max(startS, run.stripStartS);
        const double to = std::min(endS, run.stripEndS());
        if (from < to)
            selection.push_back({r, run.toRun(from), run.toRun(to)});
    }
    return selection;
}

Selection selectionWhere(const InspectionData &seen,
                         const std::function<bool(double deltaT, const Eigen::Vector3d &tdeDps)> &matches)
{
    Selection selection;
    for (std::size_t r = 0; r < seen.runs.size(); ++r) {
        const RunFeatures &dots = *seen.runs[r].dots;
        const Eigen::Index count = dots.timeS.size();
        bool open = false;
        for (Eigen::Index i = 0; i < count; ++i) {
            const bool match = matches(dots.deltaT[i], dots.tdeDps.row(i).transpose());
            // To the middle between a dot in it and one that is not.
            const double before = i > 0 ? 0.5 * (dots.timeS[i - 1] + dots.timeS[i]) : seen.runs[r].firstS;
            const double after =
                i + 1 < count ? 0.5 * (dots.timeS[i] + dots.timeS[i + 1]) : seen.runs[r].lastS;
            if (match && !open)
                selection.push_back({r, before, after});
            else if (match)
                selection.back().endS = after;
            open = match;
        }
    }
    return selection;
}

SelectedDots dotsIn(const InspectionData &seen, const Selection &selection)
{
    SelectedDots result;
    std::vector<std::pair<std::size_t, Eigen::Index>> found;
    for (const SelectedStretch &stretch : selection) {
        const Eigen::VectorXd &timeS = seen.runs[stretch.run].dots->timeS;
        const double *first = std::lower_bound(timeS.data(), timeS.data() + timeS.size(), stretch.startS);
        for (; first != timeS.data() + timeS.size() && *first <= stretch.endS; ++first)
            found.emplace_back(stretch.run, first - timeS.data());
    }
    const auto count = static_cast<Eigen::Index>(found.size());
    result.deltaT.resize(count);
    result.tdeDps.resize(count, 3);
    for (Eigen::Index k = 0; k < count; ++k) {
        const auto &[run, i] = found[static_cast<std::size_t>(k)];
        const RunFeatures &dots = *seen.runs[run].dots;
        result.run.push_back(run);
        result.timeS.push_back(dots.timeS[i]);
        result.deltaT[k] = dots.deltaT[i];
        result.tdeDps.row(k) = dots.tdeDps.row(i);
    }
    return result;
}

} // namespace driftbench
