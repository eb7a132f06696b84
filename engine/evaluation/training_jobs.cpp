#include "engine/evaluation/training_jobs.h"

#include "engine/base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
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

// Tells when the last job of a recipe is done.
class RecipeCount
{
public:
    RecipeCount(std::size_t recipes, std::size_t jobsEach, const OnRecipeTrained &onTrained)
        : m_left(recipes, jobsEach), m_seconds(recipes, 0.0), m_onTrained(onTrained)
    {
    }

    void jobDone(std::size_t recipe, double seconds)
    {
        const std::lock_guard lock(m_mutex);
        m_seconds[recipe] += seconds;
        if (--m_left[recipe] == 0 && m_onTrained)
            m_onTrained(recipe, m_seconds[recipe]);
    }

private:
    std::mutex m_mutex;
    std::vector<std::size_t> m_left;
    std::vector<double> m_seconds;
    const OnRecipeTrained &m_onTrained;
};

using JobResults = std::vector<std::optional<Result<FittedModel>>>; // [recipe * sets + set]

// Every job of the recipe has a model.
bool isFinished(const JobResults &results, std::size_t recipe, std::size_t sets)
{
    for (std::size_t set = 0; set < sets; ++set) {
        const auto &result = results[recipe * sets + set];
        if (!result || !result->ok())
            return false;
    }
    return true;
}

// A job that was stopped has no failure of its own.
const Error *firstFailure(const JobResults &results, std::size_t recipes, std::size_t sets, bool stopped)
{
    for (std::size_t set = 0; set < sets; ++set) {
        for (std::size_t recipe = 0; recipe < recipes; ++recipe) {
            const auto &result = results[recipe * sets + set];
            if (result && !result->ok() && !(stopped && result->error().code == Errc::Cancelled))
                return &result->error();
        }
    }
    return nullptr;
}

} // namespace

Result<TrainedRecipes> trainAll(const std::vector<ModelRecipe> &recipes, const std::vector<TrainingSet> &sets,
                                int threads, const ProgressHook &hook, const OnRecipeTrained &onTrained)
{
    using Clock = std::chrono::steady_clock;
    const std::size_t jobs = recipes.size() * sets.size();
    JobResults results(jobs);
    JobProgress progress(hook, jobs);
    RecipeCount count(recipes.size(), sets.size(), onTrained);
    const ProgressHook jobHook = progress.hookForJob();
    parallelFor(jobs, threads, [&](std::size_t job) {
        const std::size_t place = job / sets.size();
        const auto start = Clock::now();
        if (jobHook({"Training " + recipes[place].name, 0.0}) == Flow::Continue)
            results[job] = recipes[place].fit(sets[job % sets.size()], jobHook);
        progress.jobDone();
        if (results[job] && results[job]->ok())
            count.jobDone(place, std::chrono::duration<double>(Clock::now() - start).count());
    });
    if (const Error *failure = firstFailure(results, recipes.size(), sets.size(), progress.stopped()))
        return *failure;
    TrainedRecipes trained;
    trained.models.resize(sets.size());
    for (std::size_t recipe = 0; recipe < recipes.size(); ++recipe) {
        if (!isFinished(results, recipe, sets.size())) {
            trained.unfinished.push_back(recipes[recipe].name);
            continue;
        }
        trained.recipes.push_back(recipes[recipe]);
        for (std::size_t set = 0; set < sets.size(); ++set)
            trained.models[set].push_back(std::move(*results[recipe * sets.size() + set]).value());
    }
    return trained;
}

} // namespace driftbench
