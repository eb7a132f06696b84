// Files that belong together: all are on the disk before the first is put in place, so that an error, a full
// disk or a cancel leaves every target as it was.
#pragma once

#include "engine/base/atomic_file.h"
#include "engine/base/result.h"
#include "engine/formats/csv_writer.h"

#include <filesystem>
#include <string_view>
#include <variant>
#include <vector>

namespace driftbench::cli {

class PendingFiles
{
public:
    Status add(const std::filesystem::path &target, std::string_view text);
    Status add(CsvWriter writer); // with all its rows
    Status commit();

private:
    std::vector<std::variant<AtomicFile, CsvWriter>> m_files; // prepared
};

} // namespace driftbench::cli
