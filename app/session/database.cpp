#include "app/session/database.h"

#include <cassert>
#include <limits>
#include <sqlite3.h>
#include <utility>

namespace driftbench {

namespace {

constexpr int kBusyMs = 5000;

// SQLite's URI syntax, in which only these need no escape.
std::string asUri(const std::filesystem::path &path)
{
    static constexpr std::string_view kPlain =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789/._-";
    static constexpr std::string_view kHex = "0123456789ABCDEF";
    std::string uri = "file:";
    for (const char c : path.string()) {
        if (kPlain.find(c) != std::string_view::npos) {
            uri += c;
        } else {
            uri += '%';
            uri += kHex[static_cast<unsigned char>(c) >> 4];
            uri += kHex[static_cast<unsigned char>(c) & 15U];
        }
    }
    return uri;
}

int flagsFor(DatabaseMode mode)
{
    constexpr int common = SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE;
    switch (mode) {
    case DatabaseMode::Create:
        return common | SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    case DatabaseMode::ReadWrite:
    case DatabaseMode::ReadOnly:
        return common | SQLITE_OPEN_READWRITE;
    case DatabaseMode::Untouched:
        return common | SQLITE_OPEN_READONLY;
    }
    assert(false);
    return common;
}

} // namespace

Statement::Statement(const Database &database, std::string_view sql) : m_database(&database)
{
    keep(sqlite3_prepare_v2(database.handle(), sql.data(), static_cast<int>(sql.size()), &m_statement,
                            nullptr));
}

Statement::Statement(Statement &&other) noexcept
    : m_database(other.m_database)
    , m_statement(std::exchange(other.m_statement, nullptr))
    , m_code(other.m_code)
    , m_detail(std::move(other.m_detail))
{
}

Statement::~Statement()
{
    sqlite3_finalize(m_statement);
}

void Statement::keep(int code)
{
    if (code == SQLITE_OK || m_code != SQLITE_OK)
        return;
    m_code = code;
    m_detail = sqlite3_errmsg(m_database->handle());
}

void Statement::bind(int index, std::int64_t value)
{
    keep(sqlite3_bind_int64(m_statement, index, value));
}

void Statement::bind(int index, double value)
{
    keep(sqlite3_bind_double(m_statement, index, value));
}

void Statement::bind(int index, std::string_view text)
{
    // An empty view may have no address, which SQLite would take for NULL.
    keep(sqlite3_bind_text64(m_statement, index, text.empty() ? "" : text.data(), text.size(), SQLITE_STATIC,
                             SQLITE_UTF8));
}

void Statement::bind(int index, Bytes bytes)
{
    keep(sqlite3_bind_blob64(m_statement, index, bytes.view.empty() ? "" : bytes.view.data(),
                             bytes.view.size(), SQLITE_STATIC));
}

void Statement::bindNull(int index)
{
    keep(sqlite3_bind_null(m_statement, index));
}

Result<bool> Statement::step()
{
    if (m_code == SQLITE_OK) {
        const int code = sqlite3_step(m_statement);
        if (code == SQLITE_ROW || code == SQLITE_DONE)
            return code == SQLITE_ROW;
        keep(code);
    }
    return m_database->failure(m_code, m_detail);
}

Status Statement::run()
{
    for (;;) {
        const auto row = step();
        if (!row)
            return row.error();
        if (!*row)
            return {};
    }
}

void Statement::reset()
{
    sqlite3_reset(m_statement);
}

std::int64_t Statement::integer(int column) const
{
    return sqlite3_column_int64(m_statement, column);
}

double Statement::real(int column) const
{
    return isNull(column) ? std::numeric_limits<double>::quiet_NaN()
                          : sqlite3_column_double(m_statement, column);
}

std::string Statement::text(int column) const
{
    const auto *text = reinterpret_cast<const char *>(sqlite3_column_text(m_statement, column));
    return text == nullptr
               ? std::string()
               : std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(m_statement, column)));
}

std::string_view Statement::bytes(int column) const
{
    const auto *data = static_cast<const char *>(sqlite3_column_blob(m_statement, column));
    return data == nullptr
               ? std::string_view()
               : std::string_view(data, static_cast<std::size_t>(sqlite3_column_bytes(m_statement, column)));
}

