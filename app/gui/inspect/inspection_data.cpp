#include "app/gui/inspect/inspection_data.h"

#include "engine/base/statistics.h"
#include "engine/evaluation/sweeps.h"
#include "engine/models/rbf_trainer.h"
#include "widgets/plot/decimation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

static constexpr int kCentresOfTheCurve = 12;
static constexpr double kGapInStripS = 0.0;
static constexpr Eigen::Index kMostExcludedDots = 4000;
static std::shared_ptr<const RunFeatures> thinnedRun(const RunFeatures &run, Eigen::Index most)
{
    const auto kept = thinned(run.timeS.size(), most);
    auto few = std::make_shared<RunFeatures>();
    const auto count = static_cast<Eigen::Index>(kept.size());
    few->name = run.name;
    few->timeS.resize(count);
    few->deltaT.resize(count);
    few->tdeDps.resize(count, 3);
    few->usableForTraining.resize(kept.size(), 1);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Index from = kept[static_cast<std::size_t>(i)];
        few->timeS[i] = run.timeS[from];
        few->deltaT[i] = run.deltaT[from];
        few->tdeDps.row(i) = run.tdeDps.row(from);
        if (static_cast<std::size_t>(from) < run.usableForTraining.size())
            few->usableForTraining[static_cast<std::size_t>(i)] =
                run.usableForTraining[static_cast<std::size_t>(from)];
    }
    return few;
}

static double lowestUsableC(const PreparedCampaign &prepared)
{
    double lowest = std::numeric_limits<double>::infinity();
    for (const PreparedRun &run : prepared.runs) {
        const Recording &recording = *run.checked.run.recording;
        for (Eigen::Index i = 0; i < recording.size(); ++i) {
            if (run.checked.run.mask.usableForJudging(i))
                lowest = std::min(lowest, recording.temperatureC[i]);
        }
    }
    return std::isfinite(lowest) ? lowest : 0.0;
}

// The campaign's features; where it is refused, those of each run that has any.
static TrainingSet featuresOf(const PreparedCampaign &prepared)
{
    if (!prepared.refusal)
        return prepared.loaded.features;
    TrainingSet set;
    set.referenceTemperatureC = lowestUsableC(prepared);
    for (const PreparedRun &run : prepared.runs)
        set.runs.push_back(
            std::make_shared<const RunFeatures>(makeRunFeatures(run.checked.run, set.referenceTemperatureC)));
    return set;
}

static void addRuns(InspectionData &seen, const TrainingSet &set)
{
    Eigen::Index total = 0;
    for (const auto &run : set.runs)
        total += run->timeS.size();
    double stripS = 0.0;
    for (std::size_t r = 0; r < seen.prepared->runs.size() && r < set.runs.size(); ++r) {
        const PreparedRun &from = seen.prepared->runs[r];
        const RunFeatures &features = *set.runs[r];
        const Recording &recording = *from.checked.run.recording;
        InspectedRun run;
        run.id = from.id;
        run.name = from.checked.run.name;
        run.firstS = recording.empty() ? 0.0 : recording.timeS[0];
        run.lastS = recording.empty() ? 0.0 : recording.timeS[recording.size() - 1];
        run.stripStartS = stripS;
        const Eigen::Index share =
            total > kInspectedDots ? std::max<Eigen::Index>(1, kInspectedDots * features.timeS.size() / total)
                                   : features.timeS.size();
        run.dots = thinnedRun(features, share);
        for (const Sweep &sweep : sweepsOf(features))
            (sweep.heating ? run.heating : run.cooling) = true;
        stripS = run.stripEndS() + kGapInStripS;
        seen.samples += recording.samples();
        if (!recording.points.empty())
            seen.samplesAPoint = std::max(seen.samplesAPoint, recording.points.samples.maxCoeff());
        if (r == 0 && recording.size() > 1 && run.lastS > run.firstS)
            seen.sampleRateHz = double(recording.samples() - 1) / (run.lastS - run.firstS);
        seen.runs.push_back(std::move(run));
    }
    seen.stripSpanS = stripS;
}

