// Folders for results: made unless they are there, and removed again where work ended without results.
#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <vector>

namespace driftbench::cli {

class OutputFolders
{
public:
    OutputFolders() = default;
    OutputFolders(const OutputFolders &) = delete;
    OutputFolders &operator=(const OutputFolders &) = delete;
    ~OutputFolders(); // without keep: what was made here goes, unless something lies in it

    // With all folders above it. Errc: OutputNotWritable, OutputFull.
    Status make(const std::filesystem::path &folder);
    void keep() { m_made.clear(); }

private:
    std::vector<std::filesystem::path> m_made; // a folder stands behind the one it lies in
};

} // namespace driftbench::cli
