#include "engine/base/statistics.h"
#include "engine/base/text.h"
#include "engine/recording/quality_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace driftbench::quality {

namespace {

std::string nonFiniteColumn(const Recording &recording, Eigen::Index row)
{
    if (!std::isfinite(recording.timeS[row]))
        return "time";
    if (!std::isfinite(recording.temperatureC[row]))
        return "temperature";
    for (int axis = 0; axis < kAxisCount; ++axis) {
        if (!std::isfinite(recording.rateDps(row, axis)))
            return "rate of " + std::string(kAxisNames[static_cast<std::size_t>(axis)]);
    }
    return {};
}

// Level and scatter of a few samples; the scatter from first differences, so that drift does not count.
struct Settled
{
    double level = 0.0;
    double sigma = 0.0;
};

Settled settled(const std::vector<double> &values, std::size_t first, std::size_t count)
{
    std::vector<double> part(values.begin() + static_cast<std::ptrdiff_t>(first),
                             values.begin() + static_cast<std::ptrdiff_t>(first + count));
    std::vector<double> differences;
    for (std::size_t i = 1; i < part.size(); ++i)
        differences.push_back(part[i] - part[i - 1]);
    return {median(std::move(part)), robustSigma(std::move(differences)) / std::numbers::sqrt2};
}

constexpr std::size_t kLongestStartUp = 10; // samples
constexpr std::size_t kSettledSamples = 25; // after them
constexpr double kStartUpSigmas = 8.0;
constexpr double kSmallestStartUpDps = 0.05;
constexpr double kSmallestStartUpC = 2.0;

bool farOff(const std::vector<double> &values, std::size_t sample, const Settled &later, double smallest)
{
    return std::abs(values[sample] - later.level) > std::max(kStartUpSigmas * later.sigma, smallest);
}

// A saturated rate repeats the end of its range, bit for bit, and lies far from where the gyro rests. Quiet
// quantised data also repeats values, but stays near its median.
constexpr double kSmallestSaturationDps = 10.0;
constexpr double kSaturationSigmas = 30.0;
constexpr std::size_t kFewestRepeats = 3;

struct Rest
{
    double medianDps;
    double farDps;
};

Eigen::Index maskRepeats(Draft &draft, const UsableColumns &columns, const std::vector<double> &rate,
                         double extreme, const Rest &rest)
{
    if (std::abs(extreme - rest.medianDps) < rest.farDps)
        return 0;
    Eigen::Index masked = 0;
    for (std::size_t i = 0; i < rate.size();) {
        std::size_t end = i;
        while (end < rate.size() && rate[end] == extreme)
            ++end;
        if (end - i >= kFewestRepeats) {
            for (std::size_t j = i; j < end; ++j)
                draft.exclude(columns.rows[j], MaskReason::Saturated);
            masked += static_cast<Eigen::Index>(end - i);
        }
        i = std::max(end, i + 1);
    }
    return masked;
}

void reportStuckRate(Draft &draft, const std::string &axisName, double rateDps)
{
    draft.note(FindingSeverity::Warning, "rate stuck",
               "The rate of " + axisName + " is " + forReading(rateDps, 3) +
                   " dps in every sample: this axis measures nothing.");
}

} // namespace

void checkValues(Draft &draft, const QualityOptions &options)
{
    const Recording &recording = draft.recording;
    const Eigen::ArrayXd sum = recording.timeS + recording.temperatureC + recording.rateDps.rowwise().sum();
    Eigen::Index firstBad = -1;
    Eigen::Index bad = 0;
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        // Infinities of either sign and NaN all leave a sum that is not finite; an overflow is looked at too.
        if (std::isfinite(sum[i]) || nonFiniteColumn(recording, i).empty())
            continue;
        draft.exclude(i, MaskReason::NonFinite);
        firstBad = firstBad < 0 ? i : firstBad;
        ++bad;
    }
    if (bad == 0)
        return;
    const std::string where =
        "sample " + countText(firstBad + 1) + " (" + nonFiniteColumn(recording, firstBad) + ")";
    const double timeS = std::isfinite(recording.timeS[firstBad]) ? recording.timeS[firstBad] : 0.0;
    if (options.maskBadRows) {
        draft.note(FindingSeverity::Warning, "non-finite",
                   countOf(bad, "sample") + " with values that are no numbers masked, the first is " + where +
                       ".",
                   timeS, timeS);
    } else {
        draft.refuse(Errc::NonFiniteValue, "non-finite",
                     countOf(bad, "sample") +
                         (bad == 1 ? " has a value that is no number" : " have values that are no numbers") +
                         " (NaN or infinite), the first is " + where +
                         "; repair the log, or have bad rows masked.");
    }
}

void checkStartUp(Draft &draft)
{
    const UsableColumns &columns = draft.usable();
    if (columns.size() < kLongestStartUp + kSettledSamples)
        return;
    const auto later = [](const std::vector<double> &values) {
        return settled(values, kLongestStartUp, kSettledSamples);
    };
    const Settled temperature = later(columns.temperatureC);
    std::array<Settled, kAxisCount> rates;
    std::transform(columns.rateDps.begin(), columns.rateDps.end(), rates.begin(), later);
    const auto notUpYet = [&](std::size_t sample) {
        if (farOff(columns.temperatureC, sample, temperature, kSmallestStartUpC))
            return true;
        for (std::size_t axis = 0; axis < rates.size(); ++axis) {
            if (farOff(columns.rateDps[axis], sample, rates[axis], kSmallestStartUpDps))
                return true;
        }
        return false;
    };
    std::size_t count = 0;
    while (count < kLongestStartUp && notUpYet(count))
        ++count;
    // All of them off: no start-up but a step or motion, which have their own checks.
    if (count == 0 || count == kLongestStartUp)
        return;
    for (std::size_t i = 0; i < count; ++i)
        draft.exclude(columns.rows[i], MaskReason::StartUp);
    draft.note(FindingSeverity::Note, "start-up",
               "The first " +
                   (count == 1 ? std::string("sample is") : std::to_string(count) + " samples are") +
                   " far off those that follow (start-up): masked.",
               columns.timeS.front(), columns.timeS[count - 1]);
}

void checkSaturation(Draft &draft)
{
    const UsableColumns &columns = draft.usable();
    if (columns.size() < kFewestRepeats)
        return;
    for (std::size_t axis = 0; axis < columns.rateDps.size(); ++axis) {
        const std::vector<double> &rate = columns.rateDps[axis];
        const auto [low, high] = std::minmax_element(rate.begin(), rate.end());
        const std::string axisName(kAxisNames[axis]);
        if (*low == *high)
            reportStuckRate(draft, axisName, *low);
        if (*high - *low < kSmallestSaturationDps)
            continue;
        const Rest rest{median(rate),
                        std::max(kSmallestSaturationDps, kSaturationSigmas * robustSigma(rate))};
        const double lowDps = *low;
        const double highDps = *high;
        const Eigen::Index masked = maskRepeats(draft, columns, rate, lowDps, rest) +
                                    maskRepeats(draft, columns, rate, highDps, rest);
        if (masked > 0) {
            draft.note(FindingSeverity::Warning, "saturation",
                       "The rate of " + axisName + " stands at the end of its range (" +
                           forReading(lowDps, 1) + " to " + forReading(highDps, 1) + " dps) in " +
                           countOf(masked, "sample") + ": masked.");
        }
    }
}

} // namespace driftbench::quality
