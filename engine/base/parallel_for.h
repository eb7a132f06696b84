// The only place in the engine with threads.
#pragma once

#include <cstddef>
#include <functional>

namespace driftbench {

// Calls body(0) .. body(count - 1), each exactly once, on up to threadCount threads (0: one per core), and
// returns when all are done. Each call must write only to its own slot, so that results do not depend on the
// number of threads. body must not throw.
void parallelFor(std::size_t count, int threadCount, const std::function<void(std::size_t)> &body);

} // namespace driftbench
