#include "engine/evaluation/recommendation.h"

#include "engine/base/statistics.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr double kSmallestDifference = 1e-4;

// How much more the one leaves than the other, run by run.
bool withinStandardError(const Candidate &candidate, const Candidate &best)
{
    const std::size_t runs = best.loss.size();
    std::vector<double> differences(runs);
    for (std::size_t r = 0; r < runs; ++r)
        differences[r] = candidate.loss[r] - best.loss[r];
    const double meanDifference = mean(differences);
    double squares = 0.0;
    for (const double difference : differences)
        squares += (difference - meanDifference) * (difference - meanDifference);
    const auto count = static_cast<double>(runs);
    const double standardError = runs > 1 ? std::sqrt(squares / (count - 1.0) / count) : 0.0;
    return meanDifference <= std::max(standardError, kSmallestDifference);
}

} // namespace

std::optional<std::size_t> recommended(const std::vector<Candidate> &candidates)
{
    if (candidates.empty())
        return std::nullopt;
    const auto best =
        std::min_element(candidates.begin(), candidates.end(),
                         [](const Candidate &a, const Candidate &b) { return mean(a.loss) < mean(b.loss); });
    auto chosen = best;
    for (auto candidate = candidates.begin(); candidate != candidates.end(); ++candidate) {
        if (candidate->complexity < chosen->complexity &&
            candidate->judgement.verdict <= best->judgement.verdict && withinStandardError(*candidate, *best))
            chosen = candidate;
    }
    return static_cast<std::size_t>(chosen - candidates.begin());
}

} // namespace driftbench
