#include "engine/models/rbf_trainer.h"

#include "engine/base/parallel_for.h"
#include "engine/models/rbf_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

namespace driftbench {

namespace {

// A difference of losses below this part of the noise variance is no difference.
constexpr double kNegligibleLoss = 1e-4;
// A held-out cell counts only where training data lie within this distance.
constexpr double kReachC = 1.0;
constexpr int kBlockFolds = 5;
// Widths that the preset `paper` tries, in standardised TCQ units.
constexpr std::array<double, 4> kPaperWidths{0.2, 0.3, 0.4, 1.0};
// Without linear terms the Gaussians carry the line as well, far above the noise, and a ridge of a whole
// sample costs more than it saves.
constexpr double kPaperRidge = 0.01;

std::vector<RbfPathOptions> pathVariants(const RbfOptions &options)
{
    RbfPathOptions common;
    common.levels = options.levels;
    common.largestNumberOfCentres = options.largestNumberOfCentres;
    common.ridge = options.ridge;
    common.inputs = options.inputs;
    if (options.preset == RbfPreset::Best)
        return {common};
    std::vector<RbfPathOptions> variants;
    for (const double width : kPaperWidths) {
        common.linearTerms = false;
        common.ridge = kPaperRidge * options.ridge;
        common.standardisedWidth = width;
        variants.push_back(common);
    }
    return variants;
}

// The losses of one fold: what its path, trained without the fold, leaves on it and on its own cells.
struct FoldLosses
{
    Eigen::MatrixX3d heldOut;
    Eigen::MatrixX3d training;
    bool counts = false; // false: no held-out cell lies near training data
};

// The rows of `rows` that lie within reach of occupied training rows.
ThermalRows withinReach(const ThermalRows &rows, const ThermalRows &training)
{
    std::vector<Eigen::Index> kept;
    Eigen::Index nearest = 0;
    const auto trained = training.deltaT();
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
        const double d = rows.deltaT()[i];
        while (nearest + 1 < training.size() &&
               std::abs(trained[nearest + 1] - d) <= std::abs(trained[nearest] - d))
            ++nearest;
        if (std::abs(trained[nearest] - d) <= kReachC)
            kept.push_back(i);
    }
    return {rows.quantities(kept, Eigen::all), rows.tdeDps(kept, Eigen::all), rows.count(kept)};
}

FoldLosses foldLosses(const RbfPath &path, const ThermalCurve &heldOut, bool removeOffset)
{
    const ThermalRows scored = withinReach(thermalRows(heldOut, trainingGridFactor(heldOut)), path.rows);
    FoldLosses losses;
    losses.counts = scored.size() > 0;
    if (losses.counts) {
        losses.heldOut = prefixLosses(path, scored, removeOffset);
        losses.training = prefixLosses(path, path.rows, false);
    }
    return losses;
}

// The smallest number of centres whose loss is within a paired standard error of the lowest mean loss. Two
// folds give no standard error worth the name (one degree of freedom); there the lowest loss itself decides.
int chooseNumber(const std::vector<FoldLosses> &folds, int axis, int most)
{
    const auto count = static_cast<double>(folds.size());
    std::vector<double> meanLoss(static_cast<std::size_t>(most) + 1, 0.0);
    for (int k = 0; k <= most; ++k) {
        for (const FoldLosses &fold : folds)
            meanLoss[static_cast<std::size_t>(k)] += fold.heldOut(k, axis) / count;
    }
    const int lowest =
        static_cast<int>(std::min_element(meanLoss.begin(), meanLoss.end()) - meanLoss.begin());
    for (int k = 0; k < lowest; ++k) {
        double squares = 0.0;
        const double difference =
            meanLoss[static_cast<std::size_t>(k)] - meanLoss[static_cast<std::size_t>(lowest)];
        for (const FoldLosses &fold : folds) {
            const double deviation = fold.heldOut(k, axis) - fold.heldOut(lowest, axis) - difference;
            squares += deviation * deviation;
        }
        const double standardError = count > 2.0 ? std::sqrt(squares / (count - 1.0) / count) : 0.0;
        if (difference <= std::max(standardError, kNegligibleLoss))
            return k;
    }
    return lowest;
}

struct Selected
{
    RbfSelection selection;
    double loss = 0.0; // at the chosen numbers, summed over the axes
};

Selected select(std::vector<FoldLosses> folds, const RbfOptions &options, bool leftOutRuns)
{
    std::erase_if(folds, [](const FoldLosses &fold) { return !fold.counts; });
    Selected result;
    result.selection.leftOutRuns = leftOutRuns;
    result.selection.chosen.fill(std::max(0, options.centres));
    if (folds.empty())
        return result;
    Eigen::Index most = folds.front().heldOut.rows() - 1;
    for (const FoldLosses &fold : folds)
        most = std::min(most, fold.heldOut.rows() - 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto column = static_cast<Eigen::Index>(axis);
        for (Eigen::Index k = 0; k <= most; ++k) {
            double heldOut = 0.0;
            double training = 0.0;
            double lowest = std::numeric_limits<double>::infinity();
            double highest = -lowest;
            for (const FoldLosses &fold : folds) {
                lowest = std::min(lowest, fold.heldOut(k, column));
                highest = std::max(highest, fold.heldOut(k, column));
                heldOut += fold.heldOut(k, column) / static_cast<double>(folds.size());
                training += fold.training(k, column) / static_cast<double>(folds.size());
            }
            result.selection.heldOutLoss[axis].push_back(heldOut);
            result.selection.trainingLoss[axis].push_back(training);
            result.selection.heldOutLowest[axis].push_back(lowest);
            result.selection.heldOutHighest[axis].push_back(highest);
        }
        if (options.centres < 0)
            result.selection.chosen[axis] =
                chooseNumber(folds, static_cast<int>(axis), static_cast<int>(most));
        const auto chosen = std::min<std::size_t>(static_cast<std::size_t>(result.selection.chosen[axis]),
                                                  static_cast<std::size_t>(most));
        result.loss += result.selection.heldOutLoss[axis][chosen];
    }
    return result;
}

// A single run is cut into temperature blocks; every fifth block is one fold.
std::pair<ThermalCurve, ThermalCurve> blockFold(const ThermalCurve &curve, int fold)
{
    const double gridC = trainingGridFactor(curve) * curve.cellWidthC();
    const double blockC = std::max((curve.highestDeltaT() - curve.lowestDeltaT()) / 64.0, 4.0 * gridC);
    std::pair<ThermalCurve, ThermalCurve> parts{ThermalCurve(curve.cellWidthC()),
                                                ThermalCurve(curve.cellWidthC())};
    ThermalCurve &training = parts.first;
    ThermalCurve &heldOut = parts.second;
    for (std::size_t i = 0; i < curve.cells().size(); ++i) {
        if (curve.cells()[i].count == 0.0)
            continue;
        const double above = curve.cellCentreC(i) - curve.cellCentreC(0);
        const bool out = static_cast<int>(above / blockC) % kBlockFolds == fold;
        (out ? heldOut : training).addCell(curve.firstKey() + static_cast<std::int64_t>(i), curve.cells()[i]);
    }
    return parts;
}

} // namespace

