#include "engine/base/atomic_file.h"

#include "engine/base/output_error.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace driftbench {

namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 20;

} // namespace

AtomicFile::AtomicFile(std::filesystem::path target, std::filesystem::path temporary, int descriptor)
    : m_target(std::move(target)), m_temporary(std::move(temporary)), m_descriptor(descriptor)
{
    m_buffer.reserve(kBufferBytes);
}

AtomicFile::AtomicFile(AtomicFile &&other) noexcept
    : m_target(std::move(other.m_target))
    , m_temporary(std::exchange(other.m_temporary, {}))
    , m_descriptor(std::exchange(other.m_descriptor, -1))
    , m_buffer(std::move(other.m_buffer))
{
}

AtomicFile::~AtomicFile()
{
    if (m_descriptor >= 0)
        ::close(m_descriptor);
    if (!m_temporary.empty())
        ::unlink(m_temporary.c_str());
}

Result<AtomicFile> AtomicFile::create(const std::filesystem::path &target)
{
    std::string name = (target.parent_path() / ("." + target.filename().string() + ".XXXXXX")).string();
    const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor < 0)
        return outputError(target, errno);
    // mkostemp makes the file private; the result should have the permissions of any new file.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::fchmod(descriptor, 0666 & ~mask) != 0) {
        const int errorNumber = errno;
        ::close(descriptor);
        ::unlink(name.c_str());
        return outputError(target, errorNumber);
    }
    return AtomicFile(target, name, descriptor);
}

Error AtomicFile::failure(int errorNumber) const
{
    return outputError(m_target, errorNumber);
}

Status AtomicFile::flushBuffer()
{
    std::size_t done = 0;
    while (done < m_buffer.size()) {
        const ssize_t written = ::write(m_descriptor, m_buffer.data() + done, m_buffer.size() - done);
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return failure(errno);
        done += static_cast<std::size_t>(written);
    }
    m_buffer.clear();
    return {};
}

Status AtomicFile::write(std::string_view bytes)
{
    m_buffer.append(bytes);
    return m_buffer.size() < kBufferBytes ? Status() : flushBuffer();
}

Status AtomicFile::prepare()
{
    if (m_descriptor < 0)
        return {};
    if (Status flushed = flushBuffer(); !flushed)
        return flushed;
    m_buffer.shrink_to_fit();
    if (::fsync(m_descriptor) != 0)
        return failure(errno);
    if (::close(std::exchange(m_descriptor, -1)) != 0)
        return failure(errno);
    return {};
}

Status AtomicFile::commit()
{
    if (Status prepared = prepare(); !prepared)
        return prepared;
    if (::rename(m_temporary.c_str(), m_target.c_str()) != 0)
        return failure(errno);
    m_temporary.clear();
    return {};
}

Status writeFileAtomically(const std::filesystem::path &target, std::string_view bytes)
{
    auto file = AtomicFile::create(target);
    if (!file)
        return file.error();
    if (Status written = file->write(bytes); !written)
        return written;
    return file->commit();
}

Status writeFilesTogether(const std::vector<FileText> &files)
{
    std::vector<AtomicFile> pending;
    for (const auto &[target, text] : files) {
        auto file = AtomicFile::create(target);
        if (!file)
            return file.error();
        if (Status written = file->write(text); !written)
            return written;
        if (Status prepared = file->prepare(); !prepared)
            return prepared;
        pending.push_back(*std::move(file));
    }
    for (AtomicFile &file : pending) {
        if (Status committed = file.commit(); !committed)
            return committed;
    }
    return {};
}

Status ensureWritableFolder(const std::filesystem::path &folder)
{
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (code)
        return outputError(folder, code.value());
    if (!std::filesystem::is_directory(folder, code))
        return outputError(folder, ENOTDIR);
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return outputError(folder, errno);
    return {};
}

} // namespace driftbench
