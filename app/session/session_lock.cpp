#include "app/session/session_lock.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace driftbench {

namespace {

constexpr int kMostTries = 1000;

// Whether the locked file is still the one of that name: its last owner removes it.
bool stillThere(int descriptor, const std::filesystem::path &file)
{
    struct stat locked
    {
    };
    struct stat named
    {
    };
    return ::fstat(descriptor, &locked) == 0 && ::stat(file.c_str(), &named) == 0 &&
           locked.st_ino == named.st_ino && locked.st_dev == named.st_dev;
}

std::string ownerOf(int descriptor)
{
    std::array<char, 32> text{};
    const ssize_t size = ::pread(descriptor, text.data(), text.size() - 1, 0);
    const std::string owner(text.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
    return owner.empty() ? "another program" : "another program (process " + owner + ")";
}

std::filesystem::path lockFileOf(const std::filesystem::path &session)
{
    std::filesystem::path file = session;
    file += "-lock";
    return file;
}

// isHeld() of another program takes it shared for a moment.
bool onlyAskedFor(int descriptor)
{
    return ::flock(descriptor, LOCK_SH | LOCK_NB) == 0;
}

Error cannotLock(const std::filesystem::path &session, int errorNumber)
{
    return {Errc::OutputNotWritable, session.string() +
                                         " is opened read-only: no lock file can be made beside it (" +
                                         std::generic_category().message(errorNumber) + ")."};
}

} // namespace

Result<std::shared_ptr<SessionLock>> SessionLock::acquire(const std::filesystem::path &session)
{
    const std::filesystem::path file = lockFileOf(session);
    for (int tries = 0;; ++tries) {
        const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor < 0)
            return cannotLock(session, errno);
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            const int errorNumber = errno;
            const std::string owner = ownerOf(descriptor);
            const bool again = errorNumber == EWOULDBLOCK && tries < kMostTries && onlyAskedFor(descriptor);
            ::close(descriptor);
            if (again) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                continue;
            }
            if (errorNumber != EWOULDBLOCK)
                return cannotLock(session, errorNumber);
            return Error{Errc::SessionInUse, session.string() + " is opened read-only: " + owner +
                                                 " is writing to it. Close it there to write here."};
        }
        if (!stillThere(descriptor, file)) {
            ::close(descriptor);
            continue;
        }
        const std::string owner = std::to_string(::getpid());
        // Only for messages: a full disk must not keep anyone from opening.
        if (::ftruncate(descriptor, 0) == 0) [[maybe_unused]]
            const ssize_t written = ::pwrite(descriptor, owner.data(), owner.size(), 0);
        return std::shared_ptr<SessionLock>(new SessionLock(file, descriptor));
    }
}

bool SessionLock::isHeld(const std::filesystem::path &session)
{
    const int descriptor = ::open(lockFileOf(session).c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return errno != ENOENT;
    const bool held = !onlyAskedFor(descriptor);
    ::close(descriptor);
    return held;
}

SessionLock::~SessionLock()
{
    ::unlink(m_file.c_str());
    ::close(m_descriptor);
}

} // namespace driftbench
