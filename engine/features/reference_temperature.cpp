#include "engine/features/run_features.h"
#include "engine/recording/initial_hold.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace driftbench {

namespace {

// Holds whose means lie this close are the same hold.
constexpr double kSharedHoldC = 1.0;

std::optional<double> sharedHoldC(const Campaign &campaign)
{
    std::vector<double> means;
    for (const Run &run : campaign.runs) {
        const auto hold = findInitialHold(run);
        if (!hold)
            return std::nullopt;
        means.push_back(hold->meanTemperatureC);
    }
    if (means.empty())
        return std::nullopt;
    const auto [low, high] = std::minmax_element(means.begin(), means.end());
    if (*high - *low > kSharedHoldC)
        return std::nullopt;
    double sum = 0.0;
    for (const double meanC : means)
        sum += meanC;
    return sum / static_cast<double>(means.size());
}

} // namespace

double chooseReferenceTemperature(const Campaign &campaign, std::optional<double> given)
{
    if (given)
        return *given;
    if (const auto hold = sharedHoldC(campaign))
        return *hold;
    double lowestC = std::numeric_limits<double>::infinity();
    for (const Run &run : campaign.runs) {
        for (Eigen::Index i = 0; i < run.mask.size(); ++i) {
            if (run.mask.usableForJudging(i))
                lowestC = std::min(lowestC, run.recording->temperatureC[i]);
        }
    }
    return lowestC;
}

} // namespace driftbench