class RbfPathCache
{
public:
    RbfPath path(const TrainingSet &set, std::size_t variant, const RbfPathOptions &options)
    {
        Key key{variant, {}};
        for (const auto &run : set.runs)
            key.second.push_back(run.get());
        std::shared_ptr<Slot> slot;
        {
            const std::lock_guard lock(m_mutex);
            auto &entry = m_slots[key];
            if (!entry)
                entry = std::make_shared<Slot>();
            slot = entry;
        }
        std::call_once(slot->once, [&] { slot->path = makeRbfPath(set, options); });
        return slot->path;
    }

private:
    struct Slot
    {
        std::once_flag once;
        RbfPath path;
    };
    using Key = std::pair<std::size_t, std::vector<const RunFeatures *>>;

    std::mutex m_mutex;
    std::map<Key, std::shared_ptr<Slot>> m_slots;
};

std::shared_ptr<RbfPathCache> makeRbfPathCache()
{
    return std::make_shared<RbfPathCache>();
}

namespace {

// Folds of one variant. Runs left out where there are several, else temperature blocks.
FoldLosses lossesOfFold(const TrainingSet &set, std::size_t variant, const RbfPathOptions &options,
                        std::size_t fold, RbfPathCache &cache)
{
    if (set.runs.size() > 1) {
        const RbfPath path = cache.path(set.without(fold), variant, options);
        return foldLosses(path, set.runs[fold]->curve, true);
    }
    const auto [training, heldOut] = blockFold(set.runs.front()->curve, static_cast<int>(fold));
    if (training.empty() || heldOut.empty())
        return {};
    return foldLosses(makeRbfPath(training, pooledNoiseVariance(set), options), heldOut, false);
}

RbfFit finish(const RbfPath &path, Selected selected)
{
    RbfFit fit;
    for (int &chosen : selected.selection.chosen)
        chosen = std::min(chosen, path.size());
    fit.network = networkOf(path, selected.selection.chosen);
    fit.selection = std::move(selected.selection);
    fit.centreDeltaT = path.centreDeltaT;
    fit.widthDeltaT = path.widthDeltaT;
    fit.runOffsetDps = path.runOffsetDps;
    if (path.groups > 1) {
        fit.warnings.push_back(
            "The runs fall into " + std::to_string(path.groups) +
            " groups that share no temperature, so their biases can't be told from the drift. "
            "Record a run that spans them.");
    }
    return fit;
}

} // namespace

