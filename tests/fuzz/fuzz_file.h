// Bytes of the fuzzer as a file that the readers can open.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

namespace driftbench::fuzz {

// A file in memory that goes with the object.
class FuzzFile
{
public:
    FuzzFile(const std::uint8_t *data, std::size_t bytes) : m_descriptor(::memfd_create("fuzz", MFD_CLOEXEC))
    {
        m_whole = m_descriptor >= 0 && ::write(m_descriptor, data, bytes) == static_cast<ssize_t>(bytes);
    }
    ~FuzzFile()
    {
        if (m_descriptor >= 0)
            ::close(m_descriptor);
    }
    FuzzFile(const FuzzFile &) = delete;
    FuzzFile &operator=(const FuzzFile &) = delete;

    bool whole() const { return m_whole; }
    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(m_descriptor); }

private:
    int m_descriptor = -1;
    bool m_whole = false;
};

} // namespace driftbench::fuzz
