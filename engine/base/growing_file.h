// A file that grows while something is recorded: what was appended is with the system at once and survives
// the end of the program, what was synchronised survives that of the power. Unlike AtomicFile it is there
// from the start, and what it holds is kept whatever happens.
//
// Errors: OutputNotWritable (also where the file exists and is not to be replaced), OutputFull.
#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string_view>

namespace driftbench {

class GrowingFile
{
public:
    static Result<GrowingFile> create(const std::filesystem::path &path, bool replace);

    GrowingFile(GrowingFile &&other) noexcept;
    GrowingFile &operator=(GrowingFile &&other) = delete;
    GrowingFile(const GrowingFile &) = delete;
    GrowingFile &operator=(const GrowingFile &) = delete;
    ~GrowingFile();

    Status append(std::string_view bytes);
    // Brings what was appended to the disk, which may take long: another thread may append meanwhile.
    Status sync() const;

private:
    GrowingFile(std::filesystem::path path, int descriptor)
        : m_path(std::move(path)), m_descriptor(descriptor)
    {
    }

    std::filesystem::path m_path;
    int m_descriptor;
};

} // namespace driftbench
