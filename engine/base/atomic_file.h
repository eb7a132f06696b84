// Files that are replaced whole or not at all: the bytes go to a temporary file beside the target, which is
// flushed to the disk and then renamed over it. Whatever fails or is cut off before that leaves the old file.
#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

class AtomicFile
{
public:
    static Result<AtomicFile> create(const std::filesystem::path &target);

    AtomicFile(AtomicFile &&other) noexcept;
    AtomicFile &operator=(AtomicFile &&other) = delete;
    AtomicFile(const AtomicFile &) = delete;
    AtomicFile &operator=(const AtomicFile &) = delete;
    ~AtomicFile(); // without commit: the temporary file goes, the target stays as it was

    Status write(std::string_view bytes);
    // Brings all that was written to the disk, still beside the target, and closes the file: write no more.
    // Of several files that belong together all are prepared before the first is committed: a disk that is
    // full then shows before any is replaced.
    Status prepare();
    Status commit(); // prepares, unless that is done, and puts the file in place

private:
    AtomicFile(std::filesystem::path target, std::filesystem::path temporary, int descriptor);
    Status flushBuffer();
    Error failure(int errorNumber) const;

    std::filesystem::path m_target;
    std::filesystem::path m_temporary; // empty once there is none to remove
    int m_descriptor = -1;             // -1 once prepared
    std::string m_buffer;
};

Status writeFileAtomically(const std::filesystem::path &target, std::string_view bytes);

struct FileText
{
    std::filesystem::path target;
    std::string text;
};

// All of them or, where the disk is full or may not be written to, none.
Status writeFilesTogether(const std::vector<FileText> &files);

// Makes folder (and those above it) unless it is there; an error says why it can't be written to.
Status ensureWritableFolder(const std::filesystem::path &folder);

} // namespace driftbench