bool Statement::isNull(int column) const
{
    return sqlite3_column_type(m_statement, column) == SQLITE_NULL;
}

Result<Database> Database::open(const std::filesystem::path &path, DatabaseMode mode, const std::string &vfs)
{
    std::string uri = asUri(path);
    if (mode == DatabaseMode::Untouched)
        uri += "?immutable=1";
    sqlite3 *handle = nullptr;
    const int code =
        sqlite3_open_v2(uri.c_str(), &handle, flagsFor(mode), vfs.empty() ? nullptr : vfs.c_str());
    Database database(path, handle);
    if (code != SQLITE_OK)
        return database.failure(code, handle == nullptr ? "out of memory" : sqlite3_errmsg(handle));
    sqlite3_busy_timeout(handle, kBusyMs);
    // A damaged or made-up file must not run code of its own.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    return database;
}

Database::Database(Database &&other) noexcept
    : m_path(std::move(other.m_path)), m_handle(std::exchange(other.m_handle, nullptr))
{
}

Database::~Database()
{
    sqlite3_close_v2(m_handle);
}

Status Database::script(const std::string &sql) const
{
    const int code = sqlite3_exec(m_handle, sql.c_str(), nullptr, nullptr, nullptr);
    return code == SQLITE_OK ? Status() : Status(failure(code, sqlite3_errmsg(m_handle)));
}

std::int64_t Database::lastInsertId() const
{
    return sqlite3_last_insert_rowid(m_handle);
}

std::string Database::header() const
{
    constexpr int size = 100;
    std::string bytes(size, '\0');
    sqlite3_file *file = nullptr;
    if (sqlite3_file_control(m_handle, "main", SQLITE_FCNTL_FILE_POINTER, &file) != SQLITE_OK ||
        file == nullptr || file->pMethods == nullptr ||
        file->pMethods->xRead(file, bytes.data(), size, 0) != SQLITE_OK)
        bytes.clear();
    return bytes;
}

bool Database::systemPermitsWriting() const
{
    return sqlite3_db_readonly(m_handle, "main") == 0;
}

void Database::leaveLogOnClose() const
{
    sqlite3_db_config(m_handle, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

Error Database::failure(int code, std::string_view detail) const
{
    const std::string name = m_path.string();
    const std::string because = " (" + std::string(detail) + ")";
    switch (code & 0xff) {
    case SQLITE_FULL:
        return {Errc::OutputFull, name + " could not be written: no room is left on its disk. Make room."};
    case SQLITE_READONLY:
    case SQLITE_PERM:
        return {Errc::OutputNotWritable,
                name + " can't be written" + because + ". Copy it to a folder that you may write to."};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return {Errc::SessionInUse, name + " is locked by another program" + because + ". Close that first."};
    case SQLITE_CANTOPEN:
        return {Errc::FileUnreadable, name + " can't be opened" + because + ". Check its folder and rights."};
    case SQLITE_IOERR:
        if (code == SQLITE_IOERR_READ || code == SQLITE_IOERR_SHORT_READ)
            return {Errc::FileUnreadable, name + " can't be read" + because + ". Check the disk."};
        return {Errc::OutputNotWritable, name + " could not be written" + because + ". Check the disk."};
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
        return {Errc::SessionDamaged,
                name + " is damaged" + because + ". Run \"session check\" on it or take a copy from before."};
    default:
        return {Errc::SessionDamaged, name + " does not hold what a session file must" + because + "."};
    }
}

Result<Transaction> Transaction::begin(const Database &database)
{
    if (Status begun = database.run("BEGIN IMMEDIATE"); !begun)
        return begun.error();
    return Transaction(database);
}

Result<Transaction> Transaction::beginReading(const Database &database)
{
    if (Status begun = database.run("BEGIN"); !begun)
        return begun.error();
    return Transaction(database);
}

Transaction::Transaction(Transaction &&other) noexcept : m_database(std::exchange(other.m_database, nullptr))
{
}

Transaction::~Transaction()
{
    // SQLite has rolled back by itself after some failures.
    if (m_database != nullptr && sqlite3_get_autocommit(m_database->handle()) == 0)
        sqlite3_exec(m_database->handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

Status Transaction::commit()
{
    if (Status done = m_database->run("COMMIT"); !done)
        return done;
    m_database = nullptr;
    return {};
}

} // namespace driftbench
