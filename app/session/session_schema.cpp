#include "app/session/session_schema.h"

#include "app/session/overview_store.h"
#include "app/session/session_file.h"

#include <array>

namespace driftbench {

namespace {

constexpr const char *kVersion1 = R"sql(
CREATE TABLE session(
    id INTEGER PRIMARY KEY CHECK(id = 1),
    created_utc TEXT NOT NULL,
    written_by TEXT NOT NULL,
    sensor_model TEXT NOT NULL DEFAULT '',
    sensor_serial TEXT NOT NULL DEFAULT '') STRICT;

CREATE TABLE run(
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    name TEXT NOT NULL UNIQUE,
    state TEXT NOT NULL CHECK(state IN ('recording', 'interrupted', 'complete', 'importing', 'imported')),
    source TEXT NOT NULL,
    format TEXT NOT NULL,
    instance INTEGER NOT NULL,
    sensor_model TEXT NOT NULL,
    sensor_serial TEXT NOT NULL,
    simulated INTEGER NOT NULL,
    compensated INTEGER NOT NULL,
    sample_rate_hz REAL NOT NULL,
    range_dps REAL NOT NULL,
    reference_x_dps REAL NOT NULL,
    reference_y_dps REAL NOT NULL,
    reference_z_dps REAL NOT NULL,
    started_utc TEXT NOT NULL,
    ended_utc TEXT NOT NULL DEFAULT '') STRICT;

CREATE TABLE chunk(
    id INTEGER PRIMARY KEY,
    run_id INTEGER NOT NULL REFERENCES run(id) ON DELETE CASCADE,
    first_sample INTEGER NOT NULL CHECK(first_sample >= 0),
    samples INTEGER NOT NULL CHECK(samples BETWEEN 1 AND 16384),
    first_time_s REAL,
    last_time_s REAL,
    crc32 INTEGER NOT NULL,
    time BLOB NOT NULL,
    temperature BLOB NOT NULL,
    rate_x BLOB NOT NULL,
    rate_y BLOB NOT NULL,
    rate_z BLOB NOT NULL,
    UNIQUE(run_id, first_sample)) STRICT;

CREATE TABLE gap(
    id INTEGER PRIMARY KEY,
    run_id INTEGER NOT NULL REFERENCES run(id) ON DELETE CASCADE,
    before_sample INTEGER NOT NULL,
    start_s REAL,
    end_s REAL,
    lost_samples INTEGER NOT NULL,
    cause TEXT NOT NULL) STRICT;
CREATE INDEX gap_run ON gap(run_id);

CREATE TABLE exclusion(
    id INTEGER PRIMARY KEY,
    run_id INTEGER NOT NULL REFERENCES run(id) ON DELETE CASCADE,
    start_s REAL NOT NULL,
    end_s REAL NOT NULL,
    note TEXT NOT NULL) STRICT;
CREATE INDEX exclusion_run ON exclusion(run_id);

CREATE TABLE mask(
    run_id INTEGER PRIMARY KEY REFERENCES run(id) ON DELETE CASCADE,
    samples INTEGER NOT NULL) STRICT;

CREATE TABLE mask_range(
    run_id INTEGER NOT NULL REFERENCES mask(run_id) ON DELETE CASCADE,
    first_sample INTEGER NOT NULL,
    samples INTEGER NOT NULL CHECK(samples > 0),
    reasons INTEGER NOT NULL,
    PRIMARY KEY(run_id, first_sample)) STRICT, WITHOUT ROWID;

CREATE TABLE document(
    name TEXT PRIMARY KEY,
    changed_utc TEXT NOT NULL,
    text TEXT NOT NULL) STRICT;

CREATE TABLE model(
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    name TEXT NOT NULL,
    created_utc TEXT NOT NULL,
    json TEXT NOT NULL) STRICT;

CREATE TABLE model_run(
    id INTEGER PRIMARY KEY,
    model_id INTEGER NOT NULL REFERENCES model(id) ON DELETE CASCADE,
    run_id INTEGER REFERENCES run(id) ON DELETE SET NULL,
    run_name TEXT NOT NULL) STRICT;
CREATE INDEX model_run_model ON model_run(model_id);
CREATE INDEX model_run_run ON model_run(run_id);

CREATE TABLE comparison(
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    created_utc TEXT NOT NULL,
    json TEXT NOT NULL,
    recommendation TEXT NOT NULL) STRICT;

CREATE TABLE export(
    id INTEGER PRIMARY KEY,
    utc TEXT NOT NULL,
    model_id INTEGER REFERENCES model(id) ON DELETE SET NULL,
    format TEXT NOT NULL,
    path TEXT NOT NULL,
    bytes INTEGER NOT NULL,
    crc32 INTEGER NOT NULL) STRICT;
CREATE INDEX export_model ON export(model_id);

CREATE TABLE upload(
    id INTEGER PRIMARY KEY,
    utc TEXT NOT NULL,
    model_id INTEGER REFERENCES model(id) ON DELETE SET NULL,
    sensor_model TEXT NOT NULL,
    sensor_serial TEXT NOT NULL,
    device TEXT NOT NULL,
    kind TEXT NOT NULL,
    bank INTEGER NOT NULL,
    generation INTEGER NOT NULL,
    bytes INTEGER NOT NULL,
    crc32 INTEGER NOT NULL,
    verified INTEGER NOT NULL,
    activated INTEGER NOT NULL,
    outcome TEXT NOT NULL) STRICT;
CREATE INDEX upload_model ON upload(model_id);

CREATE TABLE note(
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    utc TEXT NOT NULL,
    run_id INTEGER REFERENCES run(id) ON DELETE CASCADE,
    text TEXT NOT NULL) STRICT;
CREATE INDEX note_run ON note(run_id);

CREATE TABLE event(
    id INTEGER PRIMARY KEY,
    utc TEXT NOT NULL,
    run_id INTEGER REFERENCES run(id) ON DELETE CASCADE,
    at_sample INTEGER NOT NULL,
    kind TEXT NOT NULL,
    text TEXT NOT NULL) STRICT;
CREATE INDEX event_run ON event(run_id);
)sql";

constexpr const char *kVersion2 = R"sql(
CREATE TABLE overview(
    chunk_id INTEGER PRIMARY KEY REFERENCES chunk(id) ON DELETE CASCADE,
    samples INTEGER NOT NULL CHECK(samples BETWEEN 1 AND 16384),
    crc32 INTEGER NOT NULL,
    figures BLOB NOT NULL) STRICT;
)sql";

Status toVersion1(const Database &database)
{
    return database.script(kVersion1);
}

Status toVersion2(const Database &database)
{
    if (Status made = database.script(kVersion2); !made)
        return made;
    return insertAllOverviews(database);
}

using Step = Status (*)(const Database &);
constexpr std::array<Step, kSessionFormatVersion> kSteps{toVersion1, toVersion2};

} // namespace

Status bringUpToDate(const Database &database, int fromVersion)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    for (std::size_t version = static_cast<std::size_t>(fromVersion); version < kSteps.size(); ++version) {
        if (Status taken = kSteps[version](database); !taken)
            return taken;
    }
    const std::string pragmas = "PRAGMA application_id = " + std::to_string(kSessionApplicationId) +
                                "; PRAGMA user_version = " + std::to_string(kSessionFormatVersion) + ";";
    if (Status set = database.script(pragmas); !set)
        return set;
    return transaction->commit();
}

} // namespace driftbench