// The first reason by which a sample is out; the user's own comes first.
static std::optional<MaskReason> reasonOf(const Mask &mask, Eigen::Index sample)
{
    if (mask.usableForTraining(sample))
        return std::nullopt;
    if (mask.has(sample, MaskReason::Excluded))
        return MaskReason::Excluded;
    for (const MaskReason reason : kMaskReasons) {
        if (mask.has(sample, reason))
            return reason;
    }
    return std::nullopt;
}

static std::int64_t samplesAt(const Recording &recording, Eigen::Index row)
{
    return recording.points.empty() ? 1 : recording.points.samples[row];
}

static void addOwnStretches(InspectionData &seen, std::size_t r)
{
    const RunInPlan *plan = seen.prepared->plan.find(seen.runs[r].id);
    const Recording &recording = *seen.prepared->runs[r].checked.run.recording;
    for (std::size_t i = 0; plan && i < plan->excluded.size(); ++i) {
        const Exclusion &exclusion = plan->excluded[i];
        std::int64_t samples = 0;
        for (Eigen::Index row = 0; row < recording.size(); ++row) {
            const double timeS = recording.timeS[row];
            if (timeS >= exclusion.range.startS && timeS <= exclusion.range.endS)
                samples += samplesAt(recording, row);
        }
        seen.excluded.push_back(
            {r, exclusion.range.startS, exclusion.range.endS, samples, exclusion.note, i, false});
    }
}

// Neighbours by the same reason are a stretch; outliers are single samples all over a run, and one row.
static void addCheckedStretches(InspectionData &seen, std::size_t r)
{
    const Run &run = seen.prepared->runs[r].checked.run;
    const Eigen::VectorXd &timeS = run.recording->timeS;
    std::optional<MaskReason> before;
    std::int64_t outliers = 0;
    for (Eigen::Index i = 0; i < run.mask.size(); ++i) {
        const auto reason = reasonOf(run.mask, i);
        const std::int64_t samples = samplesAt(*run.recording, i);
        if (reason)
            seen.excludedSamples += samples;
        if (reason == MaskReason::Outlier) {
            outliers += samples;
        } else if (reason && reason != MaskReason::Excluded) {
            if (before == reason && seen.excluded.back().run == r && !seen.excluded.back().own) {
                seen.excluded.back().endS = timeS[i];
                seen.excluded.back().samples += samples;
            } else {
                seen.excluded.push_back({r, timeS[i], timeS[i], samples, std::string(maskReasonName(*reason)),
                                         std::nullopt, false});
            }
        }
        before = reason;
    }
    if (outliers > 0)
        seen.excluded.push_back({r, seen.runs[r].firstS, seen.runs[r].lastS, outliers,
                                 std::string(maskReasonName(MaskReason::Outlier)), std::nullopt, true});
}

static void addExcludedDots(InspectionData &seen)
{
    std::vector<std::pair<std::size_t, Eigen::Index>> all;
    for (std::size_t r = 0; r < seen.runs.size(); ++r) {
        const Mask &mask = seen.prepared->runs[r].checked.run.mask;
        for (Eigen::Index i = 0; i < mask.size(); ++i) {
            if (!mask.usableForJudging(i)) // outliers are among the dots
                all.emplace_back(r, i);
        }
    }
    const auto kept = thinned(static_cast<Eigen::Index>(all.size()), kMostExcludedDots);
    const auto count = static_cast<Eigen::Index>(kept.size());
    ExcludedDots &dots = seen.excludedDots;
    dots.timeS.resize(count);
    dots.deltaT.resize(count);
    dots.tdeDps.resize(count, 3);
    for (Eigen::Index k = 0; k < count; ++k) {
        const auto &[r, i] = all[static_cast<std::size_t>(kept[static_cast<std::size_t>(k)])];
        const Run &run = seen.prepared->runs[r].checked.run;
        dots.run.push_back(r);
        dots.timeS[k] = run.recording->timeS[i];
        dots.deltaT[k] = run.recording->temperatureC[i] - seen.referenceTemperatureC;
        dots.tdeDps.row(k) = run.recording->rateDps.row(i) - run.referenceRateDps.transpose();
    }
}

