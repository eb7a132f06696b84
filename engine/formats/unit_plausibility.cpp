#include "engine/formats/unit_plausibility.h"

#include "engine/base/axes.h"
#include "engine/base/statistics.h"
#include "engine/base/text.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr double kLeastNoiseDps = 0.0015;
constexpr double kMostNoiseDps = 10.0;
constexpr double kShortestStepS = 1e-5;
constexpr double kLongestStepS = 600.0;

} // namespace

void UnitPlausibility::add(const SampleBlock &block)
{
    if (m_differences >= kSamplesLookedAt)
        return;
    for (Eigen::Index i = 1; i < block.size(); ++i) {
        const Eigen::RowVector3d step = block.rateDps.row(i) - block.rateDps.row(i - 1);
        if (!step.allFinite())
            continue;
        for (std::size_t axis = 0; axis < 3; ++axis)
            m_sumOfSquares[axis] +=
                step[static_cast<Eigen::Index>(axis)] * step[static_cast<Eigen::Index>(axis)];
        ++m_differences;
    }
    if (!m_stepsS.empty())
        return;
    for (Eigen::Index i = 1; i < block.size(); ++i) {
        const double stepS = block.timeS[i] - block.timeS[i - 1];
        if (std::isfinite(stepS))
            m_stepsS.push_back(stepS);
    }
}

std::array<double, 3> UnitPlausibility::noiseDps() const
{
    std::array<double, 3> noise{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        noise[axis] = std::sqrt(m_sumOfSquares[axis] / (2.0 * static_cast<double>(m_differences)));
    return noise;
}

double UnitPlausibility::medianStepS() const
{
    return median(m_stepsS);
}

std::vector<std::string> UnitPlausibility::warnings(const std::string &file, bool rateUnitStated) const
{
    std::vector<std::string> found;
    const std::array<double, 3> noise = noiseDps();
    const double quietest = *std::min_element(noise.begin(), noise.end());
    const double loudest = *std::max_element(noise.begin(), noise.end());
    const std::string stated = rateUnitStated ? "the stated unit of the rates is probably wrong"
                                              : "no unit of the rates is stated and dps is probably wrong";
    if (loudest > 0.0 && loudest < kLeastNoiseDps) {
        found.push_back("The noise of " + file + " is only " + shortest(std::round(loudest * 1e7) / 1e7) +
                        " dps, less than any MEMS gyro has: " + stated + "; the values look like rad/s.");
    } else if (quietest > kMostNoiseDps) {
        found.push_back("The noise of " + file + " is " + fixed(quietest, 1) +
                        " dps, more than any MEMS gyro has: " + stated +
                        "; the values look like mdps or counts.");
    }
    const double stepS = medianStepS();
    if (stepS > kLongestStepS || (stepS > 0.0 && stepS < kShortestStepS)) {
        found.push_back("The samples of " + file + " are " + shortest(stepS) +
                        " s apart, which no log is: state the unit of time.");
    }
    return found;
}

} // namespace driftbench
