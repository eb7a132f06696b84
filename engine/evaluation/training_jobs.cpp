#include "engine/evaluation/training_jobs.h"

#include "engine/base/parallel_for.h"

#include <atomic>
#include <optional>
#include <thread>

namespace driftbench {

namespace {

// Jobs run on several threads, the hook only where it was given.
class JobProgress
{
public:
    JobProgress(const ProgressHook &hook, std::size_t jobs) : m_hook(hook), m_jobs(jobs) {}

    bool stopped() const { return m_stopped; }
    void jobDone() { ++m_done; }

    ProgressHook hookForJob()
    {
        return [this](const Progress &inner) {
            if (std::this_thread::get_id() == m_caller) {
                const double done = static_cast<double>(m_done) + inner.fraction;
                if (report(m_hook, inner.stage, std::min(1.0, done / static_cast<double>(m_jobs))) ==
                    Flow::Stop)
                    m_stopped = true;
            }
            return m_stopped ? Flow::Stop : Flow::Continue;
        };
    }

private:
    const ProgressHook &m_hook;
    std::size_t m_jobs;
    std::thread::id m_caller = std::this_thread::get_id();
    std::atomic<std::size_t> m_done{0};
    std::atomic<bool> m_stopped{false};
};

} // namespace

Result<std::vector<std::vector<FittedModel>>> trainAll(const std::vector<ModelRecipe> &recipes,
                                                       const std::vector<TrainingSet> &sets, int threads,
                                                       const ProgressHook &hook)
{
    const std::size_t jobs = recipes.size() * sets.size();
    std::vector<std::optional<Result<FittedModel>>> results(jobs);
    JobProgress progress(hook, jobs);
    const ProgressHook jobHook = progress.hookForJob();
    parallelFor(jobs, threads, [&](std::size_t job) {
        const ModelRecipe &recipe = recipes[job % recipes.size()];
        if (jobHook({"Training " + recipe.name, 0.0}) == Flow::Continue)
            results[job] = recipe.fit(sets[job / recipes.size()], jobHook);
        progress.jobDone();
    });
    if (progress.stopped())
        return Error{Errc::Cancelled, "The training was stopped before it was done; nothing was written."};
    std::vector<std::vector<FittedModel>> models(sets.size());
    for (std::size_t job = 0; job < jobs; ++job) {
        if (!results[job]->ok())
            return results[job]->error();
        models[job / recipes.size()].push_back(std::move(*results[job]).value());
    }
    return models;
}

} // namespace driftbench