static void addCurve(InspectionData &seen, const TrainingSet &set,
                     const std::shared_ptr<const TrainedModel> &model, const ProgressHook &hook)
{
    const bool sameReference =
        model && std::abs(model->referenceTemperatureC - set.referenceTemperatureC) < 1e-9;
    AnyModel curve;
    if (sameReference) {
        curve = model->model;
    } else {
        RbfOptions options;
        options.largestNumberOfCentres = kCentresOfTheCurve;
        auto fitted = fitRbfNetwork(set, options, hook);
        if (!fitted)
            return; // too few samples, say; the refusal says which
        curve = std::move(fitted->network);
    }
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const auto &run : set.runs) {
        if (run->deltaT.size() == 0)
            continue;
        lowest = std::min(lowest, run->deltaT.minCoeff());
        highest = std::max(highest, run->deltaT.maxCoeff());
    }
    if (!(lowest < highest))
        return;
    ModelCurve drawn;
    drawn.name = sameReference ? model->name : "rbf";
    drawn.deltaT = curveGrid(lowest, highest);
    drawn.tdeDps = predictAtDeltaT(curve, drawn.deltaT);
    seen.curve = std::move(drawn);
    seen.inspection = inspectCampaign(set, curve);
}

static void addDensity(InspectionData &seen, const TrainingSet &set)
{
    Eigen::Index samples = 0;
    for (const auto &run : set.runs)
        samples += run->deltaT.size();
    if (samples >= kDensityFrom)
        seen.density =
            std::make_shared<const TcqDensity>(tcqDensity(set.runs, seen.curve ? &*seen.curve : nullptr));
}

static void addOverTime(InspectionData &seen, const TrainingSet &set)
{
    for (std::size_t r = 0; r < seen.runs.size(); ++r) {
        const TcqTimeTraces ofRun = tcqTimeTraces(*set.runs[r]);
        if (set.runs[r]->timeS.size() == 0)
            continue;
        const double shiftS = seen.runs[r].toStrip(set.runs[r]->timeS[0]);
        for (std::size_t i = 0; i < ofRun.traces.size(); ++i) {
            Envelope &all = seen.overTime.traces[i];
            if (!all.key.isEmpty()) { // the line does not go from run to run
                all.key.append(shiftS);
                for (QVector<double> *values : {&all.low, &all.high, &all.mean})
                    values->append(kNaN);
            }
            for (const double key : ofRun.traces[i].key)
                all.key.append(key + shiftS);
            all.low += ofRun.traces[i].low;
            all.high += ofRun.traces[i].high;
            all.mean += ofRun.traces[i].mean;
        }
    }
    seen.overTime.spanS = seen.stripSpanS;
}

Result<InspectionData> inspect(const std::shared_ptr<const PreparedCampaign> &prepared,
                               const std::shared_ptr<const TrainedModel> &model, const ProgressHook &hook)
{
    const auto goOn = [&](double fraction) {
        return report(hook, "looking at the runs", fraction) == Flow::Continue;
    };
    const Error stopped{Errc::Cancelled, "Looking at the runs was cancelled."};
    InspectionData seen;
    seen.prepared = prepared;
    const TrainingSet set = featuresOf(*prepared);
    seen.referenceTemperatureC = set.referenceTemperatureC;
    if (!goOn(0.2))
        return stopped;
    addRuns(seen, set);
    for (const PreparedRun &run : prepared->runs)
        seen.simulated = seen.simulated || run.checked.run.recording->info.simulated;
    for (std::size_t r = 0; r < seen.runs.size(); ++r) {
        addOwnStretches(seen, r);
        addCheckedStretches(seen, r);
    }
    addExcludedDots(seen);
    if (!goOn(0.5))
        return stopped;
    addCurve(seen, set, model, hook);
    if (!goOn(0.8))
        return stopped;
    addDensity(seen, set);
    addOverTime(seen, set);
    return seen;
}

bool InspectionJob::start(std::shared_ptr<const PreparedCampaign> prepared,
                          std::shared_ptr<const TrainedModel> model)
{
    return run([this, prepared = std::move(prepared),
                model = std::move(model)](const ProgressHook &hook) -> Deliver {
        auto made = inspect(prepared, model, hook);
        std::shared_ptr<const InspectionData> seen;
        if (made)
            seen = std::make_shared<const InspectionData>(*std::move(made));
        return [this, seen] { emit finished(seen); };
    });
}

} // namespace driftbench
