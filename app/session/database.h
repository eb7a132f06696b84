// SQLite as values of this house: a connection, statements that bind and read by position, a transaction that
// is rolled back unless it was committed. Every failure is an Error whose sentence names the file.
//
// One thread at a time uses a connection. Errors: OutputFull (disk full), OutputNotWritable (read-only or a
// failed write, sync or truncation), FileUnreadable (a failed read), SessionDamaged (not a database,
// malformed, a rule of the schema broken), SessionInUse (locked by another program for longer than the
// time-out).
#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace driftbench {

struct Bytes // a blob, as opposed to text
{
    std::string_view view;
};

enum class DatabaseMode
{
    Create,    // must not exist
    ReadWrite, // falls back to reading where the system does not permit writing
    ReadOnly,  // leaves no file behind, but may finish what a crashed writer began
    Untouched, // nothing but the file's own pages is read, and nothing written
};

class Database;

class Statement
{
public:
    Statement(const Database &database, std::string_view sql);
    Statement(Statement &&other) noexcept;
    Statement &operator=(Statement &&other) = delete;
    Statement(const Statement &) = delete;
    Statement &operator=(const Statement &) = delete;
    ~Statement();

    // Binds the values to ?1, ?2, ...; text and bytes must live until the statement has run.
    template <class... Values>
    Statement &with(const Values &...values)
    {
        reset();
        int index = 0;
        (bind(++index, values), ...);
        return *this;
    }

    Result<bool> step(); // true: there is a row
    Status run();        // to the end, whatever rows come
    void reset();

    std::int64_t integer(int column) const;
    double real(int column) const; // NULL reads as NaN, as which it was written
    std::string text(int column) const;
    std::string_view bytes(int column) const; // valid until the next step
    bool isNull(int column) const;

private:
    void bind(int index, std::int64_t value);
    void bind(int index, int value) { bind(index, static_cast<std::int64_t>(value)); }
    void bind(int index, bool value) { bind(index, static_cast<std::int64_t>(value)); }
    void bind(int index, std::uint32_t value) { bind(index, static_cast<std::int64_t>(value)); }
    void bind(int index, double value);
    void bind(int index, std::string_view text);
    void bind(int index, const std::string &text) { bind(index, std::string_view(text)); }
    void bind(int index, const char *text) { bind(index, std::string_view(text)); }
    void bind(int index, Bytes bytes);
    void bindNull(int index);
    template <class Value>
    void bind(int index, const std::optional<Value> &value)
    {
        value ? bind(index, *value) : bindNull(index);
    }
    void keep(int code);

    const Database *m_database;
    sqlite3_stmt *m_statement = nullptr;
    int m_code = 0;       // the first that failed
    std::string m_detail; // what SQLite said of it
};

class Database
{
public:
    // vfs: name of a registered SQLite VFS; empty: the system's.
    static Result<Database> open(const std::filesystem::path &path, DatabaseMode mode,
                                 const std::string &vfs = {});

    Database(Database &&other) noexcept;
    Database &operator=(Database &&other) = delete;
    Database(const Database &) = delete;
    Database &operator=(const Database &) = delete;
    ~Database();

    Statement prepare(std::string_view sql) const { return {*this, sql}; }
    template <class... Values>
    Status run(std::string_view sql, const Values &...values) const
    {
        return prepare(sql).with(values...).run();
    }
    Status script(const std::string &sql) const; // several statements
    // The first column of the only row.
    template <class... Values>
    Result<std::int64_t> integer(std::string_view sql, const Values &...values) const
    {
        Statement statement = prepare(sql);
        const auto row = statement.with(values...).step();
        if (!row)
            return row.error();
        return *row ? statement.integer(0) : std::int64_t{0};
    }

    std::int64_t lastInsertId() const;
    // The first 100 bytes of the file as they stand there, whatever its log holds; empty if there are fewer.
    // Through SQLite's own descriptor: closing another one would drop its locks.
    std::string header() const;
    bool systemPermitsWriting() const;
    void leaveLogOnClose() const; // what a crash left is left to others
    const std::filesystem::path &path() const { return m_path; }
    sqlite3 *handle() const { return m_handle; }

    Error failure(int code, std::string_view detail) const;

private:
    Database(std::filesystem::path path, sqlite3 *handle) : m_path(std::move(path)), m_handle(handle) {}

    std::filesystem::path m_path;
    sqlite3 *m_handle;
};

class Transaction
{
public:
    // For writing: waits its turn at once, not in the middle.
    static Result<Transaction> begin(const Database &database);
    // For reading several times from one state of the file.
    static Result<Transaction> beginReading(const Database &database);

    Transaction(Transaction &&other) noexcept;
    Transaction &operator=(Transaction &&other) = delete;
    Transaction(const Transaction &) = delete;
    Transaction &operator=(const Transaction &) = delete;
    ~Transaction();

    // An error means: not committed, and rolled back. (After a crash it may be found committed nevertheless.)
    Status commit();

private:
    explicit Transaction(const Database &database) : m_database(&database) {}

    const Database *m_database; // null once it is over
};

} // namespace driftbench