Result<RbfFit> fitRbfNetwork(const TrainingSet &set, const RbfOptions &options, const ProgressHook &hook,
                             const std::shared_ptr<RbfPathCache> &sharedCache)
{
    std::size_t samples = 0;
    for (const auto &run : set.runs)
        samples += static_cast<std::size_t>(run->curve.totalCount());
    if (samples < 2)
        return Error{Errc::TooFewSamples,
                     "The RBF network has no samples to learn from. Record a longer run."};

    if (!options.inputs[0])
        return Error{Errc::InvalidOption, "The RBF network needs ΔT among its inputs: take it in."};

    const auto cache = sharedCache ? sharedCache : makeRbfPathCache();
    const std::vector<RbfPathOptions> variants = pathVariants(options);
    const bool byRuns = set.runs.size() > 1;
    const std::size_t folds = byRuns ? set.runs.size() : static_cast<std::size_t>(kBlockFolds);
    std::vector<std::vector<FoldLosses>> losses(variants.size(), std::vector<FoldLosses>(folds));
    for (std::size_t v = 0; v < variants.size(); ++v) {
        const double done = static_cast<double>(v) / static_cast<double>(variants.size());
        if (report(hook, "RBF network: choosing the number of centres", done) == Flow::Stop)
            return Error{Errc::Cancelled, "Training of the RBF network was stopped."};
        parallelFor(folds, options.threads, [&](std::size_t fold) {
            losses[v][fold] = lossesOfFold(set, v, variants[v], fold, *cache);
        });
    }
    std::size_t best = 0;
    Selected selected;
    for (std::size_t v = 0; v < variants.size(); ++v) {
        Selected candidate = select(std::move(losses[v]), options, byRuns);
        if (v == 0 || candidate.loss < selected.loss) {
            best = v;
            selected = std::move(candidate);
        }
    }
    return finish(cache->path(set, best, variants[best]), std::move(selected));
}

} // namespace driftbench
