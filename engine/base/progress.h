// The one hook for progress and cancel of every long engine function: progress goes in, the wish to go on or
// to stop comes out. An empty hook means: nobody watches, go on.
#pragma once

#include <functional>
#include <string_view>

namespace driftbench {

struct Progress
{
    std::string_view stage; // what is being done, for a person
    double fraction = 0.0;  // 0..1 of the whole
};

enum class Flow
{
    Continue,
    Stop
};

using ProgressHook = std::function<Flow(const Progress &)>;

inline Flow report(const ProgressHook &hook, std::string_view stage, double fraction)
{
    return hook ? hook(Progress{stage, fraction}) : Flow::Continue;
}

} // namespace driftbench
