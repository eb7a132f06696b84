#include "engine/base/growing_file.h"

#include "engine/base/output_error.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace driftbench {

Result<GrowingFile> GrowingFile::create(const std::filesystem::path &path, bool replace)
{
    const int flags = O_WRONLY | O_CREAT | O_CLOEXEC | O_APPEND | (replace ? O_TRUNC : O_EXCL);
    const int descriptor = ::open(path.c_str(), flags, 0666);
    if (descriptor < 0 && errno == EEXIST)
        return Error{Errc::OutputNotWritable,
                     path.string() + " is there already and is not replaced; choose another name."};
    if (descriptor < 0)
        return outputError(path, errno);
    return GrowingFile(path, descriptor);
}

GrowingFile::GrowingFile(GrowingFile &&other) noexcept
    : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1))
{
}

GrowingFile::~GrowingFile()
{
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

Status GrowingFile::append(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return outputError(m_path, errno);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return {};
}

Status GrowingFile::sync() const
{
    // Pipes and the like have no disk below them.
    if (::fdatasync(m_descriptor) != 0 && errno != EINVAL && errno != EROFS)
        return outputError(m_path, errno);
    return {};
}

} // namespace driftbench
