// A SQLite VFS that lets the system's do the work and fails on demand: writes, syncs and truncations of the
// database and of its log are counted, and the n-th of them fails, once or from then on.
#pragma once

#include <cstdint>
#include <string>

namespace driftbench::test {

enum class Fault
{
    None,
    DiskFull,   // a write finds no room
    WriteError, // a write fails
    TornWrite,  // half of it reaches the file, then it fails
    SyncError,  // a sync fails
    AnyError,   // whatever comes: a write, a sync or a truncation
};

inline constexpr const char *kFaultVfs = "driftbench-faults";

void registerFaultVfs(bool asDefault = false); // once or more; as default: for files that name no VFS as well
// The n-th operation of that kind from now on (1: the next) fails; once, or also all after it. under: only of
// files whose path begins so.
void injectFault(Fault fault, std::int64_t at, bool lasting, const std::string &under = {});
void clearFaults();
bool faultHappened(); // since it was injected

} // namespace driftbench::test
