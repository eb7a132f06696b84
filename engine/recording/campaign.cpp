#include "engine/recording/campaign.h"

#include "engine/base/axes.h"
#include "engine/base/text.h"
#include "engine/recording/block_means.h"
#include "engine/recording/initial_hold.h"
#include "engine/recording/units_check.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace driftbench {

namespace {

// A bias this large is unheard of; a rate table that turned is not.
constexpr double kTurningDps = 10.0;

std::string sourceOf(const Run &run)
{
    return run.recording->info.source.empty() ? run.name : run.recording->info.source;
}

void makeNamesUnique(std::vector<Run> &runs)
{
    std::set<std::string> taken;
    for (Run &run : runs) {
        const std::string stem = run.name.empty() ? "run" : run.name;
        std::string name = stem;
        for (int number = 2; !taken.insert(name).second; ++number)
            name = stem + "-" + std::to_string(number);
        run.name = name;
    }
}

// Values, not names: a copy under another name is the same recording. Values that are no numbers are equal to
// themselves here.
template <class Matrix>
bool sameValues(const Matrix &a, const Matrix &b)
{
    return a.size() == b.size() &&
           std::equal(a.data(), a.data() + a.size(), b.data(),
                      [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

bool sameRecording(const Recording &a, const Recording &b)
{
    return sameValues(a.rateDps, b.rateDps) && sameValues(a.temperatureC, b.temperatureC);
}

Status checkPair(const Run &a, const Run &b)
{
    if (a.recording->info.sensor.contradicts(b.recording->info.sensor)) {
        return Error{Errc::DifferentSensors, sourceOf(a) + " is of sensor " +
                                                 a.recording->info.sensor.text() + " and " + sourceOf(b) +
                                                 " of " + b.recording->info.sensor.text() +
                                                 "; a campaign is of one sensor, train them apart."};
    }
    if (sameRecording(*a.recording, *b.recording)) {
        return Error{Errc::SameRecordingTwice,
                     sourceOf(a) + " and " + sourceOf(b) +
                         " are the same recording; a run must not be judged on itself, leave one out."};
    }
    return {};
}

Status checkUnits(const Campaign &campaign, std::vector<std::string> &warnings)
{
    std::vector<RateScale> scales;
    for (const Run &run : campaign.runs) {
        scales.push_back(rateScale(run));
        if (std::string sentence = implausibleNoise(run, scales.back()); !sentence.empty())
            warnings.push_back(std::move(sentence));
    }
    for (std::size_t i = 0; i < scales.size(); ++i) {
        for (std::size_t j = i + 1; j < scales.size(); ++j) {
            const UnitsGuess guess = compareUnits(scales[i], scales[j]);
            if (guess == UnitsGuess::Same)
                continue;
            const std::string pair = sourceOf(campaign.runs[i]) + " and " + sourceOf(campaign.runs[j]);
            if (guess == UnitsGuess::Differ) {
                return Error{Errc::UnitsDiffer,
                             pair +
                                 " differ by a factor of 57.3 in noise and swing: one is in rad/s, the other "
                                 "in dps; name the unit in the header of each, like gyro_x_rad_s."};
            }
            warnings.push_back("The noise of " + pair + " differs by a factor of 57.3: check their units.");
        }
    }
    return {};
}

Status setReferenceRates(Campaign &campaign, const CampaignOptions &options)
{
    if (options.referenceRate == ReferenceRateKind::OfEachRun)
        return {};
    for (Run &run : campaign.runs) {
        if (options.referenceRate == ReferenceRateKind::Given) {
            run.referenceRateDps = options.referenceRateDps;
            continue;
        }
        const auto hold = findInitialHold(run);
        if (!hold) {
            return Error{Errc::NothingUsable,
                         sourceOf(run) + " does not start with a hold of the temperature, so that its "
                                         "mean can't be the reference rate; give the rate instead."};
        }
        run.referenceRateDps = hold->meanRateDps;
    }
    return {};
}

void warnIfTurning(const Campaign &campaign, std::vector<std::string> &warnings)
{
    for (const Run &run : campaign.runs) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        Eigen::Index count = 0;
        for (Eigen::Index i = 0; i < run.mask.size(); ++i) {
            if (!run.mask.usableForJudging(i))
                continue;
            sum += run.recording->rateDps.row(i).transpose();
            ++count;
        }
        for (int axis = 0; count > 0 && axis < kAxisCount; ++axis) {
            const double meanDps = sum[axis] / static_cast<double>(count);
            if (std::abs(meanDps - run.referenceRateDps[axis]) <= kTurningDps)
                continue;
            warnings.push_back("The mean rate of " + run.name + " on " +
                               std::string(kAxisNames[static_cast<std::size_t>(axis)]) + " is " +
                               forReading(meanDps, 1) + " dps but the reference is " +
                               forReading(run.referenceRateDps[axis], 1) +
                               " dps: was the table turning? Give its rate.");
        }
    }
}

SensorIdentity commonSensor(const std::vector<Run> &runs)
{
    SensorIdentity common;
    for (const Run &run : runs) {
        const SensorIdentity &sensor = run.recording->info.sensor;
        common.model = common.model.empty() ? sensor.model : common.model;
        common.serial = common.serial.empty() ? sensor.serial : common.serial;
    }
    return common;
}

} // namespace

Result<Campaign> makeCampaign(std::vector<Run> runs, const CampaignOptions &options)
{
    if (runs.empty())
        return Error{Errc::NothingUsable, "There are no runs; give at least one recording."};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (std::size_t j = i + 1; j < runs.size(); ++j) {
            if (Status fits = checkPair(runs[i], runs[j]); !fits)
                return fits.error();
        }
    }
    makeNamesUnique(runs);
    Campaign campaign;
    campaign.sensor = commonSensor(runs);
    campaign.runs = std::move(runs);
    if (Status units = checkUnits(campaign, campaign.warnings); !units)
        return units.error();
    if (Status reference = setReferenceRates(campaign, options); !reference)
        return reference.error();
    warnIfTurning(campaign, campaign.warnings);
    for (const Run &run : campaign.runs) {
        if (const std::string means = meansText(*run.recording); !means.empty())
            campaign.warnings.push_back(run.name + " is long. " + means);
    }
    return campaign;
}

} // namespace driftbench
