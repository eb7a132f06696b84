#include "app/session/temporary_database.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace driftbench {

namespace {

Error cannotMake(const std::filesystem::path &target, int errorNumber)
{
    if (errorNumber == EEXIST)
        return {Errc::OutputNotWritable,
                target.string() + " exists already. Open it, or choose another name."};
    if (errorNumber == ENOSPC || errorNumber == EDQUOT)
        return {Errc::OutputFull, target.string() + " was not made: no room is left on its disk. Make room."};
    return {Errc::OutputNotWritable, target.string() +
                                         " can't be made: " + std::generic_category().message(errorNumber) +
                                         ". Choose a folder that you may write to."};
}

} // namespace

Result<TemporaryDatabase> TemporaryDatabase::beside(const std::filesystem::path &target)
{
    std::string name = (target.parent_path() / ("." + target.filename().string() + ".XXXXXX")).string();
    const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor < 0)
        return cannotMake(target, errno);
    // mkostemp makes the file private; the result should have the permissions of any new file.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    const bool permitted = ::fchmod(descriptor, 0666 & ~mask) == 0;
    const int errorNumber = errno;
    ::close(descriptor);
    TemporaryDatabase made(target, name);
    if (!permitted)
        return cannotMake(target, errorNumber);
    return made;
}

TemporaryDatabase::TemporaryDatabase(TemporaryDatabase &&other) noexcept
    : m_target(std::move(other.m_target)), m_path(std::exchange(other.m_path, {}))
{
}

TemporaryDatabase::~TemporaryDatabase()
{
    if (m_path.empty())
        return;
    for (const char *ending : {"", "-wal", "-shm", "-journal"})
        ::unlink((m_path.string() + ending).c_str());
}

Status TemporaryDatabase::syncFolder() const
{
    const auto folder = m_target.has_parent_path() ? m_target.parent_path() : std::filesystem::path(".");
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return cannotMake(m_target, errno);
    // Some file systems can't sync a folder, and need not.
    ::fsync(descriptor);
    ::close(descriptor);
    return {};
}

Status TemporaryDatabase::replaceTarget()
{
    return ::rename(m_path.c_str(), m_target.c_str()) == 0 ? syncFolder()
                                                           : Status(cannotMake(m_target, errno));
}

Status TemporaryDatabase::becomeTarget()
{
    // link() refuses to replace what another program put there meanwhile, but not every file system has it.
    if (::link(m_path.c_str(), m_target.c_str()) == 0)
        return syncFolder();
    return errno == EEXIST ? Status(cannotMake(m_target, errno)) : replaceTarget();
}

} // namespace driftbench
