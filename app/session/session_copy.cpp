#include "app/session/session_file_state.h"
#include "app/session/temporary_database.h"

#include <algorithm>
#include <sqlite3.h>
#include <system_error>

namespace driftbench {

namespace {

constexpr int kPagesAtOnce = 1024;

Status copyPages(const Database &source, const Database &target, const ProgressHook &hook)
{
    sqlite3_backup *backup = sqlite3_backup_init(target.handle(), "main", source.handle(), "main");
    if (backup == nullptr)
        return target.failure(sqlite3_extended_errcode(target.handle()), sqlite3_errmsg(target.handle()));
    bool cancelled = false;
    int code = SQLITE_OK;
    while (!cancelled && code == SQLITE_OK) {
        code = sqlite3_backup_step(backup, kPagesAtOnce);
        const int pages = std::max(sqlite3_backup_pagecount(backup), 1);
        cancelled = report(hook, "copy",
                           1.0 - static_cast<double>(sqlite3_backup_remaining(backup)) / pages) == Flow::Stop;
    }
    const int ended = sqlite3_backup_finish(backup);
    if (cancelled)
        return Error{Errc::Cancelled, "The copy was cancelled; nothing was changed."};
    if (code != SQLITE_DONE)
        return target.failure(ended, sqlite3_errmsg(target.handle()));
    return {};
}

} // namespace

Status SessionFile::saveCopy(const std::filesystem::path &target, const ProgressHook &hook) const
{
    std::error_code code;
    if (std::filesystem::equivalent(path(), target, code))
        return Error{Errc::InvalidOption,
                     target.string() + " is the session itself; choose another name for the copy."};
    auto temporary = TemporaryDatabase::beside(target);
    if (!temporary)
        return temporary.error();
    const auto copy = [&]() -> Status {
        const auto copied = Database::open(temporary->path(), DatabaseMode::Create, m_state->options.vfs);
        if (!copied)
            return copied.error();
        // One state of the file, whatever is committed meanwhile.
        const auto transaction = Transaction::beginReading(database());
        if (!transaction)
            return transaction.error();
        if (const auto version = database().integer("PRAGMA user_version"); !version)
            return version.error();
        return copyPages(database(), *copied, hook);
    };
    if (Status copied = copy(); !copied)
        return copied;
    return temporary->replaceTarget();
}

} // namespace driftbench
