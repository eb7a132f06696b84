// Which program writes to a session file: an advisory lock of the kernel on a small file beside it
// (name.driftbench-lock, with the id of the program for messages). The kernel takes the lock back whenever
// the program ends, so there are no stale ones; a lock file left by a killed program means nothing.
//
// Why not a lock on the session file itself: closing any descriptor of a file drops the POSIX locks that
// SQLite holds on it in the same program.
#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <memory>
#include <string>

namespace driftbench {

class SessionLock
{
public:
    // SessionInUse with the other program's id, OutputNotWritable where no lock file can be made.
    static Result<std::shared_ptr<SessionLock>> acquire(const std::filesystem::path &session);

    // Whether a program has it now. Also true where that can't be told.
    static bool isHeld(const std::filesystem::path &session);

    SessionLock(const SessionLock &) = delete;
    SessionLock &operator=(const SessionLock &) = delete;
    ~SessionLock();

private:
    SessionLock(std::filesystem::path file, int descriptor)
        : m_file(std::move(file)), m_descriptor(descriptor)
    {
    }

    std::filesystem::path m_file;
    int m_descriptor;
};

} // namespace driftbench
