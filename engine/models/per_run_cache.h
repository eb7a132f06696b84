// A value worked out once for each run and shared between threads.
#pragma once

#include "engine/features/run_features.h"

#include <map>
#include <memory>
#include <mutex>

namespace driftbench {

template <class T>
class PerRunCache
{
public:
    // make(run) runs once for each run; whoever asks for the same run meanwhile waits for it.
    template <class Make>
    const T &get(const std::shared_ptr<const RunFeatures> &run, const Make &make)
    {
        Entry &entry = entryOf(run);
        std::call_once(entry.once, [&] { entry.value = make(*run); });
        return entry.value;
    }

private:
    struct Entry
    {
        std::once_flag once;
        T value;
    };

    Entry &entryOf(const std::shared_ptr<const RunFeatures> &run)
    {
        const std::lock_guard lock(m_mutex);
        return m_entries[run];
    }

    std::mutex m_mutex;
    // Owning the run keeps its address from being given to another one. Entries never move.
    std::map<std::shared_ptr<const RunFeatures>, Entry> m_entries;
};

} // namespace driftbench
