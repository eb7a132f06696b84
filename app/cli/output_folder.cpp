#include "app/cli/output_folder.h"

#include "engine/base/atomic_file.h"

#include <algorithm>
#include <system_error>

namespace driftbench::cli {

OutputFolders::~OutputFolders()
{
    std::error_code ignored;
    for (auto folder = m_made.rbegin(); folder != m_made.rend(); ++folder)
        std::filesystem::remove(*folder, ignored); // does nothing to a folder that is not empty
}

Status OutputFolders::make(const std::filesystem::path &folder)
{
    std::error_code code;
    std::vector<std::filesystem::path> missing;
    for (std::filesystem::path above = folder; !above.empty() && !std::filesystem::exists(above, code);
         above = above.parent_path())
        missing.push_back(above);
    Status made = ensureWritableFolder(folder);
    m_made.insert(m_made.end(), missing.rbegin(), missing.rend());
    return made;
}

} // namespace driftbench::cli
