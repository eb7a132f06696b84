#include "engine/base/parallel_for.h"
#include "engine/base/random.h"
#include "engine/models/bp_network.h"
#include "engine/models/bp_problem.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>

namespace driftbench {

namespace {

constexpr double kCellWidthC = 1.0;

// The pooled cells of all runs, in the order of temperature.
struct Cells
{
    Eigen::MatrixXd quantities; // N x 2
    Eigen::MatrixX3d tdeDps;    // N x 3
    Eigen::VectorXd counts;     // N
};

Cells pooledCells(const TrainingSet &set)
{
    std::optional<ThermalCurve> pooled;
    for (const auto &run : set.runs) {
        const int factor = std::max(1, static_cast<int>(std::lround(kCellWidthC / run->curve.cellWidthC())));
        const ThermalCurve coarse = run->curve.coarsened(factor);
        if (pooled)
            pooled->merge(coarse);
        else
            pooled = coarse;
    }
    std::vector<const ThermalCell *> occupied;
    if (pooled) {
        for (const ThermalCell &cell : pooled->cells()) {
            if (cell.count > 0.0)
                occupied.push_back(&cell);
        }
    }
    const auto count = static_cast<Eigen::Index>(occupied.size());
    Cells cells{Eigen::MatrixXd(count, 2), Eigen::MatrixX3d(count, 3), Eigen::VectorXd(count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const ThermalCell &cell = *occupied[static_cast<std::size_t>(i)];
        cells.quantities.row(i) = cell.sumQuantities.head<2>().transpose() / cell.count;
        cells.tdeDps.row(i) = cell.meanTdeDps().transpose();
        cells.counts[i] = cell.count;
    }
    return cells;
}

// Hands the progress of starts that run side by side to one hook, one call at a time.
class SharedHook
{
public:
    SharedHook(const ProgressHook &hook, double steps) : m_hook(hook), m_steps(steps) {}

    Flow step(double count)
    {
        if (m_stopped)
            return Flow::Stop;
        if (!m_hook)
            return Flow::Continue;
        const std::lock_guard lock(m_mutex);
        m_done += count;
        if (!m_stopped && report(m_hook, "training the BP network", m_done / m_steps) == Flow::Stop)
            m_stopped = true;
        return m_stopped ? Flow::Stop : Flow::Continue;
    }

    bool stopped() const { return m_stopped; }

private:
    const ProgressHook &m_hook;
    double m_steps;
    double m_done = 0.0;
    std::mutex m_mutex;
    std::atomic<bool> m_stopped = false;
};

struct StartResult
{
    Eigen::VectorXd parameters;
    BpSummary::Start summary;
};

Termination terminationOf(const LevenbergMarquardtSummary &summary)
{
    if (summary.termination == LmTermination::Stopped)
        return Termination::Stopped;
    return summary.converged() ? Termination::Converged : Termination::IterationLimit;
}

StartResult trainOnce(const Eigen::MatrixXd &inputs, const Eigen::VectorXd &targets,
                      const Eigen::VectorXd &counts, const BpOptions &options, Random random,
                      SharedHook &hook)
{
    BpProblem cells(inputs, targets, counts, options.hiddenUnits);
    const LeastSquaresProblem problem{
        [&cells](const Eigen::VectorXd &p) { return cells.loss(p); },
        [&cells](const Eigen::VectorXd &p, NormalEquations &equations) { cells.linearise(p, equations); }};
    LevenbergMarquardtOptions lm;
    lm.iterations = options.iterations;
    lm.smallDecrease = 1e-9;
    StartResult result;
    result.parameters = cells.randomStart(random);
    const auto summary =
        minimise(problem, result.parameters, lm, [&](const Progress &) { return hook.step(1.0); });
    hook.step(options.iterations - summary.iterations);
    result.summary = {summary.finalLoss, summary.iterations, terminationOf(summary)};
    return result;
}

// What a network must give: mean 0, variance 1 over the training cells.
struct ScaledTargets
{
    Eigen::VectorXd values;
    double meanDps = 0.0;
    double scaleDps = 1.0;
};

ScaledTargets scaled(const Eigen::VectorXd &tdeDps, const Eigen::VectorXd &counts)
{
    const Standardiser standardiser = Standardiser::fit(tdeDps, counts);
    return {standardiser.transform(tdeDps), standardiser.mean[0], standardiser.scale[0]};
}

const StartResult &bestOf(const std::vector<StartResult> &results, std::size_t first, std::size_t count)
{
    std::size_t best = first;
    for (std::size_t i = first + 1; i < first + count; ++i) {
        if (results[i].summary.lossDps2 < results[best].summary.lossDps2)
            best = i;
    }
    return results[best];
}

Status check(const BpOptions &options)
{
    if (options.hiddenUnits < 1 || options.starts < 1 || options.iterations < 1)
        return Error{Errc::InvalidOption,
                     "The BP network needs at least one hidden unit, one start and one iteration."};
    return {};
}

} // namespace

Result<BpFit> fitBpNetwork(const TrainingSet &set, const BpOptions &options, const ProgressHook &hook)
{
    if (const Status status = check(options); !status)
        return status.error();
    const Cells cells = pooledCells(set);
    if (cells.counts.size() == 0)
        return Error{Errc::NothingUsable,
                     "There are no usable samples to train the BP network on; give it runs "
                     "that are not masked as a whole."};
    BpFit fit;
    fit.network.inputs = Standardiser::fit(cells.quantities, cells.counts);
    const Eigen::MatrixXd inputs = fit.network.inputs.transform(cells.quantities);
    std::array<ScaledTargets, 3> targets;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        targets[static_cast<std::size_t>(axis)] = scaled(cells.tdeDps.col(axis), cells.counts);

    const auto starts = static_cast<std::size_t>(options.starts);
    SharedHook shared(hook, 3.0 * options.starts * options.iterations);
    const Random seeded(options.seed);
    std::vector<StartResult> results(3 * starts);
    parallelFor(results.size(), options.threads, [&](std::size_t job) {
        results[job] =
            trainOnce(inputs, targets[job / starts].values, cells.counts, options, seeded.fork(job), shared);
    });
    if (shared.stopped())
        return Error{Errc::Cancelled, "Training the BP network was cancelled."};

    for (std::size_t axis = 0; axis < 3; ++axis) {
        const ScaledTargets &target = targets[axis];
        BpNetwork::Axis &network = fit.network.axes[axis];
        network = BpProblem::network(bestOf(results, axis * starts, starts).parameters);
        network.outputMeanDps = target.meanDps;
        network.outputScaleDps = target.scaleDps;
        for (std::size_t i = axis * starts; i < (axis + 1) * starts; ++i) {
            fit.summary.starts[axis].push_back(results[i].summary);
            fit.summary.starts[axis].back().lossDps2 *= target.scaleDps * target.scaleDps;
        }
    }
    return fit;
}

} // namespace driftbench
