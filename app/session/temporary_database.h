// A database file under a hidden name beside its target, until it is put in place; whatever cuts it off
// before leaves the target as it was.
#pragma once

#include "engine/base/result.h"

#include <filesystem>

namespace driftbench {

class TemporaryDatabase
{
public:
    // OutputNotWritable, OutputFull.
    static Result<TemporaryDatabase> beside(const std::filesystem::path &target);

    TemporaryDatabase(TemporaryDatabase &&other) noexcept;
    TemporaryDatabase &operator=(TemporaryDatabase &&other) = delete;
    TemporaryDatabase(const TemporaryDatabase &) = delete;
    TemporaryDatabase &operator=(const TemporaryDatabase &) = delete;
    ~TemporaryDatabase(); // with what SQLite left beside it

    const std::filesystem::path &path() const { return m_path; }

    // Once no connection has it open.
    Status replaceTarget();
    Status becomeTarget(); // OutputNotWritable if the target exists

private:
    TemporaryDatabase(std::filesystem::path target, std::filesystem::path path)
        : m_target(std::move(target)), m_path(std::move(path))
    {
    }
    Status syncFolder() const;

    std::filesystem::path m_target;
    std::filesystem::path m_path; // empty once moved from
};

} // namespace driftbench
