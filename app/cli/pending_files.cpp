#include "app/cli/pending_files.h"

#include <utility>

namespace driftbench::cli {

Status PendingFiles::add(const std::filesystem::path &target, std::string_view text)
{
    auto file = AtomicFile::create(target);
    if (!file)
        return file.error();
    if (Status written = file->write(text); !written)
        return written;
    if (Status prepared = file->prepare(); !prepared)
        return prepared;
    m_files.emplace_back(*std::move(file));
    return {};
}

Status PendingFiles::add(CsvWriter writer)
{
    if (Status prepared = writer.prepare(); !prepared)
        return prepared;
    m_files.emplace_back(std::move(writer));
    return {};
}

Status PendingFiles::commit()
{
    for (auto &file : m_files) {
        if (Status committed = std::visit([](auto &of) { return of.commit(); }, file); !committed)
            return committed;
    }
    return {};
}

} // namespace driftbench::cli
