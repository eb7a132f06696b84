#include "engine/formats/file_window.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace driftbench {

namespace {

Error cannotRead(const std::filesystem::path &path, int errorNumber)
{
    if (errorNumber == ENOENT || errorNumber == ENOTDIR)
        return {Errc::FileNotFound, path.string() + " is not there: check the name."};
    return {Errc::FileUnreadable, path.string() +
                                      " can't be read: " + std::generic_category().message(errorNumber) +
                                      ". Choose a file that you may read."};
}

} // namespace

FileWindow::FileWindow(std::filesystem::path path, int descriptor, std::uint64_t fileBytes,
                       std::size_t windowBytes)
    : m_path(std::move(path)), m_descriptor(descriptor), m_fileBytes(fileBytes), m_buffer(windowBytes)
{
}

FileWindow::FileWindow(FileWindow &&other) noexcept
    : m_path(std::move(other.m_path))
    , m_descriptor(std::exchange(other.m_descriptor, -1))
    , m_fileBytes(other.m_fileBytes)
    , m_offset(other.m_offset)
    , m_buffer(std::move(other.m_buffer))
    , m_begin(other.m_begin)
    , m_end(other.m_end)
    , m_ended(other.m_ended)
    , m_status(std::move(other.m_status))
{
}

FileWindow::~FileWindow()
{
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

Result<FileWindow> FileWindow::open(const std::filesystem::path &path, std::size_t windowBytes)
{
    assert(windowBytes > 0);
    // O_NONBLOCK: a named pipe must not hold us up before it is refused below.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        return cannotRead(path, errno);
    struct stat state = {};
    const int errorNumber = ::fstat(descriptor, &state) == 0 ? 0 : errno;
    FileWindow window(path, descriptor, static_cast<std::uint64_t>(state.st_size), windowBytes);
    if (errorNumber != 0)
        return cannotRead(path, errorNumber);
    if (S_ISDIR(state.st_mode))
        return cannotRead(path, EISDIR);
    if (!S_ISREG(state.st_mode))
        return Error{Errc::FileUnreadable,
                     path.string() + " is not a regular file: save it to the disk first."};
    if (state.st_size == 0)
        return Error{Errc::FileEmpty, path.string() + " is empty: record or copy it again."};
    return window;
}

bool FileWindow::fill(std::size_t count)
{
    if (m_end - m_begin >= count)
        return true;
    if (m_ended)
        return false;
    makeRoom(count);
    while (m_end - m_begin < count && !m_ended)
        readMore();
    return m_end - m_begin >= count;
}

void FileWindow::makeRoom(std::size_t count)
{
    std::memmove(m_buffer.data(), m_buffer.data() + m_begin, m_end - m_begin);
    m_end -= m_begin;
    m_begin = 0;
    if (m_buffer.size() < count)
        m_buffer.resize(count);
}

void FileWindow::readMore()
{
    const ssize_t got = ::read(m_descriptor, m_buffer.data() + m_end, m_buffer.size() - m_end);
    if (got < 0 && errno == EINTR)
        return;
    if (got < 0)
        m_status = cannotRead(m_path, errno);
    if (got <= 0)
        m_ended = true;
    else
        m_end += static_cast<std::size_t>(got);
}

void FileWindow::consume(std::size_t count)
{
    assert(count <= m_end - m_begin);
    m_begin += count;
    m_offset += count;
}

} // namespace driftbench
