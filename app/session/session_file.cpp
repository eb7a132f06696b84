#include "app/session/session_file.h"

#include "app/session/session_file_state.h"
#include "app/session/session_schema.h"
#include "app/session/temporary_database.h"

#include <system_error>

namespace driftbench {

namespace {

constexpr const char *kConnection =
    "PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL; PRAGMA secure_delete = OFF;"
    "PRAGMA cell_size_check = ON; PRAGMA wal_autocheckpoint = 256;";

Error notASession(const std::filesystem::path &path)
{
    return {Errc::UnknownFormat,
            path.string() + " is no session file of Driftbench. Import logs into a session."};
}

Error tooNew(const std::filesystem::path &path, std::int64_t version)
{
    return {Errc::SessionTooNew, path.string() + " is a session file of version " + std::to_string(version) +
                                     "; this program knows versions up to " +
                                     std::to_string(kSessionFormatVersion) +
                                     ". Nothing was changed; use a newer Driftbench."};
}

Result<int> versionOf(const Database &database)
{
    const auto application = database.integer("PRAGMA application_id");
    if (!application)
        return application.error();
    if (*application != kSessionApplicationId)
        return notASession(database.path());
    const auto version = database.integer("PRAGMA user_version");
    if (!version)
        return version.error();
    if (*version < 1)
        return notASession(database.path());
    if (*version > kSessionFormatVersion)
        return tooNew(database.path(), *version);
    return static_cast<int>(*version);
}

std::int64_t bigEndianAt(const std::string &bytes, std::size_t at)
{
    std::int64_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
        value = value * 256 + static_cast<unsigned char>(bytes[i]);
    return value;
}

// By the file's header alone, so that nothing is written beside a file that is not ours to touch, and so that
// one whose pages are still on their way from the log into it is known all the same.
Status isOurs(const std::filesystem::path &path, const std::string &vfs)
{
    std::error_code code;
    if (!std::filesystem::exists(path, code))
        return Error{Errc::FileNotFound, path.string() + " does not exist. Check the name."};
    if (std::filesystem::is_directory(path, code))
        return notASession(path);
    const auto database = Database::open(path, DatabaseMode::Untouched, vfs);
    if (!database)
        return database.error();
    const std::string header = database->header();
    if (!header.starts_with("SQLite format 3") || bigEndianAt(header, 68) != kSessionApplicationId)
        return notASession(path);
    const std::int64_t version = bigEndianAt(header, 60);
    if (version > kSessionFormatVersion)
        return tooNew(path, version);
    return version < 1 ? Status(notASession(path)) : Status();
}

bool hasLog(const std::filesystem::path &path)
{
    std::filesystem::path log = path;
    log += "-wal";
    std::error_code code;
    const auto size = std::filesystem::file_size(log, code);
    return !code && size > 0;
}

Result<Database> openForReading(const std::filesystem::path &path, const std::string &vfs)
{
    auto database = Database::open(path, DatabaseMode::ReadOnly, vfs);
    if (!database)
        return database;
    const auto tables = database->integer("SELECT count(*) FROM sqlite_schema");
    if (tables) {
        if (Status set = database->script(std::string(kConnection) + "PRAGMA query_only = ON;"); !set)
            return set.error();
        return database;
    }
    // A folder in which SQLite can't put its shared memory: without a log the file alone is all there is.
    if ((tables.error().code == Errc::FileUnreadable || tables.error().code == Errc::OutputNotWritable) &&
        !hasLog(path))
        return Database::open(path, DatabaseMode::Untouched, vfs);
    return tables.error();
}

// What a program that ended in the middle left: runs that were being recorded, imports that were not
// finished.
Result<std::vector<RunId>> recover(const Database &database)
{
    const auto cutOff =
        database.integer("SELECT count(*) FROM run WHERE state IN ('recording', 'importing')");
    if (!cutOff)
        return cutOff.error();
    std::vector<RunId> found;
    if (*cutOff == 0)
        return found;
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    Statement runs = database.prepare("SELECT id FROM run WHERE state = 'recording' ORDER BY id");
    for (;;) {
        const auto row = runs.step();
        if (!row)
            return row.error();
        if (!*row)
            break;
        found.push_back(runs.integer(0));
    }
    for (const RunId run : found) {
        const auto samples =
            database.integer("SELECT max(first_sample + samples) FROM chunk WHERE run_id = ?1", run);
        if (!samples)
            return samples.error();
        const SessionEvent event{
            run,
            *samples,
            {},
            "recovery",
            "The program that recorded this run ended before the run did; the run is complete "
            "up to its last commit."};
        if (Status logged = insertEvent(database, event); !logged)
            return logged.error();
    }
    if (Status marked = database.run(
            "UPDATE run SET state = 'interrupted', ended_utc = ?1 WHERE state = 'recording'", utcNow());
        !marked)
        return marked.error();
    if (Status removed = database.run("DELETE FROM run WHERE state = 'importing'"); !removed)
        return removed.error();
    if (Status done = transaction->commit(); !done)
        return done.error();
    return found;
}

Status prepareForWriting(const Database &database)
{
    if (Status set = database.script(std::string(kConnection) + "PRAGMA journal_mode = WAL;"); !set)
        return set;
    const auto version = versionOf(database);
    if (!version) {
        // The log of a newer program that was killed.
        database.leaveLogOnClose();
        return version.error();
    }
    if (*version == kSessionFormatVersion)
        return {};
    if (Status current = bringUpToDate(database, *version); !current)
        return current;
    // The version stands in the file itself, not only in its log, for older programs to see.
    return database.run("PRAGMA wal_checkpoint(TRUNCATE)");
}

Status fillNewFile(const std::filesystem::path &temporary, const SessionOptions &options)
{
    const auto database = Database::open(temporary, DatabaseMode::Create, options.vfs);
    if (!database)
        return database.error();
    if (Status set = database->script("PRAGMA page_size = 16384;" + std::string(kConnection)); !set)
        return set;
    if (Status made = bringUpToDate(*database, 0); !made)
        return made;
    if (Status row = database->run("INSERT INTO session(id, created_utc, written_by) VALUES(1, ?1, ?2)",
                                   utcNow(), options.writtenBy);
        !row)
        return row;
    return database->run("PRAGMA journal_mode = WAL");
}

} // namespace

Result<SessionFile> SessionFile::create(const std::filesystem::path &path, const SessionOptions &options)
{
    std::error_code code;
    if (std::filesystem::exists(path, code))
        return Error{Errc::OutputNotWritable,
                     path.string() + " exists already. Open it, or choose another name."};
    auto temporary = TemporaryDatabase::beside(path);
    if (!temporary)
        return temporary.error();
    if (Status filled = fillNewFile(temporary->path(), options); !filled)
        return filled.error();
    if (Status made = temporary->becomeTarget(); !made)
        return made.error();
    return open(path, SessionAccess::ReadWrite, options);
}

Result<SessionFile> SessionFile::open(const std::filesystem::path &path, SessionAccess access,
                                      const SessionOptions &options)
{
    if (Status ours = isOurs(path, options.vfs); !ours)
        return ours.error();
    std::string reason = path.string() + " was opened to be read only.";
    if (access == SessionAccess::ReadWrite) {
        const auto lock = SessionLock::acquire(path);
        if (lock) {
            auto database = Database::open(path, DatabaseMode::ReadWrite, options.vfs);
            if (!database)
                return database.error();
            if (database->systemPermitsWriting()) {
                if (Status prepared = prepareForWriting(*database); !prepared)
                    return prepared.error();
                auto found = recover(*database);
                if (!found)
                    return found.error();
                return SessionFile(std::make_unique<State>(State{path,
                                                                 options,
                                                                 std::move(*database),
                                                                 *lock,
                                                                 {},
                                                                 kSessionFormatVersion,
                                                                 std::move(*found)}));
            }
            reason = path.string() + " is opened read-only: the system does not let you write to it.";
        } else {
            reason = lock.error().message;
        }
    }
    auto database = openForReading(path, options.vfs);
    if (!database)
        return database.error();
    const auto version = versionOf(*database);
    if (!version) {
        database->leaveLogOnClose();
        return version.error();
    }
    return SessionFile(
        std::make_unique<State>(State{path, options, std::move(*database), nullptr, reason, *version}));
}

SessionFile::SessionFile(std::unique_ptr<State> state) : m_state(std::move(state)) {}
SessionFile::SessionFile(SessionFile &&other) noexcept = default;
SessionFile &SessionFile::operator=(SessionFile &&other) noexcept = default;
SessionFile::~SessionFile() = default;

Result<SessionFile> SessionFile::another() const
{
    if (readOnly()) {
        auto database = openForReading(m_state->path, m_state->options.vfs);
        if (!database)
            return database.error();
        return SessionFile(
            std::make_unique<State>(State{m_state->path, m_state->options, std::move(*database), nullptr,
                                          m_state->readOnlyReason, m_state->version}));
    }
    auto database = Database::open(m_state->path, DatabaseMode::ReadWrite, m_state->options.vfs);
    if (!database)
        return database.error();
    if (Status set = database->script(kConnection); !set)
        return set.error();
    return SessionFile(std::make_unique<State>(
        State{m_state->path, m_state->options, std::move(*database), m_state->lock, {}, m_state->version}));
}

const std::filesystem::path &SessionFile::path() const
{
    return m_state->path;
}

const std::string &SessionFile::readOnlyReason() const
{
    return m_state->readOnlyReason;
}

int SessionFile::formatVersion() const
{
    return m_state->version;
}

const std::vector<RunId> &SessionFile::recovered() const
{
    return m_state->recovered;
}

const Database &SessionFile::database() const
{
    return m_state->database;
}

Status SessionFile::writable() const
{
    return readOnly() ? Status(Error{Errc::SessionReadOnly, m_state->readOnlyReason}) : Status();
}

Result<SensorIdentity> SessionFile::sensor() const
{
    Statement row = database().prepare("SELECT sensor_model, sensor_serial FROM session");
    const auto there = row.step();
    if (!there)
        return there.error();
    return *there ? SensorIdentity{row.text(0), row.text(1)} : SensorIdentity{};
}

Status SessionFile::setSensor(const SensorIdentity &sensor)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    return database().run("UPDATE session SET sensor_model = ?1, sensor_serial = ?2", sensor.model,
                          sensor.serial);
}

} // namespace driftbench
