#include "engine/base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace driftbench {

void parallelFor(std::size_t count, int threadCount, const std::function<void(std::size_t)> &body)
{
    const auto wanted = threadCount > 0 ? static_cast<std::size_t>(threadCount)
                                        : std::max<std::size_t>(1, std::thread::hardware_concurrency());
    const std::size_t threads = std::min(count, wanted);
    if (threads <= 1) {
        for (std::size_t i = 0; i < count; ++i)
            body(i);
        return;
    }
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            body(i);
    };
    std::vector<std::jthread> helpers;
    for (std::size_t t = 1; t < threads; ++t)
        helpers.emplace_back(work);
    work();
}

} // namespace driftbench
